// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include "setae/core/errors.hpp"
#include "setae/core/resampling.hpp"
#include "setae/core/statistics.hpp"

/// Intervals that setae was measured against (docs/concepts/uncertainty.md) and does not use: they hold too little with
/// few measurements.
namespace setae::tests {

inline double mean(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Skewness of a statistic's influence, /6: zero for symmetric influence.
inline double acceleration(std::span<const LeaveOneOut> strata) {
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

/// Bias-corrected and accelerated: quantiles of the replicas at Φ(z0 + (z0 ± z)/(1 − a (z0 ± z))).
///
/// z0: from the share of replicas below the value. a: Σ d³/(6 (Σ d²)^1.5) of the jackknife's d = θ_(·) − θ_(i), by
/// stratum with its factor (n_g − 1)/n_g. A share of 0 or 1 is taken half a replica inwards. Source: Efron, J. Am.
/// Stat. Assoc. 82 (1987) 171, (4.4), (6.6).
inline Interval bca_interval(double value, std::vector<double> replicas, std::span<const LeaveOneOut> strata,
                             double level = 0.95) {
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

/// Studentised: value − q SE, q the quantiles of (replica − value)/(its own standard error).
///
/// replica_errors: of each replica; those that are not > 0 are passed over.
/// Source: Efron, Tibshirani (1993), ch. 12.
inline Interval bootstrap_t_interval(const Estimate& value, std::span<const double> replicas,
                                     std::span<const double> replica_errors, double level = 0.95) {
    if (replicas.size() != replica_errors.size()) throw InvalidArgument("expected a standard error for each replica");
    std::vector<double> studentised;
    for (std::size_t i = 0; i < replicas.size(); ++i)
        if (replica_errors[i] > 0.0) studentised.push_back((replicas[i] - value.value) / replica_errors[i]);
    std::sort(studentised.begin(), studentised.end());
    return {value.value - sorted_quantile(studentised, 0.5 * (1.0 + level)) * value.standard_error,
            value.value - sorted_quantile(studentised, 0.5 * (1.0 - level)) * value.standard_error, level};
}

}  // namespace setae::tests
