// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "pipeline_option.hpp"
#include "session.hpp"
#include "setae/workflow/surface_analysis.hpp"

namespace setae::cli {

/// Options of the verbs that analyse files as measurements of one surface.
struct SurfaceOptions {
    FileOptions file;
    PipelineOption processing;
    std::vector<std::string> files;
    std::string instrument, tip_radius, resolution, trend, longest, shortest, window, contours, conversion;
    int resamples = 200;

    void add_to(CLI::App& verb);
    /// @throws InvalidArgument for a malformed option.
    [[nodiscard]] workflow::SurfaceInput surface() const;
    [[nodiscard]] workflow::AnalysisOptions analysis() const;
};

/// The measurement if it is one single map: then C_iso and stored energy come from its transform.
[[nodiscard]] std::optional<topography::HeightMap> single_map(const workflow::SurfaceInput& input);

/// C_iso of a map by transform.
[[nodiscard]] roughness::SpectrumCurve isotropic_curve(const topography::HeightMap& map, const workflow::AnalysisOptions& options, parallel::Threads threads);

/// Prints what failed; done, some failed or nothing done.
[[nodiscard]] ExitCode report_failures(const workflow::SurfaceResult& surface);

/// All alerts of a surface and its measurements.
[[nodiscard]] std::vector<Alert> alerts_of(const workflow::SurfaceResult& surface);

}  // namespace setae::cli
