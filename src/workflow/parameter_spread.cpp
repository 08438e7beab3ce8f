// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/workflow/parameter_spread.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"

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

std::optional<Interval> ParameterSpread::interval(const Function& f) const {
    if (replicas.size() < 40 || !sources.empty()) return std::nullopt;
    std::vector<double> values;
    for (const auto& replica : replicas) values.push_back(f(replica));
    std::sort(values.begin(), values.end());
    const auto at = [&](double p) { return values[static_cast<std::size_t>(p * static_cast<double>(values.size() - 1) + 0.5)]; };
    return Interval{at(0.025), at(0.975), 0.95};
}

}  // namespace setae::workflow
