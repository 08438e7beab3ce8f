// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/workflow/parameter_spread.hpp"

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/resampling.hpp"
#include "setae/core/statistics.hpp"

namespace setae::workflow {

using roughness::SpectralParameters;

double ParameterSpread::covariance(const Function& f, const Function& g) const {
    double sum = 0.0;
    if (replicas.size() > 1) {
        const auto n = static_cast<double>(replicas.size());
        double mean_f = 0.0, mean_g = 0.0, products = 0.0;
        for (const auto& replica : replicas) {
            mean_f += f(replica) / n;
            mean_g += g(replica) / n;
        }
        for (const auto& replica : replicas) products += (f(replica) - mean_f) * (g(replica) - mean_g);
        sum += products / (n - 1.0);
    }
    for (const auto& source : sources) sum += 0.25 * (f(source.plus) - f(source.minus)) * (g(source.plus) - g(source.minus));
    return sum;
}

double ParameterSpread::standard_error(const Function& f) const {
    return replicas.size() < 2 && sources.empty() ? undefined : std::sqrt(covariance(f, f));
}

VarianceTerm ParameterSpread::variance_term(const Function& f) const {
    VarianceTerm result{covariance(f, f)};
    std::vector<LeaveOneOut> strata;
    for (const auto& stratum : left_out) {
        auto& values = strata.emplace_back();
        for (const auto& p : stratum) values.push_back(f(p));
    }
    const auto between = jackknife_estimate(undefined, strata);  // its value does not enter the freedom
    if (!between.degrees_of_freedom) return result;
    std::vector<VarianceTerm> terms{{between.variance(), *between.degrees_of_freedom}};
    for (const auto& source : sources) terms.push_back({0.25 * std::pow(f(source.plus) - f(source.minus), 2)});
    result.degrees_of_freedom = satterthwaite_degrees_of_freedom(terms);
    return result;
}

Estimate ParameterSpread::estimate(double value, const Function& f, double least) const {
    Estimate result{value, standard_error(f)};
    if (replicas.size() > 1) result.seed = seed;
    // one that does not exceed the bound has no logarithm: NaN goes through to the interval and is refused there
    const auto log_excess = [&](const SpectralParameters& p) { return std::log(f(p) - least); };
    std::vector<LeaveOneOut> strata;
    for (const auto& stratum : left_out) {
        auto& values = strata.emplace_back();
        for (const auto& p : stratum) values.push_back(log_excess(p));
    }
    const auto between = jackknife_estimate(std::log(value - least), strata);
    std::vector<VarianceTerm> terms;
    if (replicas_are_draws) terms.push_back({covariance(log_excess, log_excess)});
    if (between.degrees_of_freedom) terms.push_back({between.variance(), *between.degrees_of_freedom});
    for (const auto& source : sources)
        if (!replicas_are_draws) terms.push_back({0.25 * std::pow(log_excess(source.plus) - log_excess(source.minus), 2)});
    double variance = 0.0;
    for (const auto& term : terms) variance += term.variance;
    result.method = replicas_are_draws ? "likelihood" : sources.empty() ? "jackknife t on ln" : between.degrees_of_freedom ? "jackknife t on ln, delta" : "delta on ln";
    if (!(variance > 0.0) || !std::isfinite(variance)) {
        result.method = replicas.size() > 1 ? "bootstrap" : "delta";
        return result;
    }
    const double freedom = satterthwaite_degrees_of_freedom(terms);
    if (std::isfinite(freedom)) result.degrees_of_freedom = freedom;
    constexpr double level = 0.95;
    const double factor = std::exp(student_t_quantile(0.5 * (1.0 + level), freedom) * std::sqrt(variance));
    result.interval = Interval{least + (value - least) / factor, least + (value - least) * factor, level};
    return result;
}

}  // namespace setae::workflow
