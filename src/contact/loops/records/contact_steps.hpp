// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/loops/segments.hpp"

namespace setae::loops {

/// Sudden changes of the force within contact: slips of the contact, steps of the sensor, knocks.
///
/// Searched in windows of a third of each branch, at most 120 samples: a cubic with a step must fit better than a
/// polynomial of degree six, and the step must exceed 2 % of the largest tension. The samples next to the turns, a hold
/// and the jumps into and out of contact are left out.
/// level: force relative to its zero. bends: further samples at which the force may bend, such as the first motion of
/// the edge.
[[nodiscard]] std::vector<ForceStep> steps_in_contact(const Loop& level, const Segments& segments,
                                                      const std::vector<Index>& bends);

}  // namespace setae::loops
