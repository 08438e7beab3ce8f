// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/mask.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// Highest degree of polynomials along a direction.
inline constexpr Index highest_degree = 12;

/// Products of powers x^a y^b of a polynomial: a + b <= total, a <= x, b <= y.
struct PolynomialDegrees {
    Index total = 2;
    Index x = highest_degree;
    Index y = highest_degree;
};

/// A polynomial in Legendre polynomials of centred, scaled coordinates, which keep the normal equations well
/// conditioned.
///
///   p(x, y) = Σ c_ab P_a(u) P_b(v),   u = (x − x_0)/X,  v = (y − y_0)/Y
///
/// (x_0, y_0): middle between first and last points [m]; X, Y: half their distance [m] (1 for one point only).
struct PolynomialSurface {
    Array2D coefficients;                         ///< c_ab [m], a the row
    std::array<double, 2> centre{};               ///< x_0, y_0 [m]
    std::array<double, 2> half_extent{1.0, 1.0};  ///< X, Y [m]

    [[nodiscard]] double value(double x, double y = 0.0) const;
    /// Mean of p over the field between first and last points [m].
    [[nodiscard]] double mean_height() const { return coefficients(0, 0); }
    /// Means of ∂p/∂x and ∂p/∂y over the field.
    [[nodiscard]] std::array<double, 2> mean_slope() const;
    /// Means of ∂²p/∂x² and ∂²p/∂y² over the field [1/m]; radii of curvature are their inverses while slopes are small.
    [[nodiscard]] std::array<double, 2> mean_curvature() const;
};

/// The best fitting polynomial by least squares over the selected defined points; all points if the mask is empty. Maps
/// and lines: sum over points. Polylines: exact integral over the segments with both ends selected.
/// @throws InvalidArgument for degrees outside 0 … 12 (total: 0 … 24), and for a polyline whose x does not increase
/// strictly (see topography/contour.hpp); UndefinedDataError if the points do not determine the polynomial. Cost for
/// maps: one pass with degree + 1 multiplications per point, for any number of coefficients.
[[nodiscard]] PolynomialSurface fitted_polynomial(const HeightMap& map, const PolynomialDegrees& degrees,
                                                  const Mask& chosen = {}, parallel::Threads threads = {});
[[nodiscard]] PolynomialSurface fitted_polynomial(const LineScan& scan, const PolynomialDegrees& degrees,
                                                  const Mask& chosen = {}, parallel::Threads threads = {});
[[nodiscard]] PolynomialSurface fitted_polynomial(const Profile& profile, const PolynomialDegrees& degrees,
                                                  const Mask& chosen = {}, parallel::Threads threads = {});

/// Heights minus the polynomial, in place.
void subtract(const PolynomialSurface& polynomial, HeightMap& map, parallel::Threads threads = {});
void subtract(const PolynomialSurface& polynomial, LineScan& scan, parallel::Threads threads = {});
void subtract(const PolynomialSurface& polynomial, Profile& profile, parallel::Threads threads = {});

}  // namespace setae::topography
