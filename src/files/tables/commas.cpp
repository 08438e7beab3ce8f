// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/commas.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::tables {

std::optional<DoubtfulCell> undecided_commas(const std::vector<std::string_view>& lines, const Layout& layout) {
    if (layout.dialect.decimal_point != ',' || layout.dialect.separator == ';') return std::nullopt;
    std::vector<std::string_view> cells;
    std::optional<DoubtfulCell> doubtful;
    for (std::size_t i = layout.first_row; i < lines.size(); ++i) {
        const auto line = trimmed(lines[i]);
        if (is_comment(line)) continue;
        split_cells(lines[i], layout.dialect.separator, cells);
        for (const auto cell : cells) {
            if (cell.find(',') == std::string_view::npos) continue;
            if (!is_grouped(cell, ',')) return std::nullopt;
            if (!doubtful) doubtful = DoubtfulCell{std::string(cell), i + 1};
        }
    }
    return doubtful;
}

std::optional<DoubtfulCell> undecided_points(const std::vector<std::string_view>& lines, const Layout& layout) {
    if (layout.dialect.decimal_point != '.' || layout.dialect.separator != ';') return std::nullopt;
    struct Column {
        bool whole = false;  ///< a number without a point
        bool zeros = false;  ///< a group that cannot be the end of decimals
        std::optional<DoubtfulCell> first;
    };
    std::vector<Column> columns(layout.columns);
    std::vector<std::string_view> cells;
    for (std::size_t i = layout.first_row; i < lines.size(); ++i) {
        const auto line = trimmed(lines[i]);
        if (line.empty() || is_comment(line)) continue;
        if (line.find('.') == std::string_view::npos) {
            for (auto& column : columns) column.whole = true;
            continue;
        }
        split_cells(lines[i], layout.dialect.separator, cells);
        for (std::size_t k = 0; k < std::min(cells.size(), columns.size()); ++k) {
            const auto cell = cells[k];
            if (cell.empty()) continue;
            const bool pointed = cell.find('.') != std::string_view::npos;
            if (pointed && !is_grouped(cell, '.')) return std::nullopt;
            columns[k].whole |= !pointed;
            columns[k].zeros |= pointed && cell.ends_with('0');
            if (pointed && !columns[k].first) columns[k].first = DoubtfulCell{std::string(cell), i + 1};
        }
    }
    for (const auto& column : columns)
        if (column.whole && column.zeros) return column.first;
    return std::nullopt;
}

void require_separating_commas(const std::vector<std::string>& header, std::string_view first_row, std::size_t line,
                               const Layout& layout, const std::string& name) {
    if (layout.dialect.separator != ',' || header.empty()) return;
    std::vector<std::string_view> cells;
    split_cells(header.back(), ',', cells);
    if (cells.size() < 2 || 2 * cells.size() != layout.columns || first_row.find('.') != std::string_view::npos) return;
    throw FormatError(
        name, {.line = line},
        fmt::format("{} numbers between commas below {} names: the comma seems to separate columns and also to mark "
                    "decimals; export with semicolons or tabs, or with decimal points",
                    layout.columns, cells.size()));
}

}  // namespace setae::tables
