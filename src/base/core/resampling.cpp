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
    if (replicas.size() < 2)
        throw InvalidArgument(fmt::format("{} replicas; an interval needs at least 2", replicas.size()));
    std::sort(replicas.begin(), replicas.end());
    return {sorted_quantile(replicas, 0.5 * (1.0 - level)), sorted_quantile(replicas, 0.5 * (1.0 + level)), level};
}

}  // namespace setae
