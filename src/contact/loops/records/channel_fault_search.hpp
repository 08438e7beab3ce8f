// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/loops/channel_fault.hpp"
#include "setae/loops/loop.hpp"

namespace setae::loops {

/// The error in the columns of a record without a visible contact: the one whose correction gives a contact with a jump
/// into it or out of it. Empty where none does. Columns are treated as swapped only where the force consists of two
/// straight lines in time, like a stage (with less than 2 % of its variance remaining), and the displacement does not
/// (more than 10 %).
[[nodiscard]] std::optional<ChannelFault> channel_fault(const Loop& loop);

}  // namespace setae::loops
