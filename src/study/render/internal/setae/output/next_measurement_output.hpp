// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/adhesion/next_measurement.hpp"
#include "setae/output/json.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// One row per measurement, in order: standard error of `target` with it [mJ/m²].
[[nodiscard]] tables::TidyTable next_table(const std::string& target,
                                           const std::vector<adhesion::NextMeasurement>& measurements);
/// The same in SI.
[[nodiscard]] Json next_json(const std::string& target, const std::vector<adhesion::NextMeasurement>& measurements);

}  // namespace setae::output
