// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/loops/channel_fault.hpp"
#include "setae/loops/loop.hpp"

namespace setae::loops {

/// The mistake in the columns of a record in which no contact is found as it is: the one without which a contact with a
/// jump into it or out of it shows. Nothing where none does. Columns count as swapped only where the force draws two
/// straight lines in time, as a stage does (they leave less than 2 % of its variance), and the displacement does not
/// (more than 10 %).
[[nodiscard]] std::optional<ChannelFault> channel_fault(const Loop& loop);

}  // namespace setae::loops
