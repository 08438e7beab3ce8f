// SPDX-License-Identifier: GPL-3.0-or-later
#include "polynomial_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/legendre.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::topography {
namespace {

using numerics::centred;
using numerics::dot;

std::optional<double> first_counted(const ArrayView2D& band, const std::uint8_t* chosen) {
    for (Index i = 0; i < band.rows(); ++i)
        for (Index j = 0; j < band.cols(); ++j)
            if (band(i, j) == band(i, j) && (!chosen || chosen[i * band.cols() + j])) return band(i, j);
    return std::nullopt;
}

/// Σ h P_a P_b and Σ P_k P_l of some rows.
struct Moments {
    Array2D heights, points;
};

}  // namespace

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

Terms turned(Terms terms) {
    for (auto& [a, b] : terms.powers) std::swap(a, b);
    std::swap(terms.x, terms.y);
    return terms;
}

Array2D arranged(const Terms& terms, const Array1D& solution, double origin) {
    Array2D matrix = Array2D::Zero(terms.x + 1, terms.y + 1);
    for (Index k = 0; k < terms.count(); ++k) {
        const auto [a, b] = terms.powers[static_cast<std::size_t>(k)];
        matrix(a, b) = solution[k];
    }
    matrix(0, 0) += origin;
    return matrix;
}

PolynomialFit::PolynomialFit(Terms terms, Index ny)
    : terms_(std::move(terms)),
      table_(numerics::legendre_table(2 * terms_.y, ny)),
      heights_(Array2D::Zero(terms_.x + 1, terms_.y + 1)),
      points_(Array2D::Zero(2 * terms_.x + 1, 2 * terms_.y + 1)) {}

void PolynomialFit::add(const ArrayView2D& band, Index first, const std::uint8_t* chosen, parallel::Threads threads) {
    if (!origin_) origin_ = first_counted(band, chosen);
    if (!origin_) return;
    const Index n = band.cols();
    // a row without gaps needs no sums over points
    const Array1D full = table_.middleCols(first, n).rowwise().sum();
    const auto basis = [&](Index k) { return table_.row(k).data() + first; };
    const auto add_rows = [&](Index begin, Index end, Moments& moments) {
        std::vector<double> row(static_cast<std::size_t>(n)), weights(static_cast<std::size_t>(n));
        Array1D heights(terms_.y + 1), points;
        for (Index i = begin; i < end; ++i) {
            const double* const source = band.row(i).data();
            const std::uint8_t* const counted = chosen ? chosen + i * n : nullptr;
            for (Index j = 0; j < n; ++j) row[static_cast<std::size_t>(j)] = source[j] - *origin_;
            points = full;
            heights[0] = counted ? undefined : dot(row.data(), basis(0), n);
            if (std::isnan(heights[0])) {
                for (Index j = 0; j < n; ++j) {
                    const auto k = static_cast<std::size_t>(j);
                    const bool counts = !std::isnan(source[j]) && (!counted || counted[j]);
                    weights[k] = counts ? 1.0 : 0.0;
                    if (!counts) row[k] = 0.0;
                }
                for (Index k = 0; k < points.size(); ++k) points[k] = dot(weights.data(), basis(k), n);
                heights[0] = dot(row.data(), basis(0), n);
            }
            for (Index b = 1; b < heights.size(); ++b) heights[b] = dot(row.data(), basis(b), n);
            const auto along_x = numerics::legendre_values(2 * terms_.x, centred(i, band.rows()));
            moments.heights += (along_x.head(terms_.x + 1).matrix() * heights.matrix().transpose()).array();
            moments.points += (along_x.matrix() * points.matrix().transpose()).array();
        }
    };
    const Moments none{Array2D::Zero(heights_.rows(), heights_.cols()), Array2D::Zero(points_.rows(), points_.cols())};
    for (const auto& part : numerics::by_row_blocks(numerics::RowBlocks(band.rows(), n), threads, none, add_rows)) {
        heights_ += part.heights;
        points_ += part.points;
    }
}

