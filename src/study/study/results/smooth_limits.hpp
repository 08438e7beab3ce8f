// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/study/hysteresis.hpp"

namespace setae::study {

/// Every ranked model against the smooth reference of every elastomer that has one, elastomers in the study's order,
/// models in the ranking's: hysteresis::smooth_limit() of both branches' means over its references.
[[nodiscard]] std::vector<ReferenceLimit> smooth_limits(const StudyResult& result, const hysteresis::Ranking& ranking);

}  // namespace setae::study
