// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/polynomial_surface.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "legendre.hpp"
#include "row_blocks.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Mask;
using topography::Profile;

/// Powers (a, b) of a polynomial, and the highest of each.
struct Terms {
    std::vector<std::array<Index, 2>> powers;
    Index x = 0, y = 0;

    [[nodiscard]] Index count() const { return static_cast<Index>(powers.size()); }
};

Terms terms_of(const PolynomialDegrees& degrees, bool line) {
    const auto require = [](const char* what, Index degree, Index highest) {
        if (degree < 0 || degree > highest)
            throw InvalidArgument(fmt::format("{} {} of a polynomial; expected 0 … {}", what, degree, highest));
    };
    require("degree", degrees.total, 2 * highest_degree);
    require("degree along x", degrees.x, highest_degree);
    require("degree along y", degrees.y, highest_degree);
    Terms terms;
    for (Index a = 0; a <= std::min(degrees.x, degrees.total); ++a)
        for (Index b = 0; b <= (line ? 0 : std::min(degrees.y, degrees.total - a)); ++b) {
            terms.powers.push_back({a, b});
            terms.x = std::max(terms.x, a);
            terms.y = std::max(terms.y, b);
        }
    return terms;
}

/// Σ h P_a P_b and, over the points that count, Σ P_k P_l up to twice the degrees, which every product of two terms is
/// a sum of.
struct Moments {
    Array2D heights, points;

    explicit Moments(const Terms& terms)
        : heights(Array2D::Zero(terms.x + 1, terms.y + 1)), points(Array2D::Zero(2 * terms.x + 1, 2 * terms.y + 1)) {}
};

/// Rows of equal steps, x down the rows; a line is one column's data laid in one row, with x and y exchanged.
struct Field {
    const double* heights;
    Index rows, columns;
    const std::uint8_t* chosen;  ///< or null: all
};

double first_counted(const Field& field) {
    for (Index k = 0; k < field.rows * field.columns; ++k)
        if (field.heights[k] == field.heights[k] && (!field.chosen || field.chosen[k])) return field.heights[k];
    return 0.0;
}

/// Adds rows first … last − 1 to their block's moments. A row without gaps needs no sums over points: `full` are
/// theirs.
void add_rows(const Field& field, Index first, Index last, double origin, const Array2D& table, const Array1D& full,
              const Terms& terms, Moments& moments) {
    const Index n = field.columns;
    std::vector<double> row(static_cast<std::size_t>(n)), weights(static_cast<std::size_t>(n));
    Array1D heights(terms.y + 1), points(2 * terms.y + 1);
    for (Index i = first; i < last; ++i) {
        const double* const source = field.heights + i * n;
        const std::uint8_t* const chosen = field.chosen ? field.chosen + i * n : nullptr;
        for (Index j = 0; j < n; ++j) row[static_cast<std::size_t>(j)] = source[j] - origin;
        points = full;
        heights[0] = chosen ? undefined : dot(row.data(), table.row(0).data(), n);
        if (heights[0] != heights[0]) {
            for (Index j = 0; j < n; ++j) {
                const auto k = static_cast<std::size_t>(j);
                const bool counts = source[j] == source[j] && (!chosen || chosen[j]);
                weights[k] = counts ? 1.0 : 0.0;
                if (!counts) row[k] = 0.0;
            }
            for (Index k = 0; k < points.size(); ++k) points[k] = dot(weights.data(), table.row(k).data(), n);
            heights[0] = dot(row.data(), table.row(0).data(), n);
        }
        for (Index b = 1; b < heights.size(); ++b) heights[b] = dot(row.data(), table.row(b).data(), n);
        const auto along_x = legendre_values(2 * terms.x, centred(i, field.rows));
        moments.heights += (along_x.head(terms.x + 1).matrix() * heights.matrix().transpose()).array();
        moments.points += (along_x.matrix() * points.matrix().transpose()).array();
    }
}

Moments moments_of(const Field& field, const Terms& terms, double origin, parallel::Threads threads) {
    const auto table = legendre_table(2 * terms.y, field.columns);
    const Array1D full = table.rowwise().sum();
    Moments all(terms);
    for (const auto& part : by_row_blocks(RowBlocks(field.rows, field.columns), threads, Moments(terms),
                                          [&](Index first, Index last, Moments& moments) {
                                              add_rows(field, first, last, origin, table, full, terms, moments);
                                          })) {
        all.heights += part.heights;
        all.points += part.points;
    }
    return all;
}

