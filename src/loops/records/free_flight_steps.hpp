// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/loops/force_drift.hpp"
#include "setae/loops/loop.hpp"

namespace setae::loops {

/// The part of free flight next to contact, cut at sudden steps of the force, which are added to `steps`.
///
/// A step is where a line that changes its level there fits the force better than a cubic curve does, and the change
/// exceeds six standard errors, correlated noise allowed for. Each part keeps eight samples.
/// Cost: linear, for each step.
[[nodiscard]] IndexRange cut_at_steps(const Loop& loop, IndexRange range, bool before_contact,
                                      std::vector<ForceStep>& steps);

}  // namespace setae::loops
