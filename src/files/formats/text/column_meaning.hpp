// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/tables/table_file.hpp"

namespace setae::formats {

/// Whether a name is one of positions along a profile: x, position, distance, lateral, scan length …
[[nodiscard]] bool is_position_name(const std::string& name);

/// Whether a column counts its rows: 0, 1, 2 … or 1, 2, 3 …
[[nodiscard]] bool counts_rows(const Array1D& values);

/// Why a column of a table contains no heights: another quantity in its name, a unit that is no length, numbers of
/// rows. Empty if heights are possible.
[[nodiscard]] std::string reason_against_heights(const tables::RawTable::RawColumn& column);

/// The quantity other than a position in the name of a column, such as "time"; empty if there is none.
[[nodiscard]] std::string other_quantity(const std::string& name);

}  // namespace setae::formats
