// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/channel_fault.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study {

/// The columns to choose where a record's channels are reversed or swapped, from what was taken: {"force", "-1 *
/// load"}. A sign that was turned already is turned back. Swapped channels keep the units of their roles, as a header
/// names both wrongly; empty where they are computed from several columns.
[[nodiscard]] tables::ChosenColumns columns_that_undo(loops::ChannelFault fault, const tables::ChannelNames& channels);

/// What to type: `use --column force="-1 * load" (in a study columns = { … })`; for swapped channels of a mapping a
/// sentence that says so.
[[nodiscard]] std::string channel_remedy(loops::ChannelFault fault, const tables::ChannelNames& channels);

}  // namespace setae::study
