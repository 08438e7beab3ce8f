// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::formats {

/// The column of x in a table of x and the heights of one or several profiles; empty if there is none.
///
/// It is the first column, the second after numbers of rows, or one with the name of positions after other quantities
/// such as the time, if a later column has the name of heights. Its positions are defined and never turn, or run forth
/// and back (passes_of()). Unless the user declares profiles, its name or its unit must be one of positions; a column
/// named y after it makes the table one of points x, y, z, and a column of time or forces one of a record, unless x has
/// the name of positions. declared: the user declares profiles.
[[nodiscard]] std::optional<std::size_t> positions_of_profiles(const tables::RawTable& table, bool declared);

/// The columns x, y and heights of a table with one name of each, in this order; empty for other tables.
[[nodiscard]] std::optional<tables::RawTable> named_points(const tables::RawTable& table);

/// Positions that are defined and never turn, or run back and forth.
[[nodiscard]] bool run_along(const Array1D& positions);

/// The profiles of such a table as channels; columns without heights are listed with the reason.
[[nodiscard]] std::vector<Channel> profile_channels(const tables::RawTable& table, std::size_t positions,
                                                    const std::vector<Alert>& alerts, const ReadOptions& options,
                                                    const bytes::Source& source);

}  // namespace setae::formats
