// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics.hpp"

#include <numeric>
#include <utility>

#include "setae/statistics/mixed_model.hpp"

namespace setae::study {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

WeightedMean weighted_mean_of(const std::vector<Estimate>& values) {
    if (values.size() == 1) return {values.front(), Array1D::Ones(1)};
    statistics::ReplicateData data{.levels = {"all"}};
    for (const auto& value : values)
        data.rows.push_back({value.value, value.uncertain() ? value.standard_error : undefined, {"all"}, ""});
    auto of_all = statistics::mixed_model(data, {.influence = false}).surfaces.front();
    of_all.mean.method = "mean over loops";
    return {std::move(of_all.mean), std::move(of_all.weights)};
}

Estimate mean_of(const std::vector<Estimate>& values) { return weighted_mean_of(values).mean; }

}  // namespace setae::study
