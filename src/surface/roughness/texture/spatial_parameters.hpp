// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// Length and direction of the correlation of heights.
///
///   f(t) = ⟨z(x) z(x + t)⟩/⟨z²⟩ over the pairs of defined points a lag t apart, z about the mean
///   Sal = min |t|, f(t) <= s;  Str = Sal/max |t| on the rim of the part around t = 0 where f > s, s = 0.2
///   Std: the lay runs across the waves with the largest angular spectrum ∫ q C2D(q, θ) dq
///
/// Lags over the full circle. The rim is found between points by cubic interpolation and its extremes by a parabola
/// through the adjacent points. For the angular spectrum, maps that are not periodic have a Hann window in both
/// directions; undefined points are replaced by the mean. The direction is that at which power weighted by cos² within
/// ±20° is largest. Source: ISO 25178-2:2021, 4.3.
struct SpatialParameters {
    double Sal = 0.0;  ///< [m]; NaN if f is above s everywhere
    double Str = 0.0;  ///< [1], 0 … 1; NaN if the part around 0 reaches the largest lags
    double Std = 0.0;  ///< direction of the lay against x [rad], 0 <= Std < π, perpendicular to the strongest waves
    double longest = 0.0;         ///< max |t| on the rim [m]
    double directionality = 0.0;  ///< largest over mean angular spectrum; near 1 without a preferred direction
    /// ∫ f² d²t, ∫ f³ d²t and ∫ f⁴ d²t over lags up to twice the longest [m²]; NaN if Str is. For Gaussian heights on
    /// an area A they give the standard errors Sq sqrt(∫f²/(2A)), Sa sqrt(∫f²/(2A)), Ssk: sqrt(6 ∫f³/A), Sku: sqrt(24
    /// ∫f⁴/A).
    std::array<double, 3> correlation_areas{};
    std::vector<Alert> alerts;  ///< SAL_UNDEFINED, STR_UNDEFINED, STD_WITHOUT_DIRECTION
};

struct SpatialOptions {
    double threshold = 0.2;  ///< s
};

/// Shortest lag at which the f of a line falls to the threshold: Ral of ISO 21920-2:2021, 4.3.2 [m]; NaN if it does
/// not.
/// @throws UndefinedDataError for a constant line; InvalidArgument for a threshold outside (0, 1).
[[nodiscard]] double autocorrelation_length(const topography::LineScan& scan, const SpatialOptions& options = {});

/// @throws UndefinedDataError for a constant map; InvalidArgument for a threshold outside (0, 1). Cost: two transforms
/// of the map padded to twice its size (one for periodic ones), O(n log n).
[[nodiscard]] SpatialParameters spatial_parameters(const topography::HeightMap& map, const SpatialOptions& options = {},
                                                   parallel::Threads threads = {});

}  // namespace setae::texture
