// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/tables/dialect.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// A cell with a sign that may begin decimals or group thousands, where no other cell decides: "1,234".
struct DoubtfulCell {
    std::string cell;
    std::size_t line = 0;  ///< from 1
};

/// The first doubtful cell of rows from layout.first_row on; nothing where the layout leaves no doubt or a cell
/// decides.
[[nodiscard]] std::optional<DoubtfulCell> undecided_commas(const std::vector<std::string_view>& lines,
                                                           const Layout& layout);

/// The same of points between semicolons, where decimals would be commas: a column of "12.000" beside "999", which no
/// one way of writing decimals gives.
[[nodiscard]] std::optional<DoubtfulCell> undecided_points(const std::vector<std::string_view>& lines,
                                                           const Layout& layout);

/// Refuses integers at commas, twice as many as names: commas that separate and begin decimals.
/// @throws FormatError with the line of the first row.
void require_separating_commas(const std::vector<std::string>& header, std::string_view first_row, std::size_t line,
                               const Layout& layout, const std::string& name);

}  // namespace setae::tables
