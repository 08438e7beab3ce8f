// SPDX-License-Identifier: GPL-3.0-or-later
#include "correlated_residuals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/Core>

#include "setae/core/constants.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
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

/// Ω x of every column: Σ_(j <= i) ρ_(i−j) x_j as a recursive filter from both ends, ρ following the process's own
/// recursion beyond its order. All columns and both directions run side by side: each waits for its last value.
template <int columns>
MatrixXd correlated(const Autoregression& process, const MatrixXd& values) {
    const Index order = process.coefficients.size(), n = values.rows();
    VectorXd gains = process.correlation;
    for (Index k = 1; k <= order; ++k)
        for (Index j = 1; j <= k; ++j) gains[k] -= process.coefficients[j - 1] * process.correlation[k - j];
    MatrixXd forward(n, columns), backward(n, columns);
    for (Index i = 0; i < n; ++i) {
        const Index known = std::min(order, i), last = n - 1 - i;
        std::array<double, columns> ahead, behind;
        for (int c = 0; c < columns; ++c) {
            ahead[c] = gains[0] * values(i, c);
            behind[c] = gains[0] * values(last, c);
        }
        for (Index k = 1; k <= known; ++k) {
            const double gain = gains[k], coefficient = process.coefficients[k - 1];
            for (int c = 0; c < columns; ++c) {
                ahead[c] += gain * values(i - k, c) + coefficient * forward(i - k, c);
                behind[c] += gain * values(last + k, c) + coefficient * backward(last + k, c);
            }
        }
        for (int c = 0; c < columns; ++c) {
            forward(i, c) = ahead[c];
            backward(last, c) = behind[c];
        }
    }
    return forward + backward - values;
}

MatrixXd correlated(const Autoregression& process, const MatrixXd& values) {
    if (values.cols() == 3) return correlated<3>(process, values);
    if (values.cols() == 2) return correlated<2>(process, values);
    MatrixXd result(values.rows(), values.cols());
    for (Index c = 0; c < values.cols(); ++c) result.col(c) = correlated<1>(process, values.col(c));
    return result;
}

/// Products of two or three long columns each, without the packing of large matrices.
MatrixXd gram(const MatrixXd& left, const MatrixXd& right) {
    MatrixXd result(left.cols(), right.cols());
    for (Index i = 0; i < left.cols(); ++i)
        for (Index j = 0; j < right.cols(); ++j) result(i, j) = left.col(i).dot(right.col(j));
    return result;
}

/// Long columns turned by a small matrix.
MatrixXd turned(const MatrixXd& columns, const MatrixXd& by) {
    MatrixXd result(columns.rows(), by.cols());
    for (Index j = 0; j < by.cols(); ++j) {
        result.col(j) = columns.col(0) * by(0, j);
        for (Index i = 1; i < by.rows(); ++i) result.col(j) += columns.col(i) * by(i, j);
    }
    return result;
}

VectorXd autocovariances(const VectorXd& residuals, Index most) {
    const Index n = residuals.size();
    VectorXd result(most + 1);
    for (Index k = 0; k <= most; ++k)
        result[k] = residuals.head(n - k).dot(residuals.tail(n - k)) / static_cast<double>(n);
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

double correlated_samples(const Autoregression& process, Index samples) {
    const VectorXd correlation = correlations(process, samples - 1);
    double sum = 1.0;
    for (Index k = 1; k < samples; ++k)
        sum += 2.0 * (1.0 - static_cast<double>(k) / static_cast<double>(samples)) * correlation[k];
    return std::max(1.0, sum);
}

/// One series of residuals, its part of the Jacobian's orthonormal basis B and its process.
struct Series {
    const VectorXd* residuals = nullptr;
    MatrixXd basis;
    VectorXd found;  ///< autocovariances
    Autoregression process;
    MatrixXd spread;     ///< ΩB
    MatrixXd projected;  ///< BᵀΩB
    MatrixXd shared;     ///< BᵀB
    double variance = 0.0;

    void spread_basis() {
        spread = process.coefficients.size() > 0 ? correlated(process, basis) : basis;
        projected = gram(basis, spread);
    }

    /// Autocovariances that residuals of a process of unit variance have on average, (1 − H)Ω(1 − H) along its
    /// diagonals; `all` is BᵀΩB of all series.
    [[nodiscard]] VectorXd expected(const VectorXd& correlation, const MatrixXd& all) const {
        const Index n = basis.rows(), p = basis.cols();
        const MatrixXd left = spread - turned(basis, all);
        VectorXd result(correlation.size());
        for (Index k = 0; k < result.size(); ++k) {
            double taken = 0.0;
            for (Index c = 0; c < p; ++c)
                taken += basis.col(c).head(n - k).dot(spread.col(c).tail(n - k)) +
                         left.col(c).head(n - k).dot(basis.col(c).tail(n - k));
            result[k] = (static_cast<double>(n - k) * correlation[k] - taken) / static_cast<double>(n);
        }
        return result;
    }

    /// tr (1 − H)Ω(1 − H)
    [[nodiscard]] double left(const MatrixXd& all) const {
        return static_cast<double>(basis.rows()) - 2.0 * projected.trace() + all.cwiseProduct(shared).sum();
    }
};

MatrixXd sum_of(const std::vector<Series>& series, MatrixXd Series::*part) {
    MatrixXd sum = series.front().*part;
    for (std::size_t s = 1; s < series.size(); ++s) sum += series[s].*part;
    return sum;
}

/// Determines the processes of the residuals, corrected for the effect of the fit.
void find_processes(std::vector<Series>& series) {
    const Index n = series.front().basis.rows(), most = std::min<Index>(10, n / 8);
    const VectorXd shares =
        VectorXd::LinSpaced(most + 1, static_cast<double>(n), static_cast<double>(n - most)) / static_cast<double>(n);
    for (Series& one : series) {
        one.found = autocovariances(*one.residuals, most);
        if (one.found[0] > 0.0) one.process = autoregression(one.found, n);
        one.spread_basis();
    }
    constexpr int rounds = 3;
    for (int round = 0; round < rounds; ++round) {
        const MatrixXd all = sum_of(series, &Series::projected);
        bool changed = false;
        for (Series& one : series) {
            if (!(one.found[0] > 0.0)) continue;
            const bool independent = one.process.coefficients.size() == 0;
            const VectorXd correlation = correlations(one.process, most);
            const VectorXd expected = one.expected(correlation, all);
            const double variance = one.found[0] / expected[0];
            one.process = autoregression(one.found + variance * (correlation.cwiseProduct(shares) - expected), n);
            changed = changed || !independent || one.process.coefficients.size() > 0;
        }
        if (!changed) return;  // independent residuals stay so
        for (Series& one : series) one.spread_basis();
    }
}

}  // namespace

