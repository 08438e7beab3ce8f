// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/loops/force_drift.hpp"
#include "setae/loops/loop.hpp"

namespace setae::loops {

/// The part of free flight next to contact, cut at sudden steps of the force, which are added to `steps`.
/// A line that steps must fit better than a cubic, and the step must exceed 0.1 % of the range of the force.
[[nodiscard]] IndexRange cut_at_steps(const Loop& loop, IndexRange range, bool before_contact,
                                      std::vector<ForceStep>& steps);

}  // namespace setae::loops