[[noreturn]] void throw_undetermined(const topography::Metadata& metadata, Index terms, const std::string& why) {
    throw UndefinedDataError(
        fmt::format("{}: {} a polynomial with {} coefficients; lower its degree or widen the region",
                    topography::label(metadata), why, terms));
}

/// The matrix of a polynomial's coefficients from those of its terms.
Array2D arranged(const Terms& terms, const Array1D& coefficients) {
    Array2D matrix = Array2D::Zero(terms.x + 1, terms.y + 1);
    for (Index k = 0; k < terms.count(); ++k) {
        const auto [a, b] = terms.powers[static_cast<std::size_t>(k)];
        matrix(a, b) = coefficients[k];
    }
    return matrix;
}

Array2D fitted_coefficients(const Field& field, const Terms& terms, const topography::Metadata& metadata,
                            parallel::Threads threads) {
    const double origin = first_counted(field);
    const auto moments = moments_of(field, terms, origin, threads);
    if (moments.points(0, 0) < static_cast<double>(terms.count()))
        throw_undetermined(metadata, terms.count(),
                           fmt::format("{} points with a height are too few for", moments.points(0, 0)));
    Array2D gram(terms.count(), terms.count());
    Array1D heights(terms.count());
    for (Index p = 0; p < terms.count(); ++p) {
        const auto [a, b] = terms.powers[static_cast<std::size_t>(p)];
        heights[p] = moments.heights(a, b);
        for (Index q = 0; q <= p; ++q) {
            const auto [c, d] = terms.powers[static_cast<std::size_t>(q)];
            const auto in_x = product_in_legendre(a, c), in_y = product_in_legendre(b, d);
            gram(p, q) = gram(q, p) = (in_x.matrix().transpose() *
                                       moments.points.topLeftCorner(a + c + 1, b + d + 1).matrix() * in_y.matrix())
                                          .value();
        }
    }
    const auto solution = solved_normal_equations(gram, heights);
    if (!solution) throw_undetermined(metadata, terms.count(), "the points do not determine");
    Array2D coefficients = arranged(terms, *solution);
    coefficients(0, 0) += origin;
    return coefficients;
}

/// Centre and half of the distance between first and last of n points.
std::array<double, 2> extent_of(Index n, double pixel_size) {
    const double half = 0.5 * static_cast<double>(n - 1) * pixel_size;
    return {half, n > 1 ? half : 1.0};
}

/// Terms of a line lie along the columns of its one row.
Terms turned(Terms terms) {
    for (auto& [a, b] : terms.powers) std::swap(a, b);
    std::swap(terms.x, terms.y);
    return terms;
}

const std::uint8_t* data_of(const Mask& mask) { return mask.size() > 0 ? mask.data() : nullptr; }

template <class M>
Mask chosen_points(const Region& region, const M& measurement, parallel::Threads threads) {
    return region.everything() ? Mask() : mask_of(region, measurement, threads);
}

/// heights(j) −= Σ_b c_b table(b, j).
void subtract_row(const Array1D& c, const Array2D& table, double* heights, Index n) {
    constexpr Index stretch = 512;  // stays in the nearest cache
    double values[stretch];
    for (Index first = 0; first < n; first += stretch) {
        const Index count = std::min(stretch, n - first);
        for (Index j = 0; j < count; ++j) values[j] = c[0];
        for (Index b = 1; b < c.size(); ++b) {
            const double* const basis = table.row(b).data() + first;
            for (Index j = 0; j < count; ++j) values[j] += c[b] * basis[j];
        }
        for (Index j = 0; j < count; ++j) heights[first + j] -= values[j];
    }
}

/// Mean over −1 … 1 of P_k' and P_k''.
double mean_first_derivative(Index k) { return k % 2 == 1 ? 1.0 : 0.0; }
double mean_second_derivative(Index k) { return k % 2 == 0 ? 0.5 * static_cast<double>(k * (k + 1)) : 0.0; }

