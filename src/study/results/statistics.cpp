// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace setae::study {

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Estimate mean_of(const std::vector<Estimate>& values) {
    const auto n = static_cast<double>(values.size());
    Estimate mean{.method = values.size() > 1 ? "mean over loops" : values.front().method};
    double given = 0.0, scatter = 0.0;
    for (const auto& v : values) {
        mean.value += v.value / n;
        given += v.variance() / (n * n);
    }
    for (const auto& v : values) scatter += std::pow(v.value - mean.value, 2) / (n * std::max(1.0, n - 1.0));
    mean.standard_error = std::sqrt(std::max(given, scatter));
    return mean;
}

}  // namespace setae::study
