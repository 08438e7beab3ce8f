// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/output/json.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/transformed_heights.hpp"

namespace setae::answers {

/// Points along x and y of "1024x512", or of "1024" for both. @throws InvalidArgument.
[[nodiscard]] std::array<Index, 2> point_counts(const std::string& text);

/// Lengths [m] along x and y of "5 um x 2 um", or of "5 um" for both. @throws InvalidArgument.
[[nodiscard]] std::array<double, 2> extents(const std::string& text);

/// What is to be made: spectrum, grid, and the window written where that is not the whole surface.
struct SynthesisPlan {
    spectra::SpectralDensity density;  ///< C_iso of a surface, C1D of a line
    synthesis::SurfaceGrid grid;       ///< of a line: nx and size_x
    synthesis::SurfaceOptions options;
    bool line = false;
    synthesis::HeightTransform heights;          ///< of their distribution; empty: Gaussian
    std::optional<std::array<Index, 2>> window;  ///< points of it, from the surface's first point on
    std::vector<Alert> alerts;                   ///< of the table its spectrum is from

    /// What the spectrum gives on the grid.
    [[nodiscard]] synthesis::ExpectedRoughness expected() const;
    [[nodiscard]] topography::Measurement make() const;
};

/// What surface or line is made, as `setae synthesize` is told.
struct SynthesisRequest {
    std::optional<double> hurst;
    std::string rolloff, short_cutoff, long_cutoff, rms_height, rms_slope, plateau, spectrum;
    std::string spectrum_unit, pixels = "1024", size, window_of;
    std::uint64_t seed = 0;
    bool line = false, exact_rms = false;
    std::string amplitudes = "gaussian";
    double stretch = 1.0, angle = 0.0;
    std::optional<double> skewness, kurtosis;

    /// @throws InvalidArgument for options that are missing, malformed or contradict each other; as the reader of
    /// spectra.
    [[nodiscard]] SynthesisPlan plan(parallel::Threads threads) const;

private:
    [[nodiscard]] spectra::SpectralDensity self_affine(const synthesis::SurfaceGrid& grid) const;
};

/// A surface or line that was made; its roughness by the spectrum and by its heights.
struct Synthesis {
    SynthesisPlan plan;
    topography::Measurement measurement;
    std::vector<Quantity> quantities;
};

/// @throws as SynthesisRequest::plan().
[[nodiscard]] Synthesis synthesis_of(const SynthesisRequest& request, parallel::Threads threads = {});

/// "output" (the file it was written to, or null), "points", "size", "periodic", "seed" and "quantities".
[[nodiscard]] output::Json to_json(const Synthesis& synthesis, const std::string& output);

}  // namespace setae::answers
