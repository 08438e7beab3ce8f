// SPDX-License-Identifier: GPL-3.0-or-later
#include "steps.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "channel_noise.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

constexpr Index min_beside = 8;

/// Orthonormal polynomials over a number of samples, one per column.
Eigen::MatrixXd polynomials(Index samples, Index degree) {
    const Array1D u = Array1D::LinSpaced(samples, -1.0, 1.0);
    Eigen::MatrixXd powers = Eigen::MatrixXd::Ones(samples, degree + 1);
    for (Index k = 1; k <= degree; ++k) powers.col(k) = (powers.col(k - 1).array() * u).matrix();
    return numerics::orthonormal(powers);
}

Array1D residuals(const Array1D& series, const Eigen::MatrixXd& basis) {
    return series - (basis * (basis.transpose() * series.matrix())).array();
}

struct Candidate {
    Step step;
    double variance = 0.0;  ///< variance of the size, for noise of variance 1
    double gain = 0.0;      ///< decrease of the sum of squares
};

Candidate best_step(const Array1D& rest, const Eigen::MatrixXd& basis) {
    Candidate best;
    double sum = 0.0;
    Eigen::RowVectorXd moments = Eigen::RowVectorXd::Zero(basis.cols());
    for (Index i = rest.size() - 1; i >= min_beside; --i) {
        sum += rest[i];
        moments += basis.row(i);
        const Index behind = rest.size() - i;
        if (behind < min_beside) continue;
        const double squares = static_cast<double>(behind) - moments.squaredNorm(), gain = sum * sum / squares;
        if (gain > best.gain)
            best = {.step = {.last = i - 1, .size = sum / squares}, .variance = 1.0 / squares, .gain = gain};
    }
    return best;
}

}  // namespace

std::optional<Step> step_in(const Array1D& series, const Smoothness& smoothness, const SampleNoise& known) {
    constexpr double deviations = 6.0;
    const Index n = series.size();
    if (n < 2 * min_beside + smoothness.rivalling + 1) return std::nullopt;
    const Eigen::MatrixXd basis = polynomials(n, smoothness.degree);
    const Array1D rest = residuals(series, basis);
    const Candidate best = best_step(rest, basis);
    if (!(best.gain > 0.0)) return std::nullopt;
    const double left = rest.square().sum() - best.gain;
    if (!(left < residuals(series, polynomials(n, smoothness.rivalling)).square().sum())) return std::nullopt;
    Array1D level = series;
    level.tail(n - best.step.last - 1) -= best.step.size;
    const FreeFlightNoise noise = free_flight_noise(residuals(level, basis));
    const double error = std::sqrt(best.variance) * std::max(noise.sigma * std::sqrt(noise.correlated_samples()),
                                                             known.sigma * std::sqrt(known.correlated_samples));
    if (!(std::abs(best.step.size) > deviations * error)) return std::nullopt;
    return best.step;
}

}  // namespace setae::loops
