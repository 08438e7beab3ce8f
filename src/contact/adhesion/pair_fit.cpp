// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/pair_fit.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "pair_least_squares.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/core/words.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/numerics/minimum.hpp"

namespace setae::adhesion {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
using Pairs = std::vector<PairPoint>;
using Variance = PairVariance;

double square(double x) { return x * x; }

/// 1 − SS_res/SS_tot; equal measured values have no variance to explain.
double r_squared(const std::vector<double>& measured, double residual_squares) {
    return 1.0 - residual_squares / squares_about_mean(measured);
}

/// Σ over groups of (Σ within the group of the scores)², with the small-sample factor G/(G − 1).
double clustered_scores(const Pairs& pairs, const std::vector<double>& scores,
                        const std::function<std::string(const PairPoint&)>& group) {
    std::map<std::string, double> sums;
    for (std::size_t i = 0; i < pairs.size(); ++i) sums[group(pairs[i])] += scores[i];
    const auto groups = static_cast<double>(sums.size());
    if (groups < 2.0) return 0.0;
    double total = 0.0;
    for (const auto& [name, sum] : sums) total += square(sum);
    return total * groups / (groups - 1.0);
}

double clustered_error(const Pairs& pairs, const std::vector<double>& residual, double work, double curvature) {
    std::vector<double> scores;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        scores.push_back(pairs[i].prediction(work) > 0.0 ? pairs[i].slope * residual[i] : 0.0);
    const double by_surface = clustered_scores(pairs, scores, [](const PairPoint& p) { return p.surface; });
    const double by_elastomer = clustered_scores(pairs, scores, [](const PairPoint& p) { return p.elastomer; });
    const double by_pair =
        clustered_scores(pairs, scores, [](const PairPoint& p) { return p.surface + '\n' + p.elastomer; });
    // the two-way sandwich may turn out smaller than one of its ways in small samples: the larger is kept
    const double scatter = std::max({by_surface + by_elastomer - by_pair, by_surface, by_elastomer});
    return std::sqrt(scatter) / curvature;
}

/// Surfaces or elastomers, whichever are fewer.
std::size_t min_groups(const Pairs& pairs) {
    std::set<std::string> surfaces, elastomers;
    for (const auto& pair : pairs) {
        surfaces.insert(pair.surface);
        elastomers.insert(pair.elastomer);
    }
    return std::min(surfaces.size(), elastomers.size());
}

/// τ that brings χ²(τ) down to the degrees of freedom; 0 where the errors explain the residuals already.
double scatter_for(const std::function<double(double)>& chi_squared, int degrees_of_freedom, double largest) {
    const auto misfit = [&](double tau) { return chi_squared(tau) - degrees_of_freedom; };
    if (misfit(0.0) <= 0.0) return 0.0;
    return numerics::bracketed_root(misfit, 0.0, largest, 40);
}

double largest_scatter(const Pairs& pairs) {
    double largest = 0.0;
    for (const auto& pair : pairs) largest = std::max(largest, std::abs(pair.measured.value));
    return 10.0 * largest * std::sqrt(static_cast<double>(pairs.size()));
}

WorkEstimate estimate(const Pairs& pairs, const Variance& variance, double extra_scatter) {
    const auto minimum = minimise_with(pairs, variance);
    return {{minimum.x, 1.0 / std::sqrt(minimum.curvature), "weighted least squares"}, minimum.cost, extra_scatter};
}

WorkEstimate with_extra_scatter(const Pairs& pairs, int degrees_of_freedom) {
    const auto variance = [](double tau) {
        return [tau](const PairPoint& p) { return p.measured.variance() + square(tau); };
    };
    const double tau = scatter_for([&](double t) { return minimise_with(pairs, variance(t)).cost; }, degrees_of_freedom,
                                   largest_scatter(pairs));
    return estimate(pairs, variance(tau), tau);
}

/// Effective variance: the predicted ± depends on W, so W and the weights are iterated to a common answer.
WorkEstimate errors_in_both(const Pairs& pairs, int degrees_of_freedom, double start) {
    double work = start;
    WorkEstimate result;
    for (int round = 0; round < 100; ++round) {
        const auto variance = [work](double tau) {
            return [work, tau](const PairPoint& p) {
                return p.measured.variance() + p.prediction_variance(work) + square(tau);
            };
        };
        const double tau = scatter_for([&](double t) { return minimise_with(pairs, variance(t)).cost; },
                                       degrees_of_freedom, largest_scatter(pairs));
        result = estimate(pairs, variance(tau), tau);
        const double before = std::exchange(work, result.work_of_adhesion.value);
        if (std::abs(work - before) <= 1e-12 * std::abs(before)) break;
    }
    return result;
}

/// −2 ln L at W, the extra scatter chosen best: Gaussian residuals of variance SE² + τ².
double profile_deviance(const Pairs& pairs, double work, double largest) {
    const auto deviance = [&](double log_tau) {
        const double tau2 = std::exp(2.0 * log_tau);
        double sum = 0.0;
        for (const auto& p : pairs) {
            const double variance = p.measured.variance() + tau2;
            sum += std::log(variance) + square(p.measured.value - p.prediction(work)) / variance;
        }
        return sum;
    };
    return numerics::minimum_between(deviance, std::log(1e-6 * largest), std::log(largest), 30).value;
}

std::optional<Estimate> profile_likelihood(const Pairs& pairs, double start) {
    constexpr double chi_squared_95 = 3.841458820694124;  // 95 % quantile, one degree of freedom
    const double largest = largest_scatter(pairs);
    const auto deviance = [&](double work) { return profile_deviance(pairs, work, largest); };
    const auto best = numerics::minimum_between(deviance, 0.5 * start, 2.0 * start, 40);
    const auto excess = [&](double work) { return deviance(work) - best.value - chi_squared_95; };
    const auto end = [&](double factor) -> std::optional<double> {
        double outer = best.place;
        for (int i = 0; i < 60; ++i) {
            outer *= factor;
            if (excess(outer) > 0.0) return numerics::bracketed_root(excess, best.place, outer, 30);
        }
        return std::nullopt;
    };
    const auto lower = end(0.95), upper = end(1.05);
    if (!lower || !upper) return std::nullopt;
    return Estimate{.value = best.place, .method = "profile likelihood", .interval = Interval{*lower, *upper, 0.95}};
}

}  // namespace

