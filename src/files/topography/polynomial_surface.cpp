// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/polynomial_surface.hpp"

#include <fmt/format.h>

#include "polynomial_fit.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/legendre.hpp"

namespace setae::topography {
namespace {

using numerics::legendre_values;

[[noreturn]] void throw_undetermined(const Metadata& metadata, Index terms, const std::string& why) {
    throw UndefinedDataError(
        fmt::format("{}: {} a polynomial with {} coefficients; reduce its degree or enlarge the region",
                    label(metadata), why, terms));
}

Array2D solved(const Terms& terms, const NormalEquations& equations, const Metadata& metadata) {
    const auto solution = numerics::solved_normal_equations(equations.gram, equations.moments);
    if (!solution) throw_undetermined(metadata, terms.count(), "the points do not determine");
    return arranged(terms, *solution, equations.origin);
}

Array2D fitted_coefficients(const ArrayView2D& heights, const Mask& chosen, const Terms& terms,
                            const Metadata& metadata, parallel::Threads threads) {
    PolynomialFit fit(terms, heights.cols());
    fit.add(heights, 0, chosen.size() > 0 ? chosen.data() : nullptr, threads);
    const auto equations = fit.equations();
    if (equations.points < terms.count())
        throw_undetermined(metadata, terms.count(),
                           fmt::format("{} points with a height are too few for", equations.points));
    return solved(terms, equations, metadata);
}

/// Centre and half of the distance between first and last of n points.
std::array<double, 2> extent_of(Index n, double pixel_size) {
    const double half = 0.5 * static_cast<double>(n - 1) * pixel_size;
    return {half, n > 1 ? half : 1.0};
}

/// Mean over −1 … 1 of P_k' and P_k''.
double mean_first_derivative(Index k) { return k % 2 == 1 ? 1.0 : 0.0; }
double mean_second_derivative(Index k) { return k % 2 == 0 ? 0.5 * static_cast<double>(k * (k + 1)) : 0.0; }

void require_function(const Profile& profile) {
    for (Index i = 1; i < profile.positions.size(); ++i)
        if (!(profile.positions[i] > profile.positions[i - 1]))
            throw InvalidArgument(fmt::format(
                "{}: x does not increase at point {}; expected a function h(x); clean_contour makes one from a "
                "traced curve",
                label(profile.metadata), i));
}

}  // namespace

double PolynomialSurface::value(double x, double y) const {
    const auto in_x = legendre_values(coefficients.rows() - 1, (x - centre[0]) / half_extent[0]);
    const auto in_y = legendre_values(coefficients.cols() - 1, (y - centre[1]) / half_extent[1]);
    return (in_x.matrix().transpose() * coefficients.matrix() * in_y.matrix()).value();
}

std::array<double, 2> PolynomialSurface::mean_slope() const {
    std::array<double, 2> slope{};
    for (Index a = 0; a < coefficients.rows(); ++a)
        slope[0] += mean_first_derivative(a) * coefficients(a, 0) / half_extent[0];
    for (Index b = 0; b < coefficients.cols(); ++b)
        slope[1] += mean_first_derivative(b) * coefficients(0, b) / half_extent[1];
    return slope;
}

std::array<double, 2> PolynomialSurface::mean_curvature() const {
    std::array<double, 2> curvature{};
    for (Index a = 0; a < coefficients.rows(); ++a)
        curvature[0] += mean_second_derivative(a) * coefficients(a, 0) / (half_extent[0] * half_extent[0]);
    for (Index b = 0; b < coefficients.cols(); ++b)
        curvature[1] += mean_second_derivative(b) * coefficients(0, b) / (half_extent[1] * half_extent[1]);
    return curvature;
}

PolynomialSurface fitted_polynomial(const HeightMap& map, const PolynomialDegrees& degrees, const Mask& chosen,
                                    parallel::Threads threads) {
    const auto [nx, ny] = map.shape();
    const auto pixel = map.pixel_size();
    const auto x = extent_of(nx, pixel[0]), y = extent_of(ny, pixel[1]);
    return {fitted_coefficients(map.heights, chosen, terms_of(degrees, false), map.metadata, threads),
            {x[0], y[0]},
            {x[1], y[1]}};
}

PolynomialSurface fitted_polynomial(const LineScan& scan, const PolynomialDegrees& degrees, const Mask& chosen,
                                    parallel::Threads threads) {
    const auto x = extent_of(scan.heights.size(), scan.pixel_size());
    const Array2D along_columns =
        fitted_coefficients(Eigen::Map<const Array2D>(scan.heights.data(), 1, scan.heights.size()), chosen,
                            turned(terms_of(degrees, true)), scan.metadata, threads);
    return {along_columns.transpose(), {x[0], 0.0}, {x[1], 1.0}};
}

PolynomialSurface fitted_polynomial(const Profile& profile, const PolynomialDegrees& degrees, const Mask& chosen,
                                    parallel::Threads) {
    require_function(profile);
    const auto terms = terms_of(degrees, true);
    const PolylinePlaces places(profile);
    const auto equations = polyline_equations(profile, places, terms, chosen);
    if (!(equations.gram(0, 0) > 0.0))
        throw_undetermined(profile.metadata, terms.count(),
                           "the region has no segment with two defined points, which is too little for");
    return {solved(terms, equations, profile.metadata), {places.middle, 0.0}, {places.half, 1.0}};
}

void subtract(const PolynomialSurface& polynomial, HeightMap& map, parallel::Threads threads) {
    subtract(0.0, polynomial.coefficients, map.heights, 0, map.heights.cols(), threads);
}

void subtract(const PolynomialSurface& polynomial, LineScan& scan, parallel::Threads threads) {
    subtract(0.0, polynomial.coefficients.transpose(), Eigen::Map<Array2D>(scan.heights.data(), 1, scan.heights.size()),
             0, scan.heights.size(), threads);
}

void subtract(const PolynomialSurface& polynomial, Profile& profile, parallel::Threads) {
    const Array1D c = polynomial.coefficients.col(0);
    for (Index i = 0; i < profile.heights.size(); ++i)
        profile.heights[i] -= (c * legendre_values(c.size() - 1, (profile.positions[i] - polynomial.centre[0]) /
                                                                     polynomial.half_extent[0]))
                                  .sum();
}

}  // namespace setae::topography
