// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/numerics/legendre.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "setae/core/constants.hpp"

namespace setae::numerics {

Array1D legendre_values(Index degree, double t) {
    Array1D values(degree + 1);
    values[0] = 1.0;
    if (degree > 0) values[1] = t;
    for (Index k = 1; k < degree; ++k) {
        const auto order = static_cast<double>(k);
        values[k + 1] = ((2.0 * order + 1.0) * t * values[k] - order * values[k - 1]) / (order + 1.0);
    }
    return values;
}

Array2D legendre_table(Index degree, Index n) {
    Array2D table(degree + 1, n);
    for (Index j = 0; j < n; ++j) table.col(j) = legendre_values(degree, centred(j, n));
    return table;
}

Array1D product_in_legendre(Index a, Index b) {
    // A_r = (2r − 1)!!/r!
    const auto ratio = [](Index r) {
        double value = 1.0;
        for (Index k = 1; k <= r; ++k) value *= static_cast<double>(2 * k - 1) / static_cast<double>(k);
        return value;
    };
    Array1D coefficients = Array1D::Zero(a + b + 1);
    for (Index r = 0; r <= std::min(a, b); ++r) {
        const auto twice = static_cast<double>(2 * (a + b));
        coefficients[a + b - 2 * r] = ratio(a - r) * ratio(r) * ratio(b - r) / ratio(a + b - r) *
                                      (twice - static_cast<double>(4 * r) + 1.0) /
                                      (twice - static_cast<double>(2 * r) + 1.0);
    }
    return coefficients;
}

GaussRule gauss_rule(Index n) {
    GaussRule rule;
    const auto order = static_cast<double>(n);
    for (Index i = 0; i < n; ++i) {
        double t = std::cos(pi * (static_cast<double>(i) + 0.75) / (order + 0.5)), derivative = 0.0;
        for (int iteration = 0; iteration < 20; ++iteration) {
            const auto values = legendre_values(n, t);
            derivative = order * (values[n - 1] - t * values[n]) / (1.0 - t * t);
            const double step = values[n] / derivative;
            t -= step;
            if (std::fabs(step) < 1e-16) break;
        }
        rule.nodes.push_back(t);
        rule.weights.push_back(2.0 / ((1.0 - t * t) * derivative * derivative));
    }
    return rule;
}

std::optional<Array1D> solved_normal_equations(const Array2D& gram, const Array1D& moments) {
    const Index terms = moments.size();
    Array1D scale(terms);
    for (Index k = 0; k < terms; ++k) {
        if (!(gram(k, k) > 0.0)) return std::nullopt;
        scale[k] = 1.0 / std::sqrt(gram(k, k));
    }
    const Eigen::MatrixXd scaled = scale.matrix().asDiagonal() * gram.matrix() * scale.matrix().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
    const Eigen::VectorXd& values = eigen.eigenvalues();
    if (!(values[0] > 1e-12 * values[terms - 1])) return std::nullopt;
    const Eigen::VectorXd along = eigen.eigenvectors().transpose() * (scale * moments).matrix();
    const Eigen::VectorXd solution = eigen.eigenvectors() * (along.array() / values.array()).matrix();
    return scale * solution.array();
}

double dot(const double* a, const double* b, Index n) {
    constexpr Index lanes = 8;
    double sums[lanes] = {};
    Index j = 0;
    for (; j + lanes <= n; j += lanes)
        for (Index lane = 0; lane < lanes; ++lane) sums[lane] += a[j + lane] * b[j + lane];
    for (; j < n; ++j) sums[0] += a[j] * b[j];
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

}  // namespace setae::numerics