std::set<std::string> groups_of(const std::vector<PairPoint>& pairs, std::string PairPoint::*label) {
    std::set<std::string> groups;
    for (const auto& pair : pairs) groups.insert(pair.*label);
    return groups;
}

std::vector<FlooredTerm> terms_of(const std::vector<PairPoint>& pairs) {
    std::vector<FlooredTerm> terms;
    for (const auto& pair : pairs) terms.push_back({pair.measured.value, pair.slope, pair.offset, 1.0, pair.floored});
    return terms;
}

FlooredMinimum minimise_with(const std::vector<PairPoint>& pairs, const PairVariance& variance) {
    auto terms = terms_of(pairs);
    for (std::size_t i = 0; i < pairs.size(); ++i) terms[i].weight = 1.0 / variance(pairs[i]);
    return floored_minimum(terms, 0.0, infinity);
}

FlooredMinimum least_squares(const std::vector<PairPoint>& pairs) {
    return floored_minimum(terms_of(pairs), 0.0, infinity);
}

Eigen::MatrixXd residual_covariance(const std::vector<PairPoint>& pairs, const std::vector<Components>& inputs) {
    const auto n = static_cast<Index>(pairs.size());
    Eigen::MatrixXd result(n, n);
    for (Index i = 0; i < n; ++i) {
        const auto own = static_cast<std::size_t>(i);
        for (Index j = 0; j < i; ++j)
            result(i, j) = result(j, i) = covariance(inputs[own], inputs[static_cast<std::size_t>(j)]);
        result(i, i) = covariance(inputs[own], inputs[own]) + pairs[own].own_variance();
    }
    return result;
}

double squares_about_mean(const std::vector<double>& values) {
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    double total = 0.0;
    for (const double y : values) total += square(y - mean);
    return total;
}

void require_pairs(const Pairs& pairs) {
    if (pairs.size() < 2)
        throw InvalidArgument(fmt::format("{}; a fit needs at least 2", counted(pairs.size(), "pair", "pairs")));
    for (const auto& pair : pairs)
        if (!(pair.slope > 0.0) || !std::isfinite(pair.measured.value) || !std::isfinite(pair.offset))
            throw InvalidArgument(
                fmt::format("pair {} × {} has slope {}, offset {} and measured value {}; expected a "
                            "slope above 0 and finite values",
                            pair.surface, pair.elastomer, pair.slope, pair.offset, pair.measured.value));
}

