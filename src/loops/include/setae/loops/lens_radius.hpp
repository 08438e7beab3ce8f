// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {

/// A circle through or near points of an outline [m].
struct Circle {
    double centre_x = 0.0;
    double centre_y = 0.0;
    Estimate radius;
    double rms_residual = 0.0;  ///< of the distances from the circle [m]
};

/// The circle through three points; no standard error.
/// @throws InvalidArgument unless three points are given that do not lie on a line.
[[nodiscard]] Circle circle_through(const ArrayView1D& x, const ArrayView1D& y);

/// The circle with the least sum of squared distances to the points.
///
/// Starts from the algebraic fit and minimises the distances themselves; the standard error of the radius is scaled by
/// the residuals' scatter.
/// @throws UndefinedDataError for fewer than four points; InvalidArgument for points on a line or series of different
/// length.
[[nodiscard]] Circle fit_circle(const ArrayView1D& x, const ArrayView1D& y);

}  // namespace setae::loops