NormalEquations PolynomialFit::equations() const {
    const Index count = terms_.count();
    NormalEquations equations{Array2D(count, count), Array1D(count), origin_.value_or(0.0),
                              static_cast<Index>(points_(0, 0))};
    for (Index p = 0; p < count; ++p) {
        const auto [a, b] = terms_.powers[static_cast<std::size_t>(p)];
        equations.moments[p] = heights_(a, b);
        for (Index q = 0; q <= p; ++q) {
            const auto [c, d] = terms_.powers[static_cast<std::size_t>(q)];
            const auto in_x = numerics::product_in_legendre(a, c), in_y = numerics::product_in_legendre(b, d);
            equations.gram(p, q) = equations.gram(q, p) =
                (in_x.matrix().transpose() * points_.topLeftCorner(a + c + 1, b + d + 1).matrix() * in_y.matrix())
                    .value();
        }
    }
    return equations;
}

PolylinePlaces::PolylinePlaces(const Profile& profile)
    : middle(0.5 * (profile.positions[0] + profile.positions[profile.positions.size() - 1])),
      half(profile.positions.size() > 1 ? 0.5 * profile.size() : 1.0),
      u((profile.positions - middle) / half) {}

NormalEquations polyline_equations(const Profile& profile, const PolylinePlaces& places, const Terms& terms,
                                   const Mask& chosen) {
    const Index count = terms.count(), n = places.u.size();
    const auto counts = [&](Index i) {
        return !std::isnan(profile.heights[i]) && (chosen.size() == 0 || chosen(i, 0));
    };
    const auto rule = numerics::gauss_rule(terms.x + 1);
    NormalEquations equations{Array2D::Zero(count, count), Array1D::Zero(count)};
    for (Index i = 0; i < n; ++i) {
        if (!counts(i)) continue;
        if (equations.points++ == 0) equations.origin = profile.heights[i];
        if (i + 1 == n || !counts(i + 1)) continue;
        const double from = places.u[i], length = places.u[i + 1] - from,
                     height = profile.heights[i] - equations.origin, rise = profile.heights[i + 1] - profile.heights[i];
        for (std::size_t g = 0; g < rule.nodes.size(); ++g) {
            const double s = 0.5 * (1.0 + rule.nodes[g]), weight = rule.weights[g] * length;
            const auto basis = numerics::legendre_values(terms.x, from + s * length);
            equations.gram += weight * (basis.matrix() * basis.matrix().transpose()).array();
            equations.moments += weight * (height + s * rise) * basis;
        }
    }
    return equations;
}

PolynomialRows::PolynomialRows(double origin, Array2D coefficients, Index rows, Index ny)
    : origin_(origin),
      coefficients_(std::move(coefficients)),
      table_(numerics::legendre_table(coefficients_.cols() - 1, ny)),
      rows_(rows) {}

void PolynomialRows::take_from(Index i, Index first, const double* heights, double* rest, Index n) const {
    const auto along_x = numerics::legendre_values(coefficients_.rows() - 1, centred(i, rows_));
    const Array1D c = (along_x.matrix().transpose() * coefficients_.matrix()).transpose().array();
    constexpr Index stretch = 512;  // remains in the nearest cache
    double values[stretch];
    for (Index begin = 0; begin < n; begin += stretch) {
        const Index count = std::min(stretch, n - begin);
        for (Index j = 0; j < count; ++j) values[j] = c[0];
        for (Index b = 1; b < c.size(); ++b) {
            const double* const basis = table_.row(b).data() + first + begin;
            for (Index j = 0; j < count; ++j) values[j] += c[b] * basis[j];
        }
        for (Index j = 0; j < count; ++j) rest[begin + j] = (heights[begin + j] - origin_) - values[j];
    }
}

void subtract(double origin, const Array2D& coefficients, Eigen::Ref<Array2D> band, Index first, Index ny,
              parallel::Threads threads) {
    const PolynomialRows polynomial(origin, coefficients, band.rows(), ny);
    numerics::for_each_row(band.rows(), band.cols(), threads, [&](Index i) {
        polynomial.take_from(i, first, band.row(i).data(), band.row(i).data(), band.cols());
    });
}

}  // namespace setae::topography