void require_function(const Profile& profile) {
    for (Index i = 1; i < profile.positions.size(); ++i)
        if (!(profile.positions[i] > profile.positions[i - 1]))
            throw InvalidArgument(fmt::format(
                "{}: x does not increase at point {}; expected a function h(x): clean_contour makes one of a traced curve",
                topography::label(profile.metadata), i));
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

PolynomialSurface fitted_polynomial(const HeightMap& map, const PolynomialDegrees& degrees, const Region& region,
                                    parallel::Threads threads) {
    const auto chosen = chosen_points(region, map, threads);
    const auto [nx, ny] = map.shape();
    const auto pixel = map.pixel_size();
    const auto x = extent_of(nx, pixel[0]), y = extent_of(ny, pixel[1]);
    return {fitted_coefficients({map.heights.data(), nx, ny, data_of(chosen)}, terms_of(degrees, false), map.metadata,
                                threads),
            {x[0], y[0]},
            {x[1], y[1]}};
}

PolynomialSurface fitted_polynomial(const LineScan& scan, const PolynomialDegrees& degrees, const Region& region,
                                    parallel::Threads threads) {
    const auto chosen = chosen_points(region, scan, threads);
    const auto x = extent_of(scan.heights.size(), scan.pixel_size());
    const Array2D along_columns = fitted_coefficients({scan.heights.data(), 1, scan.heights.size(), data_of(chosen)},
                                                      turned(terms_of(degrees, true)), scan.metadata, threads);
    return {along_columns.transpose(), {x[0], 0.0}, {x[1], 1.0}};
}

PolynomialSurface fitted_polynomial(const Profile& profile, const PolynomialDegrees& degrees, const Region& region,
                                    parallel::Threads threads) {
    require_function(profile);
    const auto terms = terms_of(degrees, true);
    const auto chosen = chosen_points(region, profile, threads);
    const Index n = profile.positions.size();
    const double middle = 0.5 * (profile.positions[0] + profile.positions[n - 1]),
                 half = n > 1 ? 0.5 * profile.size() : 1.0;
    const auto counts = [&](Index i) {
        return profile.heights[i] == profile.heights[i] && (chosen.size() == 0 || chosen(i, 0));
    };
    const auto place = [&](Index i) { return (profile.positions[i] - middle) / half; };
    const auto rule = gauss_rule(terms.x + 1);
    Array2D gram = Array2D::Zero(terms.count(), terms.count());
    Array1D moments = Array1D::Zero(terms.count());
    double origin = undefined;
    for (Index i = 0; i + 1 < n; ++i) {
        if (!counts(i) || !counts(i + 1)) continue;
        if (origin != origin) origin = profile.heights[i];
        const double from = place(i), length = place(i + 1) - from, height = profile.heights[i] - origin,
                     rise = profile.heights[i + 1] - profile.heights[i];
        for (std::size_t g = 0; g < rule.nodes.size(); ++g) {
            const double s = 0.5 * (1.0 + rule.nodes[g]), weight = rule.weights[g] * length;
            const auto basis = legendre_values(terms.x, from + s * length);
            gram += weight * (basis.matrix() * basis.matrix().transpose()).array();
            moments += weight * (height + s * rise) * basis;
        }
    }
    if (origin != origin)
        throw_undetermined(profile.metadata, terms.count(), "no segment has two points that count; it has no");
    const auto solution = solved_normal_equations(gram, moments);
    if (!solution) throw_undetermined(profile.metadata, terms.count(), "the points do not determine");
    Array2D coefficients = arranged(terms, *solution);
    coefficients(0, 0) += origin;
    return {coefficients, {middle, 0.0}, {half, 1.0}};
}

void subtract(const PolynomialSurface& polynomial, HeightMap& map, parallel::Threads threads) {
    const auto [nx, ny] = map.shape();
    const auto table = legendre_table(polynomial.coefficients.cols() - 1, ny);
    for_each_row(nx, ny, threads, [&, rows = nx, columns = ny](Index i) {
        const Array1D c = (legendre_values(polynomial.coefficients.rows() - 1, centred(i, rows)).matrix().transpose() *
                           polynomial.coefficients.matrix())
                              .transpose()
                              .array();
        subtract_row(c, table, map.heights.data() + i * columns, columns);
    });
}

void subtract(const PolynomialSurface& polynomial, LineScan& scan, parallel::Threads) {
    const Array1D c = polynomial.coefficients.col(0);
    subtract_row(c, legendre_table(c.size() - 1, scan.heights.size()), scan.heights.data(), scan.heights.size());
}

void subtract(const PolynomialSurface& polynomial, Profile& profile, parallel::Threads) {
    const Array1D c = polynomial.coefficients.col(0);
    for (Index i = 0; i < profile.heights.size(); ++i)
        profile.heights[i] -= (c * legendre_values(c.size() - 1, (profile.positions[i] - polynomial.centre[0]) /
                                                                     polynomial.half_extent[0]))
                                  .sum();
}

}  // namespace setae::processing
