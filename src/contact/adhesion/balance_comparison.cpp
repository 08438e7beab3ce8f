// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/balance_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "balance_score.hpp"
#include "pair_least_squares.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/words.hpp"
#include "setae/numerics/minimum.hpp"

namespace setae::adhesion {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

std::vector<double> measured(const std::vector<PairPoint>& pairs) {
    std::vector<double> values;
    for (const auto& pair : pairs) values.push_back(pair.measured.value);
    return values;
}

void require_at_least(std::size_t pairs, std::size_t least) {
    if (pairs < least)
        throw InvalidArgument(
            fmt::format("{}; a comparison of balances needs at least {}", counted(pairs, "pair", "pairs"), least));
}

/// rms residual of each surface's pairs under a fit to all others; NaN where the others are too few to fit.
template <class SquaresOfOwn>
double left_out(const std::vector<PairPoint>& pairs, SquaresOfOwn squares_of_own) {
    std::set<std::string> surfaces;
    for (const auto& pair : pairs) surfaces.insert(pair.surface);
    double squares = 0.0;
    for (const auto& name : surfaces) {
        std::vector<PairPoint> others, own;
        for (const auto& pair : pairs) (pair.surface == name ? own : others).push_back(pair);
        try {
            squares += squares_of_own(others, own);
        } catch (const InvalidArgument&) {
            return std::numeric_limits<double>::quiet_NaN();
        }
    }
    return std::sqrt(squares / static_cast<double>(pairs.size()));
}

/// ∂ prediction/∂χ.
double by_change(const PairPoint& pair) { return -pair.slope * (pair.slope - 1.0); }

std::vector<PairPoint> at_change(std::vector<PairPoint> pairs, double change) {
    for (auto& pair : pairs) pair.offset -= change * by_change(pair);
    return pairs;
}

struct ChangeAndWork {
    double change = 0.0, work = 0.0, cost = 0.0;
};

/// The deepest valley in χ: kinks of the floor make several, so that a grid comes first.
ChangeAndWork best_change(const std::vector<PairPoint>& pairs) {
    double least = unbounded, most = -unbounded, largest = 0.0;
    for (const auto& pair : pairs) {
        least = std::min(least, pair.slope);
        most = std::max(most, pair.slope);
        largest = std::max({largest, std::abs(pair.measured.value), std::abs(pair.offset)});
    }
    if (!(most > least * (1.0 + 1e-9)))
        throw InvalidArgument("all pairs have the same true area, so a change with true area cannot be fitted");
    auto terms = terms_of(pairs);
    const auto fitted_at = [&](double change) {
        for (std::size_t i = 0; i < pairs.size(); ++i) terms[i].offset = pairs[i].offset - change * by_change(pairs[i]);
        return floored_minimum(terms, 0.0, unbounded);
    };
    const auto cost = [&](double change) { return fitted_at(change).cost; };
    constexpr int grid = 400;
    const double reach = 20.0 * largest / (most - least), step = 2.0 * reach / grid;
    double best = -reach, lowest = cost(best);
    for (int i = 1; i <= grid; ++i)
        if (const double there = cost(-reach + i * step); there < lowest) {
            lowest = there;
            best = -reach + i * step;
        }
    constexpr int bits = 40;
    const auto minimum = numerics::minimum_between(cost, best - step, best + step, bits);
    const auto fitted = fitted_at(minimum.place);
    return {minimum.place, fitted.x, fitted.cost};
}

double surface_squares(const std::vector<PairPoint>& own, double work) {
    double squares = 0.0;
    for (const auto& pair : own) squares += std::pow(pair.measured.value - pair.prediction(work), 2);
    return squares;
}

}  // namespace

BalanceScore score_of(int parameters, double work, double residual_squares, double total_squares, std::size_t pairs) {
    BalanceScore result{.n = static_cast<int>(pairs),
                        .parameters = parameters,
                        .work_of_adhesion = work,
                        .residual_squares = residual_squares};
    const auto n = static_cast<double>(pairs);
    result.r_squared = 1.0 - residual_squares / total_squares;
    result.log_likelihood = -0.5 * n * std::log(residual_squares / n);
    result.left_out_deviation = std::numeric_limits<double>::quiet_NaN();
    return result;
}

BalanceScore score_balance(const std::vector<PairPoint>& pairs) {
    require_at_least(pairs.size(), 2);
    const auto minimum = least_squares(pairs);
    auto result = score_of(1, minimum.x, minimum.cost, squares_about_mean(measured(pairs)), pairs.size());
    result.left_out_deviation = left_out(pairs, [](const auto& others, const auto& own) {
        require_at_least(others.size(), 1);
        return surface_squares(own, least_squares(others).x);
    });
    return result;
}

BalanceScore score_free_energies(const std::vector<FreeEnergyPoint>& pairs) {
    const auto fit = fit_with_free_energies(pairs);
    std::vector<double> values;
    for (const auto& point : pairs) values.push_back(point.pair.measured.value);
    const double total = squares_about_mean(values);
    return score_of(1 + static_cast<int>(fit.energy_per_modulus.size()), fit.work_of_adhesion,
                    (1.0 - fit.r_squared) * total, total, pairs.size());
}

StrainedInterfaceFit fit_strained_interface(const std::vector<PairPoint>& pairs) {
    require_at_least(pairs.size(), 3);
    const auto best = best_change(pairs);
    // normal equations of the pairs above their floor
    double ww = 0.0, wc = 0.0, cc = 0.0;
    for (const auto& pair : at_change(pairs, best.change)) {
        if (pair.floored && !(pair.prediction(best.work) > 0.0)) continue;
        ww += pair.slope * pair.slope;
        wc += pair.slope * by_change(pair);
        cc += by_change(pair) * by_change(pair);
    }
    const double determinant = ww * cc - wc * wc, freedom = static_cast<double>(pairs.size()) - 2.0;
    const double variance = best.cost / freedom;
    const auto estimate = [&](double value, double entry) {
        return Estimate{.value = value,
                        .standard_error = std::sqrt(variance * entry / determinant),
                        .method = "least squares",
                        .degrees_of_freedom = freedom};
    };
    StrainedInterfaceFit fit;
    fit.n = static_cast<int>(pairs.size());
    fit.work_of_adhesion = estimate(best.work, cc);
    fit.interface_change = estimate(best.change, ww);
    fit.correlation = -wc / std::sqrt(ww * cc);
    fit.residual_squares = best.cost;
    fit.r_squared = 1.0 - best.cost / squares_about_mean(measured(pairs));
    return fit;
}

BalanceScore score_strained_interface(const std::vector<PairPoint>& pairs) {
    require_at_least(pairs.size(), 3);
    const auto best = best_change(pairs);
    auto result = score_of(2, best.work, best.cost, squares_about_mean(measured(pairs)), pairs.size());
    result.left_out_deviation = left_out(pairs, [](const auto& others, const auto& own) {
        require_at_least(others.size(), 3);
        const auto fitted = best_change(others);
        return surface_squares(at_change(own, fitted.change), fitted.work);
    });
    return result;
}

}  // namespace setae::adhesion
