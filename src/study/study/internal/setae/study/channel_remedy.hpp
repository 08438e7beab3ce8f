// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/channel_fault.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study {

/// Columns that correct reversed or swapped channels of a record, from the present columns: {"force", "-1 * load"}. A
/// sign that was reversed already is restored. Swapped channels keep the units of their roles, as a header names both
/// wrongly; empty where they are computed from several columns.
[[nodiscard]] tables::ChosenColumns columns_that_undo(loops::ChannelFault fault, const tables::ChannelNames& channels);

/// Remedy for users: `use --column force="-1 * load" (in a study columns = { … })`; for swapped channels of a mapping a
/// sentence.
[[nodiscard]] std::string channel_remedy(loops::ChannelFault fault, const tables::ChannelNames& channels);

}  // namespace setae::study
