// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/units.hpp"

namespace setae::study {

/// Mean of estimates of one thing, as mixed_model() makes it of a single surface: their scatter beyond their own
/// standard errors is a variance between them, and the interval is Student's. Of one estimate itself.
[[nodiscard]] Estimate mean_of(const std::vector<Estimate>& values);

[[nodiscard]] double mean_of(const std::vector<double>& values);

}  // namespace setae::study
