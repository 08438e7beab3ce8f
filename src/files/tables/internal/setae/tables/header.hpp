// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/units.hpp"

namespace setae::tables {

/// Name and unit of a header cell; the unit is empty if missing.
struct HeaderCell {
    std::string name;
    std::string unit;
};

/// Splits "force [mN]", "force (mN)", "force / mN", "force in mN", "force, mN" and, for lengths, forces, areas and
/// times, "Lateral um" and "force_mN".
[[nodiscard]] HeaderCell parse_header_cell(std::string_view cell);

/// Names and units of `columns` columns from the header lines before them, the last of which may be a row of units.
/// @throws InvalidArgument if a name and the row of units have different units.
[[nodiscard]] std::vector<HeaderCell> parse_header(const std::vector<std::string>& header, char separator,
                                                   std::size_t least, std::size_t most);

/// The unit; empty for text that is no unit.
[[nodiscard]] std::optional<Unit> try_parse_unit(std::string_view text);

/// Whether text is a unit of that dimension.
[[nodiscard]] bool is_unit_of(std::string_view text, const Dimension& dimension);

}  // namespace setae::tables
