// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/loops/analysis.hpp"

namespace setae::loops {

/// Warnings of an analysis, from its numbers and the limits.
[[nodiscard]] std::vector<Alert> alerts_of(const LoopAnalysis& analysis, const Loop& loop,
                                           const LensAndCounterBody& bodies, const AlertLimits& limits,
                                           const std::string& subject);

}  // namespace setae::loops