WorkFit fit_work_of_adhesion(const Pairs& pairs) {
    require_pairs(pairs);
    WorkFit fit;
    const auto minimum = least_squares(pairs);
    fit.n = static_cast<int>(pairs.size());
    fit.degrees_of_freedom = fit.n - 1;
    fit.pairs = pairs;
    std::vector<double> measured, residual;
    for (const auto& pair : pairs) {
        measured.push_back(pair.measured.value);
        residual.push_back(pair.measured.value - pair.prediction(minimum.x));
    }
    fit.r_squared = r_squared(measured, minimum.cost);
    fit.residual_standard_deviation = std::sqrt(minimum.cost / fit.degrees_of_freedom);
    fit.work_of_adhesion = {.value = minimum.x,
                            .standard_error = fit.residual_standard_deviation / std::sqrt(minimum.curvature),
                            .method = "least squares",
                            .degrees_of_freedom = fit.degrees_of_freedom};
    fit.clustered = {minimum.x, clustered_error(pairs, residual, minimum.x, minimum.curvature), "two-way clustered"};
    if (const auto groups = min_groups(pairs); groups > 1)
        fit.clustered.degrees_of_freedom = static_cast<double>(groups - 1);
    const bool known_errors =
        std::all_of(pairs.begin(), pairs.end(), [](const PairPoint& p) { return p.measured.uncertain(); });
    if (known_errors) {
        fit.weighted = estimate(
            pairs, [](const PairPoint& p) { return p.measured.variance(); }, 0.0);
        constexpr double refused = 0.05;
        if (chi_squared_exceedance(fit.weighted->chi_squared, fit.degrees_of_freedom) < refused)
            fit.weighted->work_of_adhesion.standard_error = undefined;
        fit.with_extra_scatter = with_extra_scatter(pairs, fit.degrees_of_freedom);
        fit.errors_in_both = errors_in_both(pairs, fit.degrees_of_freedom, minimum.x);
        fit.likelihood = profile_likelihood(pairs, minimum.x);
    }
    fit.generalised = fit_generalised(pairs);
    return fit;
}

LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    if (x.size() < 3 || x.size() != y.size())
        throw InvalidArgument(
            fmt::format("{}; a line with intercept needs at least 3", counted(x.size(), "point", "points")));
    const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n,
                 mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double sxx = 0.0, sxy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sxx += square(x[i] - mean_x);
        sxy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    if (!(sxx > 0.0)) throw InvalidArgument("all x are equal, so a line has no slope");
    LineFit fit;
    fit.n = static_cast<int>(x.size());
    const double slope = sxy / sxx, intercept = mean_y - slope * mean_x;
    double residual_squares = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) residual_squares += square(y[i] - intercept - slope * x[i]);
    const double variance = residual_squares / (n - 2.0);
    const auto estimate = [n](double value, double error) {
        return Estimate{
            .value = value, .standard_error = error, .method = "least squares", .degrees_of_freedom = n - 2.0};
    };
    fit.slope = estimate(slope, std::sqrt(variance / sxx));
    fit.intercept = estimate(intercept, std::sqrt(variance * (1.0 / n + square(mean_x) / sxx)));
    fit.r_squared = r_squared(y, residual_squares);
    return fit;
}

LossFits fit_losses(const std::vector<PairPoint>& whole, const std::vector<PairPoint>& without_ideal_loss) {
    const auto line = [](const std::vector<PairPoint>& points) -> std::optional<LineFit> {
        std::vector<double> area, energy;
        for (const auto& p : points) {
            area.push_back(p.slope);
            energy.push_back(p.measured.value);
        }
        if (points.size() < 3 ||
            *std::max_element(area.begin(), area.end()) == *std::min_element(area.begin(), area.end()))
            return std::nullopt;
        return fit_line(area, energy);
    };
    LossFits fits{.through_origin = fit_work_of_adhesion(whole), .with_intercept = line(whole)};
    if (without_ideal_loss.size() >= 2)
        fits.through_origin_without_ideal_loss = fit_work_of_adhesion(without_ideal_loss);
    fits.with_intercept_without_ideal_loss = line(without_ideal_loss);
    return fits;
}

}  // namespace setae::adhesion
