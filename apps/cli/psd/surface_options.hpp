// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "convert/pipeline_option.hpp"
#include "files/file_options.hpp"
#include "program/exit_code.hpp"
#include "program/options.hpp"
#include "setae/core/quantity.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::cli {

/// Options of the verbs that analyse files as measurements of one surface.
struct SurfaceOptions {
    FileOptions file;
    PipelineOption processing;
    std::vector<std::string> files;
    std::string instrument, tip_radius, resolution, trend, longest, shortest, window, contours, conversion;
    double memory = 2.0;  ///< GiB
    int resamples = 200;

    void add_to(Options& options);
    /// Only what says which measurements there are and how each is prepared.
    void add_measurements_to(Options& options, const char* meaning);
    /// Whether the one file is the table of a spectrum. @throws InvalidArgument for one among others.
    [[nodiscard]] bool is_spectrum() const;
    /// @throws InvalidArgument for a malformed option; as is_spectrum().
    [[nodiscard]] study::SurfaceInput surface() const;
    [[nodiscard]] study::SurfaceAnalysisOptions analysis() const;
};

/// Prints what failed; done, some failed or nothing done.
[[nodiscard]] ExitCode report_failures(const study::SurfaceResult& surface);

/// All alerts of a surface and its measurements.
[[nodiscard]] std::vector<Alert> alerts_of(const study::SurfaceResult& surface);

}  // namespace setae::cli
