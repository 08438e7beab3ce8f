// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace setae::tables {

/// A table for readers: texts and numbers in named columns, the unit in the name ("value [m]").
struct TidyTable {
    using Cell = std::variant<std::string, double>;
    std::string title;
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;
};

/// CSV with full round-trip numbers, NaN as empty cell, texts in quotes if they contain a comma, quote or line break.
[[nodiscard]] std::string as_csv(const TidyTable& table);

/// Aligned columns for a terminal, numbers with `significant_digits`, "–" for NaN.
[[nodiscard]] std::string as_text(const TidyTable& table, int significant_digits = 4);

/// Aligned columns without empty ones ("" or "–" in every row). If rows do not fit into the width in characters, texts
/// of the last column are continued below, if there is space; otherwise rows are stacked: the first cell, then one line
/// per further cell.
[[nodiscard]] std::string as_text_within(const TidyTable& table, std::size_t width, int significant_digits = 4);

/// The columns of these names, in this order; names that the table lacks are left out.
[[nodiscard]] TidyTable with_columns(const TidyTable& table, const std::vector<std::string>& names);

/// A table of several rows whose columns with one value throughout are in the title: "filter none; points 1024".
[[nodiscard]] TidyTable constants_in_title(const TidyTable& table, int significant_digits = 4);

}  // namespace setae::tables
