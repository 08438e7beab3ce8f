// SPDX-License-Identifier: GPL-3.0-or-later
#include "white_floor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "setae/numerics/bracketing.hpp"

namespace setae::diagnostics {
namespace {

constexpr double least_exponent = 1.05, largest_exponent = 8.0;

/// Σ_{m >= 1} of both aliases, the far ones as an integral.
double aliases(double x, double exponent) {
    constexpr int terms = 6;
    double sum = 0.0;
    for (int m = 1; m <= terms; ++m) sum += std::pow(2.0 * m - x, -exponent) + std::pow(2.0 * m + x, -exponent);
    return sum + std::pow(2.0 * terms + 1.0, 1.0 - exponent) / (exponent - 1.0);
}

Array1D shape(const ArrayView1D& x, double exponent, bool aliased) {
    return x.unaryExpr(
        [&](double value) { return std::pow(value, -exponent) + (aliased ? aliases(value, exponent) : 0.0); });
}

struct Levels {
    double amplitude = 0.0, level = 0.0, loss = 0.0;
};

double loss_of(const Array1D& expected, const ArrayView1D& power) { return (expected.log() + power / expected).sum(); }

/// Best A with N = 0.
Levels without_floor(const Array1D& s, const ArrayView1D& power) {
    const double amplitude = (power / s).mean();
    return {amplitude, 0.0, loss_of(amplitude * s, power)};
}

/// Best A and N >= 0: least squares with weights 1/E², repeated.
Levels with_floor(const Array1D& s, const ArrayView1D& power) {
    const auto bare = without_floor(s, power);
    Levels best = bare;
    double amplitude = 0.5 * bare.amplitude, level = 0.5 * power.tail(std::max<Index>(1, power.size() / 8)).mean();
    constexpr int rounds = 25;
    for (int round = 0; round < rounds; ++round) {
        const Array1D expected = amplitude * s + level;
        const double loss = loss_of(expected, power);
        const bool settled = best.level > 0.0 && std::abs(loss - best.loss) < 1e-9 * std::abs(loss);
        if (loss < best.loss) best = {amplitude, level, loss};
        if (settled) break;
        const Array1D weight = expected.square().inverse();
        const double ss = (weight * s.square()).sum(), s1 = (weight * s).sum(), s0 = weight.sum();
        const double ps = (weight * s * power).sum(), p0 = (weight * power).sum(), determinant = ss * s0 - s1 * s1;
        if (!(determinant > 0.0)) break;
        amplitude = (ps * s0 - p0 * s1) / determinant;
        level = (p0 * ss - ps * s1) / determinant;
        if (!(level > 0.0)) break;
        amplitude = std::max(amplitude, 1e-12 * ps / ss);
    }
    return best;
}

template <class Fit>
double best_exponent(Fit fit) {
    // coarse steps, then golden section: the loss has one minimum for spectra that fall
    constexpr int steps = 15;
    double best = least_exponent, loss = fit(best);
    const double width = (largest_exponent - least_exponent) / steps;
    for (int k = 1; k <= steps; ++k) {
        const double candidate = least_exponent + k * width, at = fit(candidate);
        if (at < loss) best = candidate, loss = at;
    }
    return numerics::golden_section(fit, std::max(least_exponent, best - width),
                                    std::min(largest_exponent, best + width), 25);
}

struct Candidate {
    double exponent = 0.0, gain = 0.0;
    Levels levels;
};

Candidate fitted(const ArrayView1D& x, const ArrayView1D& power, bool aliased) {
    const double bare =
        best_exponent([&](double alpha) { return without_floor(shape(x, alpha, aliased), power).loss; });
    const double exponent =
        best_exponent([&](double alpha) { return with_floor(shape(x, alpha, aliased), power).loss; });
    const auto levels = with_floor(shape(x, exponent, aliased), power);
    return {exponent, without_floor(shape(x, bare, aliased), power).loss - levels.loss, levels};
}

double standard_error(const ArrayView1D& x, const Candidate& fit, bool aliased, double freedom) {
    const Array1D s = shape(x, fit.exponent, aliased), expected = fit.levels.amplitude * s + fit.levels.level;
    constexpr double h = 1e-4;
    const Array1D slope = fit.levels.amplitude * (shape(x, fit.exponent + h, aliased) - s) / h;
    Eigen::MatrixXd jacobian(x.size(), 3);  // of ln E by ln A, α, ln N
    jacobian.col(0) = fit.levels.amplitude * s / expected;
    jacobian.col(1) = slope / expected;
    jacobian.col(2) = fit.levels.level / expected;
    const Eigen::Matrix3d information = freedom * jacobian.transpose() * jacobian;
    return fit.levels.level * std::sqrt(information.inverse()(2, 2));
}

}  // namespace

WhiteFloor white_floor(const ArrayView1D& x, const ArrayView1D& power, double freedom, double cautious_freedom) {
    const std::array<Candidate, 2> candidates{fitted(x, power, false), fitted(x, power, true)};
    const double folded =
        1.0 / (1.0 + std::exp(cautious_freedom * (candidates[1].levels.loss - candidates[0].levels.loss)));
    const std::array<double, 2> weights{1.0 - folded, folded};
    WhiteFloor result;
    std::array<double, 2> errors{};
    for (std::size_t c = 0; c < 2; ++c) {
        const auto& fit = candidates[c];
        result.amplitude += weights[c] * fit.levels.amplitude;
        result.exponent += weights[c] * fit.exponent;
        result.level += weights[c] * fit.levels.level;
        result.surface_at_end +=
            weights[c] * fit.levels.amplitude * (1.0 + (c == 1 ? aliases(1.0, fit.exponent) : 0.0));
        if (fit.levels.level > 0.0) errors[c] = standard_error(x, fit, c == 1, freedom);
    }
    double variance = 0.0;
    for (std::size_t c = 0; c < 2; ++c)
        variance += weights[c] * (errors[c] * errors[c] + std::pow(candidates[c].levels.level - result.level, 2));
    result.level_error = std::sqrt(variance);
    result.gain = std::min(candidates[0].gain, candidates[1].gain);
    return result;
}

}  // namespace setae::diagnostics
