// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::roughness {

/// Statistics of the slope along one direction, with standard errors from blocks of the data (neighbouring slopes are
/// correlated, so the number of points would give too small errors).
struct DirectionalSlope {
    double angle = 0.0;  ///< direction against x [rad]: 0, π/2, ±π/4
    double rms = 0.0;    ///< sqrt⟨s²⟩ about the mean slope [1]
    double rms_standard_error = 0.0;
    double skewness = 0.0;
    double skewness_standard_error = 0.0;
    double excess_kurtosis = 0.0;  ///< 0 for a Gaussian
    double excess_kurtosis_standard_error = 0.0;
    int blocks = 0;
};

/// Test of the assumptions of Eqs. (9) and (11) on a surface.
struct SlopeDistribution {
    std::vector<DirectionalSlope> directions;  ///< maps: x, y and both diagonals; scans and polylines: x only
    Array1D slope;                             ///< centres of the histogram of slopes along x, in units of their rms
    Array1D density;                           ///< probability density times rms; a Gaussian is exp(−s²/2)/√(2π)
    double gaussian_p_value = 0.0;             ///< probability of the data if skewness and excess kurtosis of all
                                               ///< directions are 0
    double isotropy_ratio = 1.0;               ///< largest ratio of perpendicular directions; NaN for one direction
    double isotropy_p_value = 1.0;             ///< probability of the data for equal rms in all directions; NaN for one
                                               ///< direction
    std::vector<Alert> alerts;                 ///< NON_GAUSSIAN, ANISOTROPIC, ONE_DIRECTION with the size of the effect
};

/// Slopes by forward differences; diagonals over one pixel each way. Standard errors by a jackknife over 16 blocks
/// (tiles of a map, stretches of a scan). A warning needs both significance (p < 0.01) and size (|excess kurtosis| or
/// |skewness| above 0.5; rms slopes that differ by more than 10 %).
/// @throws UndefinedDataError for fewer than 32 defined slopes.
[[nodiscard]] SlopeDistribution slope_distribution(const topography::Measurement& measurement,
                                                   parallel::Threads threads = {});

/// Only SlopeDistribution::directions of a map, for any number of defined slopes.
[[nodiscard]] std::vector<DirectionalSlope> directional_slopes(const topography::HeightMap& map,
                                                               parallel::Threads threads = {});

}  // namespace setae::roughness
