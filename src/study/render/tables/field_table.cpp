// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/field_table.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/uncertain_text.hpp"

namespace setae::output {

using tables::TidyTable;

void put_headings(TidyTable& table, std::span<const fields::Column> view) {
    for (const auto& column : view) {
        const auto unit = column.row->unit;
        const auto in = unit.empty() || unit == "1" ? "" : fmt::format(" [{}]", unit);
        table.columns.push_back(std::string(column.heading) + in);
        if (has_error(column)) table.columns.push_back(fmt::format("{} standard_error{}", column.heading, in));
    }
}

void put_cells(std::vector<TidyTable::Cell>& row, const std::vector<fields::Cell>& cells,
               std::span<const fields::Column> view) {
    for (std::size_t i = 0; i < view.size(); ++i) {
        row.push_back(cells[i].value);
        if (has_error(view[i])) row.emplace_back(cells[i].standard_error);
    }
}

void put_shown_cells(std::vector<TidyTable::Cell>& row, const std::vector<fields::Cell>& cells) {
    for (const auto& cell : cells) {
        const auto* number = std::get_if<double>(&cell.value);
        if (!number) row.push_back(cell.value);
        else if (std::isnan(*number)) row.emplace_back("–");
        else row.emplace_back(uncertain_number({.value = *number, .standard_error = cell.standard_error}));
    }
}

}  // namespace setae::output
