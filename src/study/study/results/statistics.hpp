// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/core/estimate.hpp"

namespace setae::study {

/// Mean of estimates of one thing, as mixed_model() makes it of a single surface: their scatter beyond their own
/// standard errors is a variance between them, and the interval is Student's. Of one estimate itself.
[[nodiscard]] Estimate mean_of(const std::vector<Estimate>& values);

/// The mean with the weight of each value, variances fixed.
struct WeightedMean {
    Estimate mean;
    Array1D weights;
};
[[nodiscard]] WeightedMean weighted_mean_of(const std::vector<Estimate>& values);

[[nodiscard]] double mean_of(const std::vector<double>& values);

}  // namespace setae::study
