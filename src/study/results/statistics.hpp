// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/units.hpp"

namespace setae::study {

/// Mean of estimates of one thing; its standard error is the larger of what theirs give and of what their scatter
/// gives.
[[nodiscard]] Estimate mean_of(const std::vector<Estimate>& values);

[[nodiscard]] double mean_of(const std::vector<double>& values);

}  // namespace setae::study
