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
    double rms_residual = 0.0;  ///< rms of the distances from the circle [m]
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

/// The section of a surface of revolution whose radius of curvature changes away from its apex.
///
///   z = z0 ± s(x − x0),  c r² − 2 s + (1 + κ) c s² = 0,  c = 1/R;  to fourth order s = r²/(2R) + (1 + κ) r⁴/(8R³)
///
/// κ is the conic constant of optics: 0 for a sphere, -1 for a paraboloid, > 0 for an oblate spheroid.
struct Conic {
    double apex_x = 0.0, apex_z = 0.0;  ///< [m]
    Estimate radius;                    ///< radius of curvature R at the apex [m]
    Estimate conic_constant;            ///< κ
    double probability = undefined;     ///< two-sided probability of a κ at least as far from 0 for a circular section
    double departure = 0.0;     ///< deviation of the conic from the circle of its apex at the farthest point [m]
    double rms_residual = 0.0;  ///< rms of the distances from the conic [m]
};

/// The conic with the least sum of squared distances to the points, to first order in the distances.
/// @throws UndefinedDataError for fewer than six points or where no conic of an apex among the points is found;
/// InvalidArgument as fit_circle().
[[nodiscard]] Conic fit_conic(const ArrayView1D& x, const ArrayView1D& z);

}  // namespace setae::loops
