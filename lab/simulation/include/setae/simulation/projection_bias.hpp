// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::simulation {

/// Comparison of silhouettes with line scans.
struct ProjectionOptions {
    double thickness = 0.0;  ///< thickness of the foil [m], >= 0
    synthesis::SurfaceGrid
        grid;           ///< grid of each simulated surface, periodic; as wide along y as the foil is thick or wider
    int surfaces = 16;  ///< number of simulated surfaces, >= 2
    int bins_per_decade = 4;  ///< bins of wavevectors
    numerics::RandomKey key;
    parallel::Threads threads;
};

/// A ratio and the standard error of its mean over simulated surfaces.
struct BiasFactor {
    double value = 1.0;
    double standard_error = 0.0;
};

/// Silhouettes divided by line scans of the same surfaces: 1 without bias.
struct ProjectionBias {
    double thickness = 0.0;           ///< [m]
    double correlation_length = 0.0;  ///< distance at which the autocorrelation of line scans falls to 1/e [m]
    Array1D wavevector;               ///< geometric centres of bins in which lines have power [1/m]
    Array1D C1D, C1D_standard_error;  ///< factor on C1D in each bin
    /// rms height of the silhouette about its mean; rms slope from differences of neighbours
    BiasFactor rms_height, rms_slope;
    /// mean height of silhouettes minus that of line scans, in rms heights of the line scans
    double mean_height_shift = 0.0;
};

/// Bias of the silhouette of a foil for a surface with the given spectrum.
///
/// Surfaces are simulated with that C_iso; from each, silhouettes of adjacent foils and every line are transformed
/// (periodic, no window), C1D averaged; the factor in a bin is the ratio of summed C1D. Sums over surfaces have a fixed
/// order. A silhouette is higher and has less power at most wavevectors, because ridges hide valleys; at the transition
/// between two ridges it has a kink, which lines lack, so the factor is above 1 where C1D of lines falls steeply. The
/// factors do not depend on the scale of heights, only on thickness divided by the wavelengths of the spectrum. @throws
/// InvalidArgument as synthesis::random_surface, for fewer than two surfaces, or a foil thicker than the grid. Cost:
/// one map and its row transforms per surface.
[[nodiscard]] ProjectionBias projection_bias(const spectra::SpectralDensity& C_iso, const ProjectionOptions& options);

/// FOIL_PROJECTION: spectrum, height and slope of a silhouette relative to the true values; empty where all factors are
/// within `tolerance` of 1.
[[nodiscard]] std::vector<Alert> projection_alerts(const ProjectionBias& bias, const std::string& subject,
                                                   double tolerance = 0.02);

}  // namespace setae::simulation
