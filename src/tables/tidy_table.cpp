// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/tidy_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/text.hpp"
#include "setae/core/units.hpp"

namespace setae::tables {
namespace {

/// Text on one line, behind an apostrophe where a spreadsheet would take it for a formula.
std::string harmless(const std::string& text) {
    const bool formula = !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
    return (formula ? "'" : "") + one_line(text);
}

std::string quoted(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"') result += '"';
        result += c;
    }
    return result + '"';
}

std::string csv_cell(const TidyTable::Cell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) return quoted(harmless(*text));
    const double number = std::get<double>(cell);
    return std::isnan(number) ? "" : fmt::format("{}", number);
}

std::string text_cell(const TidyTable::Cell& cell, int digits) {
    if (const auto* text = std::get_if<std::string>(&cell)) return one_line(*text);
    return format_value(std::get<double>(cell), "1", digits);
}

/// Characters on screen: UTF-8 continuation bytes take no room.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t to, bool right) {
    const std::string blanks(to - width(text), ' ');
    return right ? blanks + text : text + blanks;
}

}  // namespace

std::string as_csv(const TidyTable& table) {
    std::string csv;
    const auto append = [&csv](std::size_t column, const std::string& cell) { csv += (column > 0 ? "," : "") + cell; };
    for (std::size_t i = 0; i < table.columns.size(); ++i) append(i, quoted(table.columns[i]));
    csv += '\n';
    for (const auto& row : table.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) append(i, csv_cell(row[i]));
        csv += '\n';
    }
    return csv;
}

std::string as_text(const TidyTable& table, int significant_digits) {
    std::vector<std::size_t> widths;
    for (const auto& name : table.columns) widths.push_back(width(name));
    std::vector<std::vector<std::string>> cells;
    for (const auto& row : table.rows) {
        cells.emplace_back();
        for (std::size_t i = 0; i < row.size(); ++i) {
            cells.back().push_back(text_cell(row[i], significant_digits));
            widths[i] = std::max(widths[i], width(cells.back().back()));
        }
    }
    std::string text = table.title.empty() ? "" : table.title + "\n";
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const bool right = !table.rows.empty() && std::holds_alternative<double>(table.rows.front()[i]);
        text += "  " + padded(table.columns[i], widths[i], right);
    }
    text += '\n';
    for (std::size_t r = 0; r < cells.size(); ++r) {
        for (std::size_t i = 0; i < cells[r].size(); ++i)
            text += "  " + padded(cells[r][i], widths[i], std::holds_alternative<double>(table.rows[r][i]));
        text += '\n';
    }
    return text;
}

}  // namespace setae::tables
