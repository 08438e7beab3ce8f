// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics.hpp"

#include <numeric>

#include "setae/statistics/mixed_model.hpp"

namespace setae::study {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Estimate mean_of(const std::vector<Estimate>& values) {
    if (values.size() == 1) return values.front();
    statistics::ReplicateData data{.levels = {"all"}};
    for (const auto& value : values)
        data.rows.push_back({value.value, value.uncertain() ? value.standard_error : undefined, {"all"}, ""});
    auto mean = statistics::mixed_model(data, {.influence = false}).surfaces.front().mean;
    mean.method = "mean over loops";
    return mean;
}

}  // namespace setae::study
