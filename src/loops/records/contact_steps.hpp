// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/loops/segments.hpp"

namespace setae::loops {

/// Sudden changes of the force within contact: slips of the contact, steps of the sensor, knocks.
///
/// A jump counts where it exceeds 2 % of the largest tension and what the force changes by in half of the window whose
/// line shows it. The samples next to the turn, a hold and the jumps into and out of contact are left out.
/// level: force counted from its zero.
[[nodiscard]] std::vector<ForceStep> steps_in_contact(const Loop& level, const Segments& segments);

}  // namespace setae::loops
