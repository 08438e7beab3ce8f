// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/study/hysteresis.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// A row per model: its W_ret of a mirror and the reference's own over elastomers [mJ/m²], and whether it tends to
/// that.
[[nodiscard]] tables::TidyTable smooth_limit_table(const study::Hysteresis& hysteresis);

/// For each likeliest model that is not recommended: the model of the predictions, and its error for the smooth
/// reference.
[[nodiscard]] std::vector<std::string> smooth_limit_sentences(const study::Hysteresis& hysteresis);

}  // namespace setae::output
