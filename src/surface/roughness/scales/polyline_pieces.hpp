// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "setae/topography/measurement.hpp"

namespace setae::scales {

/// Throws as validate() for a polyline, and UndefinedDataError for an undefined height.
void require_polyline(const topography::Profile& profile);

/// A term w h(x + offset) of a difference.
struct Shift {
    double offset = 0.0;  ///< [m]
    double weight = 0.0;
};

/// Integrals of a piecewise linear function g over x, about an origin g0: ∫ (g − g0)^k dx, and its range.
struct PieceMoments {
    double length = 0.0;               ///< [m]
    double origin = 0.0;               ///< g0
    double moments[4] = {0, 0, 0, 0};  ///< k = 1 … 4
    double minimum = 0.0, maximum = 0.0;
};

/// Exact moments of g(x) = Σ_s w_s h(x + offset_s), Σ w = 0, over every x with all x + offset_s on the polyline.
///
/// The breakpoints of all shifted copies are merged: O(points · shifts). Length 0 if the stencil is longer than the
/// polyline.
[[nodiscard]] PieceMoments difference_moments(const topography::Profile& profile, std::span<const Shift> shifts);

/// The 10^(b/n) m from `shortest` to below `longest` [m].
[[nodiscard]] Array1D distances_on_grid(int per_decade, double shortest, double longest);

}  // namespace setae::scales
