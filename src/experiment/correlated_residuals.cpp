// SPDX-License-Identifier: GPL-3.0-or-later
#include "correlated_residuals.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "setae/core/constants.hpp"

namespace setae::experiment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A stationary process x_i = Σ a_j x_(i−j) + noise.
struct Autoregression {
    VectorXd coefficients;  ///< a_1 … a_q
    VectorXd correlation;   ///< ρ_0 … ρ_q
};

/// Levinson's recursion through the orders; the one of least corrected Akaike information.
Autoregression autoregression(const VectorXd& covariances, Index samples) {
    constexpr double largest_reflection = 0.995;  // keeps the process stationary
    const auto n = static_cast<double>(samples);
    const Index most = covariances.size() - 1;
    VectorXd coefficients(0), correlation = VectorXd::Zero(most + 1);
    correlation[0] = 1.0;
    Autoregression best{coefficients, correlation.head(1)};
    double innovation = 1.0, least = 0.0;
    for (Index m = 1; m <= most; ++m) {
        double reflection = covariances[m] / covariances[0], known = 0.0;
        for (Index j = 1; j < m; ++j) known += coefficients[j - 1] * correlation[m - j];
        reflection = std::clamp((reflection - known) / innovation, -largest_reflection, largest_reflection);
        correlation[m] = known + reflection * innovation;
        VectorXd next(m);
        for (Index j = 1; j < m; ++j) next[j - 1] = coefficients[j - 1] - reflection * coefficients[m - j - 1];
        next[m - 1] = reflection;
        coefficients = std::move(next);
        innovation *= 1.0 - reflection * reflection;
        const double order = static_cast<double>(m);
        const double information = n * std::log(innovation) + 2.0 * order * n / (n - order - 2.0);
        if (information >= least) continue;
        least = information;
        best = {coefficients, correlation.head(m + 1)};
    }
    return best;
}

/// Σ_(j <= i) ρ_(i−j) x_j as a recursive filter: ρ follows the process's own recursion beyond its order.
VectorXd from_the_past(const Autoregression& process, const VectorXd& values) {
    const Index order = process.coefficients.size();
    VectorXd gains = process.correlation;
    for (Index k = 1; k <= order; ++k)
        for (Index j = 1; j <= k; ++j) gains[k] -= process.coefficients[j - 1] * process.correlation[k - j];
    VectorXd sums(values.size());
    for (Index i = 0; i < values.size(); ++i) {
        double sum = gains[0] * values[i];
        for (Index k = 1; k <= std::min(order, i); ++k) sum += gains[k] * values[i - k] + process.coefficients[k - 1] * sums[i - k];
        sums[i] = sum;
    }
    return sums;
}

/// Ω x of every column.
MatrixXd correlated(const Autoregression& process, const MatrixXd& columns) {
    MatrixXd result(columns.rows(), columns.cols());
    for (Index c = 0; c < columns.cols(); ++c) {
        const VectorXd values = columns.col(c);
        result.col(c) = from_the_past(process, values) + from_the_past(process, values.reverse()).reverse() - values;
    }
    return result;
}

VectorXd autocovariances(const VectorXd& residuals, Index most) {
    const Index n = residuals.size();
    VectorXd result(most + 1);
    for (Index k = 0; k <= most; ++k) result[k] = residuals.head(n - k).dot(residuals.tail(n - k)) / static_cast<double>(n);
    return result;
}

/// ρ_0 … ρ_most of the process.
VectorXd correlations(const Autoregression& process, Index most) {
    const Index order = process.coefficients.size();
    VectorXd result = VectorXd::Zero(most + 1);
    for (Index k = 0; k <= most; ++k) {
        if (k <= order) result[k] = process.correlation[k];
        for (Index j = 1; k > order && j <= order; ++j) result[k] += process.coefficients[j - 1] * result[k - j];
    }
    return result;
}

/// Autocovariances that residuals of a process of unit variance have on average, (1 − H)Ω(1 − H) along its diagonals.
VectorXd expected_autocovariances(const MatrixXd& basis, const MatrixXd& spread, const VectorXd& correlation) {
    const Index n = basis.rows();
    const MatrixXd twice = basis * (basis.transpose() * spread);
    VectorXd result(correlation.size());
    for (Index k = 0; k < result.size(); ++k) {
        const auto along = [&](const MatrixXd& left, const MatrixXd& right) { return left.topRows(n - k).cwiseProduct(right.bottomRows(n - k)).sum(); };
        const double taken = along(basis, spread) + along(spread, basis) - along(twice, basis);
        result[k] = (static_cast<double>(n - k) * correlation[k] - taken) / static_cast<double>(n);
    }
    return result;
}

/// The process behind residuals of a fit with the orthonormal basis of its Jacobian.
Autoregression process_of(const VectorXd& residuals, const MatrixXd& basis) {
    const Index n = residuals.size(), most = std::min<Index>(10, n / 8);
    const VectorXd found = autocovariances(residuals, most);
    const VectorXd shares = VectorXd::LinSpaced(most + 1, static_cast<double>(n), static_cast<double>(n - most)) / static_cast<double>(n);
    auto process = autoregression(found, n);
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        const VectorXd correlation = correlations(process, most);
        const VectorXd expected = expected_autocovariances(basis, correlated(process, basis), correlation);
        const double variance = found[0] / expected[0];
        const VectorXd corrected = found + variance * (correlation.cwiseProduct(shares) - expected);
        process = autoregression(corrected, n);
    }
    return process;
}

double correlated_samples(const Autoregression& process, Index samples) {
    const VectorXd correlation = correlations(process, samples - 1);
    double sum = 1.0;
    for (Index k = 1; k < samples; ++k) sum += 2.0 * (1.0 - static_cast<double>(k) / static_cast<double>(samples)) * correlation[k];
    return std::max(1.0, sum);
}

}  // namespace

FitCovariance correlated_covariance(const MatrixXd& jacobian, const VectorXd& residuals) {
    const Index n = jacobian.rows(), p = jacobian.cols();
    FitCovariance result{.covariance = MatrixXd::Constant(p, p, undefined)};
    if (n <= p) return result;
    // columns of unit length keep the inverse well conditioned
    const VectorXd inverse_lengths = jacobian.colwise().norm().cwiseInverse();
    if (!inverse_lengths.allFinite() || !residuals.allFinite()) return result;
    const MatrixXd unit = jacobian * inverse_lengths.asDiagonal();
    const Eigen::FullPivLU<MatrixXd> normal(unit.transpose() * unit);
    if (!normal.isInvertible()) return result;
    const MatrixXd inverse = normal.inverse();
    const double squares = residuals.squaredNorm();
    MatrixXd middle = unit.transpose() * unit;
    double left = static_cast<double>(n - p);
    if (squares > 0.0) {
        const Eigen::HouseholderQR<MatrixXd> decomposition(unit);
        const MatrixXd basis = decomposition.householderQ() * MatrixXd::Identity(n, p);
        const auto process = process_of(residuals, basis);
        if (process.coefficients.size() > 0) {
            middle = unit.transpose() * correlated(process, unit);
            left = static_cast<double>(n) - (inverse * middle).trace();
            result.correlated_samples = correlated_samples(process, n);
        }
    }
    if (!(left > 0.0)) return result;
    result.degrees_of_freedom = std::max(1.0, static_cast<double>(n) / result.correlated_samples - static_cast<double>(p));
    result.covariance = inverse_lengths.asDiagonal() * (squares / left * inverse * middle * inverse) * inverse_lengths.asDiagonal();
    return result;
}

}  // namespace setae::experiment
