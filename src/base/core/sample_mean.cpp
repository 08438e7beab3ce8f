// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/sample_mean.hpp"

#include <cmath>

namespace setae {

Estimate sample_mean(const ArrayView1D& values, const std::string& method) {
    const auto n = static_cast<double>(values.size());
    const double mean = values.mean();
    if (values.size() < 2) return {.value = mean};
    return {.value = mean,
            .standard_error = std::sqrt((values - mean).square().sum() / (n * (n - 1.0))),
            .method = method,
            .degrees_of_freedom = n - 1.0};
}

}  // namespace setae
