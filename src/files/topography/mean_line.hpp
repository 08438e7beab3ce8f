// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "setae/core/arrays.hpp"

namespace setae::topography {

/// Distance along a polyline of each of its points from the first [m].
[[nodiscard]] Array1D lengths_along(const Array1D& x, const Array1D& y);

/// The straight line nearest to a polyline: the least integral of the squared perpendicular distance over its length.
struct MeanLine {
    Eigen::Vector2d centre;             ///< centroid of the length [m]
    double angle = 0.0;                 ///< direction of the curve, −π … π from x [rad]
    double mean_square_distance = 0.0;  ///< perpendicular, averaged over the length [m²]
    double length = 0.0;                ///< of the polyline [m]
};

/// Exact on straight segments. For a curve whose ends are farther apart across that line than along it (a steep heap)
/// the direction is that of its ends, which determines the side of vacuum.
/// @throws UndefinedDataError for a curve without length.
[[nodiscard]] MeanLine mean_line(const Array1D& x, const Array1D& y);

}  // namespace setae::topography
