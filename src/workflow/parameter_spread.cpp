// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/workflow/parameter_spread.hpp"

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/resampling.hpp"

namespace setae::workflow {

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

Estimate ParameterSpread::estimate(double value, const Function& f) const {
    Estimate result{value, standard_error(f), "bootstrap percentile"};
    std::vector<double> values;
    for (const auto& replica : replicas) values.push_back(f(replica));
    if (replicas.size() >= 40 && sources.empty()) result.interval = percentile_interval(std::move(values));
    return result;
}

}  // namespace setae::workflow
