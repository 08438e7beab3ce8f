// SPDX-License-Identifier: GPL-3.0-or-later
#include "white_floor.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Dense>

#include "setae/numerics/bracketing.hpp"
#include "setae/spectra/mode_groups.hpp"

namespace setae::diagnostics {
namespace {

constexpr double min_exponent = 1.05, largest_exponent = 8.0;

constexpr int alias_terms = 6;

/// Contribution of aliases beyond the last term, as an integral.
double far_aliases(double exponent) { return std::pow(2.0 * alias_terms + 1.0, 1.0 - exponent) / (exponent - 1.0); }

/// Σ_{m >= 1} of both aliases, the far ones as an integral.
double aliases(double x, double exponent) {
    double sum = 0.0;
    for (int m = 1; m <= alias_terms; ++m) sum += std::pow(2.0 * m - x, -exponent) + std::pow(2.0 * m + x, -exponent);
    return sum + far_aliases(exponent);
}

/// Modes for the fit, with groups of neighbours as one: means of their positions and powers, and their number.
class Modes {
public:
    Modes(const ArrayView1D& x, const ArrayView1D& all_powers) {
        constexpr double ratio = 1.005;
        const auto first = spectra::narrow_groups(x, ratio);
        const auto groups = std::ssize(first) - 1;
        Array1D place(groups);
        power.resize(groups);
        number.resize(groups);
        for (Index g = 0; g < groups; ++g) {
            const Index begin = first[static_cast<std::size_t>(g)],
                        size = first[static_cast<std::size_t>(g) + 1] - begin;
            place[g] = x.segment(begin, size).mean();
            power[g] = all_powers.segment(begin, size).mean();
            number[g] = static_cast<double>(size);
        }
        logarithms_.resize(2 * alias_terms + 1, groups);
        logarithms_.row(0) = place.log().transpose();
        for (int m = 1; m <= alias_terms; ++m) {
            logarithms_.row(2 * m - 1) = (2.0 * m - place).log().transpose();
            logarithms_.row(2 * m) = (2.0 * m + place).log().transpose();
        }
    }

    [[nodiscard]] Array1D shape(double exponent, bool aliased) const {
        Array1D result = (-exponent * logarithms_.row(0)).exp().transpose();
        if (!aliased) return result;
        for (Index k = 1; k < logarithms_.rows(); ++k) result += (-exponent * logarithms_.row(k)).exp().transpose();
        return result + far_aliases(exponent);
    }

    Array1D power, number;

private:
    Array2D logarithms_;  ///< of x, and of 2m − x and 2m + x, one row each
};

struct Levels {
    double amplitude = 0.0, level = 0.0, loss = 0.0;
};

double loss_of(const Array1D& expected, const Modes& modes) {
    return (modes.number * (expected.log() + modes.power / expected)).sum();
}

/// Best A with N = 0.
Levels without_floor(const Array1D& s, const Modes& modes) {
    const double amplitude = (modes.number * modes.power / s).sum() / modes.number.sum();
    return {amplitude, 0.0, loss_of(amplitude * s, modes)};
}

/// Best A and N >= 0: least squares with weights 1/E², repeated.
Levels with_floor(const Array1D& s, const Modes& modes) {
    const auto bare = without_floor(s, modes);
    const auto &power = modes.power, &number = modes.number;
    Levels best = bare;
    const Index last = std::max<Index>(1, power.size() / 8);
    double amplitude = 0.5 * bare.amplitude, level = 0.5 * (number * power).tail(last).sum() / number.tail(last).sum();
    constexpr int rounds = 25;
    for (int round = 0; round < rounds; ++round) {
        const Array1D expected = amplitude * s + level;
        const double loss = loss_of(expected, modes);
        const bool settled = best.level > 0.0 && std::abs(loss - best.loss) < 1e-9 * std::abs(loss);
        if (loss < best.loss) best = {amplitude, level, loss};
        if (settled) break;
        const Array1D weight = number * expected.square().inverse();
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
    // coarse steps, then golden section: the loss has one minimum for decreasing spectra
    constexpr int steps = 15;
    double best = min_exponent, loss = fit(best);
    const double width = (largest_exponent - min_exponent) / steps;
    for (int k = 1; k <= steps; ++k) {
        const double candidate = min_exponent + k * width, at = fit(candidate);
        if (at < loss) {
            best = candidate;
            loss = at;
        }
    }
    return numerics::golden_section(fit, std::max(min_exponent, best - width), std::min(largest_exponent, best + width),
                                    25);
}

struct Candidate {
    double exponent = 0.0, gain = 0.0;
    Levels levels;
};

Candidate fitted(const Modes& modes, bool aliased) {
    const double bare =
        best_exponent([&](double alpha) { return without_floor(modes.shape(alpha, aliased), modes).loss; });
    const double exponent =
        best_exponent([&](double alpha) { return with_floor(modes.shape(alpha, aliased), modes).loss; });
    const auto levels = with_floor(modes.shape(exponent, aliased), modes);
    return {exponent, without_floor(modes.shape(bare, aliased), modes).loss - levels.loss, levels};
}

double standard_error(const Modes& modes, const Candidate& fit, bool aliased, double freedom) {
    const Array1D s = modes.shape(fit.exponent, aliased), expected = fit.levels.amplitude * s + fit.levels.level;
    constexpr double h = 1e-4;
    const Array1D slope = fit.levels.amplitude * (modes.shape(fit.exponent + h, aliased) - s) / h;
    Eigen::MatrixXd jacobian(s.size(), 3);  // of ln E by ln A, α, ln N
    jacobian.col(0) = fit.levels.amplitude * s / expected;
    jacobian.col(1) = slope / expected;
    jacobian.col(2) = fit.levels.level / expected;
    const Eigen::Matrix3d information = freedom * jacobian.transpose() * modes.number.matrix().asDiagonal() * jacobian;
    return fit.levels.level * std::sqrt(information.inverse()(2, 2));
}

}  // namespace

WhiteFloor white_floor(const ArrayView1D& x, const ArrayView1D& power, double freedom, double cautious_freedom) {
    const Modes modes(x, power);
    const std::array<Candidate, 2> candidates{fitted(modes, false), fitted(modes, true)};
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
        if (fit.levels.level > 0.0) errors[c] = standard_error(modes, fit, c == 1, freedom);
    }
    double variance = 0.0;
    for (std::size_t c = 0; c < 2; ++c)
        variance += weights[c] * (errors[c] * errors[c] + std::pow(candidates[c].levels.level - result.level, 2));
    result.level_error = std::sqrt(variance);
    result.gain = std::min(candidates[0].gain, candidates[1].gain);
    return result;
}

}  // namespace setae::diagnostics
