// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/tidy_table.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "setae/core/layout.hpp"
#include "setae/core/spreadsheet_text.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"

namespace setae::tables {
namespace {

std::string csv_cell(const TidyTable::Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return spreadsheet_cell(*text);
    const double number = std::get<double>(cell);
    return std::isnan(number) ? "" : fmt::format("{}", number);
}

std::string text_cell(const TidyTable::Cell& cell, int digits) {
    if (const auto* text = std::get_if<std::string>(&cell)) return one_line(*text);
    return format_value(std::get<double>(cell), "1", digits);
}

std::string padded(const std::string& text, std::size_t to, bool right) {
    const std::string blanks(to - display_width(text), ' ');
    return right ? blanks + text : text + blanks;
}

}  // namespace

std::string as_csv(const TidyTable& table) {
    std::string csv;
    const auto append = [&csv](std::size_t column, const std::string& cell) { csv += (column > 0 ? "," : "") + cell; };
    for (std::size_t i = 0; i < table.columns.size(); ++i) append(i, spreadsheet_cell(table.columns[i]));
    csv += '\n';
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) append(i, csv_cell(row[i]));
        csv += '\n';
    }
    return csv;
}

namespace {

/// Every cell of a table as text, and how wide its columns are.
struct TextCells {
    std::vector<std::vector<std::string>> rows;
    std::vector<std::size_t> widths;
};

TextCells text_cells(const TidyTable& table, int significant_digits) {
    TextCells cells;
    for (const auto& name : table.columns) cells.widths.push_back(display_width(name));
    for (const auto& row : table.rows) {
        cells.rows.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i) {
            cells.rows.back().push_back(text_cell(row[i], significant_digits));
            cells.widths[i] = std::max(cells.widths[i], display_width(cells.rows.back().back()));
        }
    }
    return cells;
}

TidyTable without_empty_columns(const TidyTable& table) {
    const auto silent = [](const TidyTable::Cell& cell) {
        const auto* text = std::get_if<std::string>(&cell);
        return text ? text->empty() || *text == "–" : std::isnan(std::get<double>(cell));
    };
    TidyTable kept{table.title, {}, std::vector<std::vector<TidyTable::Cell>>(table.rows.size())};
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (std::all_of(table.rows.begin(), table.rows.end(), [&](const auto& row) { return silent(row[i]); }))
            continue;
        kept.columns.push_back(table.columns[i]);
        for (std::size_t r = 0; r < table.rows.size(); ++r) kept.rows[r].push_back(table.rows[r][i]);
    }
    return kept;
}

bool is_text(const TidyTable& table, std::size_t column) {
    return std::all_of(table.rows.begin(), table.rows.end(),
                       [column](const auto& row) { return std::holds_alternative<std::string>(row[column]); });
}

std::string stacked(const TidyTable& table, const TextCells& cells) {
    std::size_t names = 0;
    for (std::size_t i = 1; i < table.columns.size(); ++i) names = std::max(names, display_width(table.columns[i]));
    std::string text = table.title.empty() ? "" : table.title + "\n";
    for (const auto& row : cells.rows) {
        text += "  " + row.front() + "\n";
        for (std::size_t i = 1; i < row.size(); ++i)
            if (!row[i].empty() && row[i] != "–")
                text += "    " + padded(table.columns[i], names, false) + "  " + row[i] + "\n";
    }
    return text;
}

/// Width of a row before its last cell, including blanks between columns.
std::size_t before_last(const TextCells& cells) {
    return std::accumulate(cells.widths.begin(), cells.widths.end() - 1, 2 * cells.widths.size());
}

/// Lines of a table: columns as wide as their widest cell; a last cell beyond `width` is continued below.
std::string aligned(const TidyTable& table, const TextCells& cells, std::size_t width = std::string::npos) {
    if (table.columns.empty()) return table.title.empty() ? "" : table.title + "\n";
    const auto indent = before_last(cells);
    const auto line = [&](auto cell, auto right) {
        std::string text;
        const auto last = table.columns.size() - 1;
        for (std::size_t i = 0; i < last; ++i) text += "  " + padded(cell(i), cells.widths[i], right(i));
        if (indent + display_width(cell(last)) <= width)
            text += "  " + padded(cell(last), cells.widths[last], right(last));
        else text += "  " + wrapped_from(indent, cell(last), width);
        return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
    };
    std::string text = table.title.empty() ? "" : table.title + "\n";
    text += line(
        [&](std::size_t i) { return table.columns[i]; },
        [&](std::size_t i) { return !table.rows.empty() && std::holds_alternative<double>(table.rows.front()[i]); });
    for (std::size_t r = 0; r < cells.rows.size(); ++r)
        text += line([&](std::size_t i) { return cells.rows[r][i]; },
                     [&](std::size_t i) { return std::holds_alternative<double>(table.rows[r][i]); });
    return text;
}

}  // namespace

std::string as_text(const TidyTable& table, int significant_digits) {
    return aligned(table, text_cells(table, significant_digits));
}

std::string as_text_within(const TidyTable& table, std::size_t width, int significant_digits) {
    const auto shown = without_empty_columns(table);
    const auto cells = text_cells(shown, significant_digits);
    if (shown.columns.empty()) return stacked(shown, cells);
    constexpr std::size_t min_for_text = 30;
    const auto last = before_last(cells);
    const bool fits = last + cells.widths.back() <= width;
    const bool wraps =
        last + min_for_text <= width && shown.columns.size() > 1 && is_text(shown, shown.columns.size() - 1);
    return fits || wraps ? aligned(shown, cells, width) : stacked(shown, cells);
}

TidyTable with_columns(const TidyTable& table, const std::vector<std::string>& names) {
    TidyTable kept{table.title, {}, std::vector<std::vector<TidyTable::Cell>>(table.rows.size())};
    for (const auto& name : names) {
        const auto found = std::find(table.columns.begin(), table.columns.end(), name);
        if (found == table.columns.end()) continue;
        kept.columns.push_back(name);
        const auto column = static_cast<std::size_t>(found - table.columns.begin());
        for (std::size_t r = 0; r < table.rows.size(); ++r) kept.rows[r].push_back(table.rows[r][column]);
    }
    return kept;
}

TidyTable constants_in_title(const TidyTable& table, int significant_digits) {
    if (table.rows.size() < 2) return table;
    const auto shown = without_empty_columns(table);
    const auto cells = text_cells(shown, significant_digits);
    std::vector<std::string> others;
    std::string constants;
    for (std::size_t i = 0; i < shown.columns.size(); ++i) {
        const auto& value = cells.rows.front()[i];
        const bool constant =
            std::all_of(cells.rows.begin(), cells.rows.end(), [&](const auto& row) { return row[i] == value; });
        if (constant) constants += fmt::format("{}{} {}", constants.empty() ? "" : "; ", shown.columns[i], value);
        else others.push_back(shown.columns[i]);
    }
    auto rest = with_columns(shown, others);
    if (!constants.empty()) rest.title += (rest.title.empty() ? "" : ": ") + constants;
    return rest;
}

}  // namespace setae::tables