FitCovariance correlated_covariance(const MatrixXd& jacobian, const VectorXd& residuals) {
    return correlated_covariance(std::span(&jacobian, 1), std::span(&residuals, 1));
}

FitCovariance correlated_covariance(std::span<const MatrixXd> jacobians, std::span<const VectorXd> residuals) {
    const Index n = jacobians.front().rows(), p = jacobians.front().cols();
    const auto count = static_cast<Index>(jacobians.size());
    FitCovariance result{.covariance = MatrixXd::Constant(p, p, undefined)};
    if (count * n <= p) return result;
    MatrixXd normal = MatrixXd::Zero(p, p);
    double squares = 0.0;
    for (std::size_t s = 0; s < jacobians.size(); ++s) {
        normal += gram(jacobians[s], jacobians[s]);
        squares += residuals[s].squaredNorm();
    }
    // columns of unit length keep the inverse well conditioned
    const VectorXd inverse_lengths = normal.diagonal().cwiseSqrt().cwiseInverse();
    if (!normal.allFinite() || !inverse_lengths.allFinite() || !std::isfinite(squares)) return result;
    normal = (inverse_lengths.asDiagonal() * normal * inverse_lengths.asDiagonal()).eval();
    if (!numerics::invertible(normal)) return result;
    // J = B Lᵀ of the scaled columns: the covariance in the basis B is turned back by L⁻ᵀ
    const auto lower = numerics::cholesky(normal);
    if (!lower) return result;
    const MatrixXd back = inverse_lengths.asDiagonal() * numerics::inverse(lower->transpose());
    std::vector<Series> series(jacobians.size());
    for (std::size_t s = 0; s < series.size(); ++s) {
        series[s].residuals = &residuals[s];
        series[s].basis = turned(jacobians[s], back);
        series[s].shared = gram(series[s].basis, series[s].basis);
    }
    find_processes(series);
    const MatrixXd all = sum_of(series, &Series::projected);
    MatrixXd middle = MatrixXd::Zero(p, p);
    double independent = 0.0;
    for (Series& one : series) {
        const double left = one.left(all);
        if (!(left > 0.0)) return result;
        one.variance = one.residuals->squaredNorm() / left;
        middle += one.variance * one.projected;
        independent +=
            static_cast<double>(n) / (one.process.coefficients.size() > 0 ? correlated_samples(one.process, n) : 1.0);
    }
    for (std::size_t s = 0; s < series.size(); ++s)
        for (std::size_t t = 0; t < s; ++t) {
            const double lengths = residuals[s].norm() * residuals[t].norm();
            if (!(lengths > 0.0)) continue;
            const double shared =
                residuals[s].dot(residuals[t]) / lengths * std::sqrt(series[s].variance * series[t].variance);
            const MatrixXd mean =
                0.5 * (gram(series[s].basis, series[t].spread) + gram(series[s].spread, series[t].basis));
            middle += shared * (mean + mean.transpose());
        }
    result.correlated_samples = static_cast<double>(count * n) / independent;
    result.degrees_of_freedom = std::max(1.0, independent - static_cast<double>(p));
    result.covariance = back * middle * back.transpose();
    return result;
}

}  // namespace setae::loops
