// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/balance_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <set>

#include <fmt/format.h>
#include <boost/math/tools/minima.hpp>

#include "floored_least_squares.hpp"
#include "setae/core/errors.hpp"

namespace setae::adhesion {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Least squares in W alone.
FlooredMinimum least_squares(const std::vector<PairPoint>& pairs) {
    std::vector<FlooredTerm> terms;
    for (const auto& pair : pairs) terms.push_back({pair.measured.value, pair.slope, pair.offset, 1.0, pair.floored});
    return floored_minimum(terms, 0.0, unbounded);
}

template <class Point, class ValueOf>
double scatter_about_mean(const std::vector<Point>& pairs, ValueOf value_of) {
    double mean = 0.0, squares = 0.0;
    for (const auto& pair : pairs) mean += value_of(pair) / static_cast<double>(pairs.size());
    for (const auto& pair : pairs) squares += std::pow(value_of(pair) - mean, 2);
    return squares;
}

BalanceScore score(int parameters, double work, double residual_squares, double total_squares, std::size_t pairs) {
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

void require_at_least(std::size_t pairs, std::size_t least) {
    if (pairs < least)
        throw InvalidArgument(fmt::format("{} pairs, a comparison of balances needs at least {}", pairs, least));
}

/// rms residual of each surface's pairs under what a fit to all others says; NaN where the others are too few to fit.
template <class Point, class SurfaceOf, class ErrorsOf>
double left_out(const std::vector<Point>& pairs, SurfaceOf surface_of, ErrorsOf squares_of_left_out) {
    std::set<std::string> surfaces;
    for (const auto& pair : pairs) surfaces.insert(surface_of(pair));
    double squares = 0.0;
    for (const auto& name : surfaces) {
        std::vector<Point> others, own;
        for (const auto& pair : pairs) (surface_of(pair) == name ? own : others).push_back(pair);
        try {
            squares += squares_of_left_out(others, own);
        } catch (const InvalidArgument&) {
            return std::numeric_limits<double>::quiet_NaN();
        }
    }
    return std::sqrt(squares / static_cast<double>(pairs.size()));
}

PairPoint at_change(const StrainedPoint& pair, double change) {
    PairPoint point = pair.point;
    point.offset += change * pair.area_ratio * (pair.area_ratio - 1.0);
    return point;
}

std::vector<PairPoint> at_change(const std::vector<StrainedPoint>& pairs, double change) {
    std::vector<PairPoint> points;
    points.reserve(pairs.size());
    for (const auto& pair : pairs) points.push_back(at_change(pair, change));
    return points;
}

struct ChangeAndWork {
    double change = 0.0, work = 0.0, cost = 0.0;
};

/// The deepest valley in χ: kinks of the floor make several, so that a grid comes first.
ChangeAndWork best_change(const std::vector<StrainedPoint>& pairs) {
    double least = unbounded, most = -unbounded, largest = 0.0;
    for (const auto& pair : pairs) {
        least = std::min(least, pair.area_ratio);
        most = std::max(most, pair.area_ratio);
        largest = std::max({largest, std::abs(pair.point.measured.value), std::abs(pair.point.offset)});
    }
    if (!(most > least * (1.0 + 1e-9)))
        throw InvalidArgument("all pairs have the same true area, a change with it cannot be seen");
    const auto cost = [&](double change) { return least_squares(at_change(pairs, change)).cost; };
    constexpr int grid = 400;
    const double reach = 20.0 * largest / (most - least), step = 2.0 * reach / grid;
    double best = -reach, lowest = cost(best);
    for (int i = 1; i <= grid; ++i)
        if (const double there = cost(-reach + i * step); there < lowest) {
            lowest = there;
            best = -reach + i * step;
        }
    constexpr int bits = 40;
    const auto minimum = boost::math::tools::brent_find_minima(cost, best - step, best + step, bits);
    const auto fitted = least_squares(at_change(pairs, minimum.first));
    return {minimum.first, fitted.x, fitted.cost};
}

double surface_squares(const std::vector<PairPoint>& own, double work) {
    double squares = 0.0;
    for (const auto& pair : own) squares += std::pow(pair.measured.value - pair.prediction(work), 2);
    return squares;
}

}  // namespace

BalanceScore score_balance(const std::vector<PairPoint>& pairs) {
    require_at_least(pairs.size(), 2);
    const auto minimum = least_squares(pairs);
    auto result = score(1, minimum.x, minimum.cost,
                        scatter_about_mean(pairs, [](const PairPoint& p) { return p.measured.value; }), pairs.size());
    result.left_out_deviation = left_out(
        pairs, [](const PairPoint& p) { return p.surface; },
        [](const auto& others, const auto& own) {
            require_at_least(others.size(), 1);
            return surface_squares(own, least_squares(others).x);
        });
    return result;
}

BalanceScore score_free_energies(const std::vector<FreeEnergyPoint>& pairs) {
    const auto fit = fit_with_free_energies(pairs);
    const double total = scatter_about_mean(pairs, [](const FreeEnergyPoint& p) { return p.measured; });
    return score(1 + static_cast<int>(fit.energy_per_modulus.size()), fit.work_of_adhesion,
                 (1.0 - fit.r_squared) * total, total, pairs.size());
}

StrainedInterfaceFit fit_strained_interface(const std::vector<StrainedPoint>& pairs) {
    require_at_least(pairs.size(), 3);
    const auto best = best_change(pairs);
    // prediction = r W − r (r − 1) χ − …: normal equations of the pairs above their floor
    double ww = 0.0, wc = 0.0, cc = 0.0;
    for (const auto& pair : pairs) {
        const auto point = at_change(pair, best.change);
        if (point.floored && !(point.prediction(best.work) > 0.0)) continue;
        const double by_change = -pair.area_ratio * (pair.area_ratio - 1.0);
        ww += point.slope * point.slope;
        wc += point.slope * by_change;
        cc += by_change * by_change;
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
    fit.r_squared =
        1.0 - best.cost / scatter_about_mean(pairs, [](const StrainedPoint& p) { return p.point.measured.value; });
    return fit;
}

BalanceScore score_strained_interface(const std::vector<StrainedPoint>& pairs) {
    require_at_least(pairs.size(), 3);
    const auto best = best_change(pairs);
    auto result =
        score(2, best.work, best.cost,
              scatter_about_mean(pairs, [](const StrainedPoint& p) { return p.point.measured.value; }), pairs.size());
    result.left_out_deviation = left_out(
        pairs, [](const StrainedPoint& p) { return p.point.surface; },
        [](const auto& others, const auto& own) {
            require_at_least(others.size(), 3);
            const auto fitted = best_change(others);
            return surface_squares(at_change(own, fitted.change), fitted.work);
        });
    return result;
}

}  // namespace setae::adhesion
