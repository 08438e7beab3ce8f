// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/text_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::tables {
namespace {

/// Lines of cells; a quoted cell may continue over lines.
std::vector<TextTable::Row> rows_of(std::string_view text, char separator, std::size_t line) {
    std::vector<TextTable::Row> rows;
    TextTable::Row row{.line = line};
    std::string cell;
    bool quoted = false, was_quoted = false;
    const auto end_cell = [&] {
        row.cells.push_back(was_quoted ? cell : std::string(trimmed(cell)));
        cell.clear();
        was_quoted = false;
    };
    const auto end_row = [&] {
        end_cell();
        if (row.cells.size() > 1 || !row.cells[0].empty()) rows.push_back(row);
        row = {.line = line + 1};
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted) {
            if (c == '"' && i + 1 < text.size() && text[i + 1] == '"') cell += text[++i];
            else if (c == '"') quoted = false;
            else cell += c;
            if (c == '\n') ++line;
        } else if (c == '"' && trimmed(cell).empty()) {
            quoted = was_quoted = true;
            cell.clear();
        } else if (c == separator) {
            end_cell();
        } else if (c == '\n') {
            end_row();
            ++line;
        } else if (c != '\r') {
            cell += c;
        }
    }
    if (!cell.empty() || !row.cells.empty()) end_row();
    return rows;
}

TextTable::Column column_of(const std::string& heading) {
    const auto open = heading.rfind('['), close = heading.rfind(']');
    if (open == std::string::npos || close == std::string::npos || close < open) return {heading, ""};
    return {std::string(trimmed(heading.substr(0, open))),
            std::string(trimmed(heading.substr(open + 1, close - open - 1)))};
}

}  // namespace

std::optional<std::size_t> TextTable::find(const std::vector<std::string>& wanted) const {
    for (const auto& name : wanted)
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (bytes::lowered(columns[i].name) == bytes::lowered(name)) return i;
    return std::nullopt;
}

std::string TextTable::names() const {
    std::string list;
    for (const auto& column : columns) list += (list.empty() ? "" : ", ") + column.name;
    return list;
}

TextTable read_text_table(const std::string& path) {
    const auto bytes = bytes::read_file(path);
    std::string_view text = bytes;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    std::size_t line = 1;
    while (text.starts_with('#')) {
        const auto end = text.find('\n');
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        ++line;
    }
    TextTable table{.path = path};
    const auto header = text.substr(0, text.find('\n'));
    std::ptrdiff_t most = 0;
    for (const char candidate : {',', ';', '\t'})
        if (const auto n = std::count(header.begin(), header.end(), candidate); n > most) {
            most = n;
            table.separator = candidate;
        }
    table.rows = rows_of(text, table.separator, line);
    if (table.rows.empty())
        throw FormatError(
            path, {}, "the table is empty; expected a header line with names, such as \"surface,lens,spot,W [mJ/m2]\"");
    for (const auto& heading : table.rows.front().cells) table.columns.push_back(column_of(heading));
    table.rows.erase(table.rows.begin());
    for (const auto& row : table.rows)
        if (row.cells.size() != table.columns.size())
            throw FormatError(path, {.line = row.line},
                              fmt::format("{} cells, but the header has {}", row.cells.size(), table.columns.size()));
    return table;
}

}  // namespace setae::tables
