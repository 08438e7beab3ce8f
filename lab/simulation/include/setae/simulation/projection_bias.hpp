// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::simulation {

/// How silhouettes are compared with line scans.
struct ProjectionOptions {
    double thickness = 0.0;  ///< of the foil [m], >= 0
    synthesis::SurfaceGrid
        grid;                 ///< of each simulated surface, periodic; as wide along y as the foil is thick or wider
    int surfaces = 16;        ///< simulated, >= 2
    int bins_per_decade = 4;  ///< of wavevectors
    numerics::RandomKey key;
    parallel::Threads threads;
};

/// A ratio and the standard error of its mean over simulated surfaces.
struct BiasFactor {
    double value = 1.0;
    double standard_error = 0.0;
};

/// Silhouettes over line scans of the same surfaces: 1 is no bias.
struct ProjectionBias {
    double thickness = 0.0;            ///< [m]
    double correlation_length = 0.0;   ///< where the line scans' autocorrelation falls to 1/e [m]
    Array1D wavevector;                ///< geometric centres of bins where lines have power [1/m]
    Array1D C1D, C1D_standard_error;   ///< factor on C1D in each bin
    BiasFactor rms_height, rms_slope;  ///< of the silhouette about its mean; slope by differences of neighbours
    double mean_height_shift = 0.0;    ///< of silhouettes over line scans, in rms heights of the line scans
};

/// What the silhouette of a foil shows of a surface with the given spectrum.
///
/// Surfaces are simulated with that C_iso; from each, silhouettes of foils side by side and every line are transformed
/// (periodic, no window), C1D averaged, the factor in a bin is the ratio of summed C1D. Sums over surfaces in fixed
/// order. A silhouette is higher and has less power at most wavevectors, as valleys behind ridges are hidden; where one
/// ridge takes over from the next it has a kink, which lines lack, so the factor rises above 1 where C1D of lines falls
/// steeply. The factors do not depend on the scale of heights, only on thickness against the spectrum's wavelengths.
/// @throws InvalidArgument as synthesis::random_surface, for fewer than two surfaces, or a foil thicker than the grid.
/// Cost: one map and its row transforms a surface.
[[nodiscard]] ProjectionBias projection_bias(const spectra::SpectralDensity& C_iso, const ProjectionOptions& options);

/// FOIL_PROJECTION: what a silhouette's spectrum, height and slope read of the truth; where the factors are all within
/// `tolerance` of 1, nothing.
[[nodiscard]] std::vector<Alert> projection_alerts(const ProjectionBias& bias, const std::string& subject,
                                                   double tolerance = 0.02);

}  // namespace setae::simulation
