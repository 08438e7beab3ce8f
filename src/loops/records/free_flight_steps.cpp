// SPDX-License-Identifier: GPL-3.0-or-later
#include "free_flight_steps.hpp"

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "channel_noise.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

constexpr Index fewest_beside = 8;

/// Residuals of the best polynomial.
Array1D without_polynomial(const Array1D& series, Index degree) {
    const Array1D u = Array1D::LinSpaced(series.size(), -1.0, 1.0);
    Eigen::MatrixXd design = Eigen::MatrixXd::Ones(series.size(), degree + 1);
    for (Index k = 1; k <= degree; ++k) design.col(k) = (design.col(k - 1).array() * u).matrix();
    return series - (design * numerics::least_squares(design, series.matrix())).array();
}

/// A line with a change of its level.
struct Step {
    Index last = 0;         ///< sample before it
    double size = 0.0;      ///< [N]
    double variance = 0.0;  ///< of the size, for noise of variance 1
    double gain = 0.0;      ///< by which the sum of squares falls below that of the line
};

/// The step that lowers the sum of squares most. rest: residuals of a line.
Step best_step(const Array1D& rest) {
    const auto n = static_cast<double>(rest.size());
    const double spread = n * (n * n - 1.0) / 12.0;  // Σ (i − ī)²
    Step best;
    double sum = 0.0;  // of the residuals behind the step
    for (Index i = rest.size() - 1; i >= fewest_beside; --i) {
        sum += rest[i];
        if (rest.size() - i < fewest_beside) continue;
        // a unit step, less the line through it: |h|² = m − m²/n − (Σ_(behind) (k − ī))²/spread
        const double behind = n - static_cast<double>(i), moment = 0.5 * behind * static_cast<double>(i);
        const double squares = behind - behind * behind / n - moment * moment / spread;
        const double gain = sum * sum / squares;
        if (gain > best.gain) best = {.last = i - 1, .size = sum / squares, .variance = 1.0 / squares, .gain = gain};
    }
    return best;
}

std::optional<Step> step_of(const Array1D& force) {
    constexpr double deviations = 6.0;
    if (force.size() < 2 * fewest_beside + 4) return std::nullopt;
    const Array1D rest = without_polynomial(force, 1);
    const Step step = best_step(rest);
    const double left = rest.square().sum() - step.gain;
    if (!(step.gain > 0.0) || !(left < without_polynomial(force, 3).square().sum())) return std::nullopt;
    Array1D level = force;
    level.tail(force.size() - step.last - 1) -= step.size;
    const FreeFlightNoise noise = free_flight_noise(level);
    const double error = noise.sigma * std::sqrt(noise.correlated_samples() * step.variance);
    if (!(std::abs(step.size) > deviations * error)) return std::nullopt;
    return step;
}

}  // namespace

IndexRange cut_at_steps(const Loop& loop, IndexRange range, bool before_contact, std::vector<ForceStep>& steps) {
    while (const auto step = step_of(loop.force.segment(range.first, range.count()))) {
        const Index last = range.first + step->last;
        steps.push_back({.sample = last, .size = step->size});
        if (before_contact) range.first = last + 1;
        else range.last = last;
    }
    return range;
}

}  // namespace setae::loops
