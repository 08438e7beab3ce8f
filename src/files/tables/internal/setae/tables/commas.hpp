// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/tables/dialect.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// A cell with a sign that may be a decimal mark or a thousands separator, if no other cell is decisive: "1,234".
struct DoubtfulCell {
    std::string cell;
    std::size_t line = 0;  ///< from 1
};

/// The first doubtful cell of rows from layout.first_row on; empty if the layout or a cell is decisive.
[[nodiscard]] std::optional<DoubtfulCell> undecided_commas(const std::vector<std::string_view>& lines,
                                                           const Layout& layout);

/// The first doubtful cell for points with semicolons, where decimals would have commas: a column with "12.000" and
/// "999", which no single convention gives.
[[nodiscard]] std::optional<DoubtfulCell> undecided_points(const std::vector<std::string_view>& lines,
                                                           const Layout& layout);

/// Refuses integers separated by commas, twice as many as names: commas that are both separator and decimal mark.
/// @throws FormatError with the line of the first row.
void require_separating_commas(const std::vector<std::string>& header, std::string_view first_row, std::size_t line,
                               const Layout& layout, const std::string& name);

}  // namespace setae::tables
