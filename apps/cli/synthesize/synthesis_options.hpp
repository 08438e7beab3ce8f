// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "program/options.hpp"
#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/transformed_heights.hpp"

namespace setae::cli {

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

/// Options of verbs that make surfaces.
struct SynthesisOptions {
    std::optional<double> hurst;
    std::string rolloff, short_cutoff, long_cutoff, rms_height, rms_slope, plateau, spectrum;
    std::string spectrum_unit, pixels = "1024", size, window_of;
    std::uint64_t seed = 0;
    bool line = false, exact_rms = false;
    std::string amplitudes = "gaussian";
    double stretch = 1.0, angle = 0.0;
    std::optional<double> skewness, kurtosis;

    void add_to(Options& options);
    /// @throws InvalidArgument for options that are missing, malformed or contradict each other; as the reader of
    /// spectra.
    [[nodiscard]] SynthesisPlan plan(parallel::Threads threads) const;

private:
    [[nodiscard]] spectra::SpectralDensity self_affine(const synthesis::SurfaceGrid& grid) const;
};

}  // namespace setae::cli
