// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "setae/fields/view.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::output {

/// For files: the heading with the field's unit, "W_app [J/m2]", followed by "W_app standard_error [J/m2]" where fields
/// have errors.
void put_headings(tables::TidyTable& table, std::span<const fields::Column> view);

/// Cells below these headings.
void put_cells(std::vector<tables::TidyTable::Cell>& row, const std::vector<fields::Cell>& cells,
               std::span<const fields::Column> view);
template <fields::HasRows T>
void put_cells(std::vector<tables::TidyTable::Cell>& row, const T& result, std::span<const fields::Column> view) {
    put_cells(row, fields::cells(result, view), view);
}

/// For files: one row a result.
template <fields::HasRows T>
[[nodiscard]] tables::TidyTable table_of(const std::vector<T>& results, std::span<const fields::Column> view) {
    tables::TidyTable table;
    put_headings(table, view);
    for (const auto& result : results) put_cells(table.rows.emplace_back(), result, view);
    return table;
}

/// For screens: "37.0 ± 3.7" in the columns' units, "–" where a result lacks the field.
void put_shown_cells(std::vector<tables::TidyTable::Cell>& row, const std::vector<fields::Cell>& cells);
template <fields::HasRows T>
void put_shown_cells(std::vector<tables::TidyTable::Cell>& row, const T& result, std::span<const fields::Column> view) {
    put_shown_cells(row, fields::cells(result, view));
}

}  // namespace setae::output
