// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_polynomial.hpp"

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/legendre.hpp"
#include "setae/topography/polynomial_surface.hpp"

namespace setae::processing {
namespace {

using numerics::dot;
using numerics::legendre_table;
using numerics::product_in_legendre;
using numerics::solved_normal_equations;
using topography::highest_degree;

/// Normal equations from Σ P_k over the used points.
Array2D gram_of(const Array1D& sums, Index degree) {
    Array2D gram(degree + 1, degree + 1);
    for (Index a = 0; a <= degree; ++a)
        for (Index b = 0; b <= a; ++b)
            gram(a, b) = gram(b, a) = (product_in_legendre(a, b) * sums.head(a + b + 1)).sum();
    return gram;
}

Index required_degree(Index degree) {
    if (degree < 0 || degree > highest_degree)
        throw InvalidArgument(
            fmt::format("degree {} of the polynomial of a line; expected 0 … {}", degree, highest_degree));
    return degree;
}

}  // namespace

LinePolynomial::LinePolynomial(Index degree, Index points)
    : degree_(required_degree(degree)), table_(legendre_table(2 * degree, points)) {
    const auto gram = gram_of(table_.rowwise().sum(), degree);
    Array2D inverse(degree + 1, degree + 1);
    for (Index k = 0; k <= degree; ++k) {
        const auto column = points > degree
                                ? solved_normal_equations(gram, Eigen::VectorXd::Unit(degree + 1, k).array())
                                : std::nullopt;
        if (!column) return;
        inverse.col(k) = *column;
    }
    inverse_ = inverse;
}

std::optional<Array1D> LinePolynomial::fitted(LineBand& band, Index line) const {
    const Index n = band.points;
    std::vector<double> heights(static_cast<std::size_t>(n)), weights(static_cast<std::size_t>(n));
    double origin = undefined;
    Index counted = 0;
    for (Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const bool counts = band.counts(line, i);
        const double height = band.line(line)[i];
        if (counts && counted++ == 0) origin = height;
        weights[k] = counts ? 1.0 : 0.0;
        heights[k] = counts ? height - origin : 0.0;
    }
    if (counted <= degree_) return std::nullopt;
    Array1D moments(degree_ + 1);
    for (Index k = 0; k <= degree_; ++k) moments[k] = dot(heights.data(), table_.row(k).data(), n);
    std::optional<Array1D> coefficients;
    if (counted == n) {
        if (inverse_) coefficients = (inverse_->matrix() * moments.matrix()).array();
    } else {
        Array1D sums(table_.rows());
        for (Index k = 0; k < sums.size(); ++k) sums[k] = dot(weights.data(), table_.row(k).data(), n);
        coefficients = solved_normal_equations(gram_of(sums, degree_), moments);
    }
    if (coefficients) (*coefficients)[0] += origin;
    return coefficients;
}

void LinePolynomial::subtract(const Array1D& coefficients, double* heights) const {
    for (Index i = 0; i < table_.cols(); ++i) {
        double value = coefficients[0];
        for (Index k = 1; k <= degree_; ++k) value += coefficients[k] * table_(k, i);
        heights[i] -= value;
    }
}

}  // namespace setae::processing
