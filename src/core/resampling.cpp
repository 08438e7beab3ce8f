// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae {
namespace {

double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void require_replicas(std::size_t count) {
    if (count < 2) throw InvalidArgument(fmt::format("{} replicas; an interval needs at least 2", count));
}

/// Skewness of a statistic's influence, /6: zero for symmetric influence.
double acceleration(std::span<const LeaveOneOut> strata) {
    double squares = 0.0, cubes = 0.0;
    for (const auto& stratum : strata) {
        if (stratum.size() < 2) continue;
        const double centre = mean(stratum), n = static_cast<double>(stratum.size());
        const double factor =
            (n - 1.0) / n;  // from a difference without one member to that member's share in the statistic
        for (const double without : stratum) {
            const double influence = factor * (centre - without);
            squares += influence * influence;
            cubes += influence * influence * influence;
        }
    }
    return squares > 0.0 ? cubes / (6.0 * std::pow(squares, 1.5)) : 0.0;
}

}  // namespace

Estimate jackknife_estimate(double value, std::span<const LeaveOneOut> strata, double level) {
    std::vector<VarianceTerm> terms;
    double variance = 0.0;
    for (const auto& stratum : strata) {
        if (stratum.size() < 2) continue;
        const double centre = mean(stratum), n = static_cast<double>(stratum.size());
        double squares = 0.0;
        for (const double without : stratum) squares += (without - centre) * (without - centre);
        terms.push_back({(n - 1.0) / n * squares, n - 1.0});
        variance += terms.back().variance;
    }
    Estimate result{value, terms.empty() ? undefined : std::sqrt(variance), "jackknife t"};
    if (variance > 0.0) result.degrees_of_freedom = satterthwaite_degrees_of_freedom(terms);
    result.interval = interval_of(result, level);
    return result;
}

Interval percentile_interval(std::vector<double> replicas, double level) {
    require_replicas(replicas.size());
    std::sort(replicas.begin(), replicas.end());
    return {sorted_quantile(replicas, 0.5 * (1.0 - level)), sorted_quantile(replicas, 0.5 * (1.0 + level)), level};
}

Interval bca_interval(double value, std::vector<double> replicas, std::span<const LeaveOneOut> strata, double level) {
    require_replicas(replicas.size());
    std::sort(replicas.begin(), replicas.end());
    const auto n = static_cast<double>(replicas.size());
    const auto below =
        static_cast<double>(std::lower_bound(replicas.begin(), replicas.end(), value) - replicas.begin());
    const double bias = normal_quantile(std::clamp(below / n, 0.5 / n, 1.0 - 0.5 / n)), skew = acceleration(strata);
    const auto end = [&](double probability) {
        const double shifted = bias + normal_quantile(probability);
        return sorted_quantile(replicas, normal_probability(bias + shifted / (1.0 - skew * shifted)));
    };
    return {end(0.5 * (1.0 - level)), end(0.5 * (1.0 + level)), level};
}

Interval bootstrap_t_interval(const Estimate& value, std::span<const double> replicas,
                              std::span<const double> replica_errors, double level) {
    if (replicas.size() != replica_errors.size())
        throw InvalidArgument(fmt::format("{} replicas with {} standard errors; expected one each", replicas.size(),
                                          replica_errors.size()));
    std::vector<double> studentised;
    for (std::size_t i = 0; i < replicas.size(); ++i)
        if (replica_errors[i] > 0.0) studentised.push_back((replicas[i] - value.value) / replica_errors[i]);
    require_replicas(studentised.size());
    std::sort(studentised.begin(), studentised.end());
    return {value.value - sorted_quantile(studentised, 0.5 * (1.0 + level)) * value.standard_error,
            value.value - sorted_quantile(studentised, 0.5 * (1.0 - level)) * value.standard_error, level};
}

}  // namespace setae
