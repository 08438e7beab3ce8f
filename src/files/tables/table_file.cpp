// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/table_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/commas.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/spreadsheet.hpp"
#include "setae/tables/text_numbers.hpp"

namespace setae::tables {
namespace {

/// Index of the first possible line of numbers.
std::size_t after_header_end(const std::vector<std::string_view>& lines, const TableOptions& options,
                             const std::string& name) {
    if (!options.header_end) return 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (trimmed(lines[i]) == *options.header_end) return i + 1;
    throw FormatError(
        name, {.line = lines.size()},
        fmt::format("no line '{}' ends the header; check header_end of the mapping", *options.header_end));
}

/// Numbers column by column, with properties of the cells of the columns.
struct Numbers {
    Array2D values;                  ///< (columns, rows)
    std::vector<bool> has_text;      ///< per column: any cell that is not empty
    std::vector<std::string> words;  ///< per column: its first cell and line, if it contains text
};

/// Calls `take` with line number, from 0, and cells of every row.
template <class Take>
void for_each_row(const std::vector<std::string_view>& lines, const Layout& layout, const std::string& name,
                  const Take& take) {
    std::vector<std::string_view> cells;
    for (std::size_t i = layout.first_row; i < lines.size(); ++i) {
        const auto line = trimmed(lines[i]);
        if (line.empty() || is_comment(line)) continue;
        split_cells(lines[i], layout.dialect.separator, cells);
        while (cells.size() > layout.columns && cells.back().empty()) cells.pop_back();
        if (cells.size() != layout.columns)
            throw FormatError(
                name, {.line = i + 1},
                fmt::format("{} columns, expected {} as in the other lines; the file may be truncated here",
                            cells.size(), layout.columns));
        take(i, cells);
    }
}

/// Rows of numbers with columns of words.
Numbers parse_rows_with_words(const std::vector<std::string_view>& lines, const Layout& layout,
                              const std::string& name) {
    const auto columns = layout.columns;
    Numbers numbers{{}, std::vector<bool>(columns, false), std::vector<std::string>(columns)};
    std::vector<double> values;
    values.reserve((lines.size() - layout.first_row) * columns);
    for_each_row(lines, layout, name, [&](std::size_t i, const std::vector<std::string_view>& cells) {
        for (std::size_t k = 0; k < columns; ++k) {
            double value = undefined;
            if (layout.text[k]) {
                if (numbers.words[k].empty() && !cells[k].empty())
                    numbers.words[k] = fmt::format("'{:.40}' on line {}", cells[k], i + 1);
            } else if (!parse_cell(cells[k], layout.dialect, value))
                throw FormatError(name, {.line = i + 1},
                                  described({.cell = std::string(cells[k]), .line = i + 1, .column = k + 1}));
            values.push_back(value);
            if (!cells[k].empty()) numbers.has_text[k] = true;
        }
    });
    using Rows = Eigen::Map<const Array2D>;
    numbers.values =
        Rows(values.data(), static_cast<Index>(values.size() / columns), static_cast<Index>(columns)).transpose();
    return numbers;
}

/// Rows of numbers only, on all cores.
Numbers parse_rows(const std::string& text, const std::vector<std::string_view>& lines, const Layout& layout,
                   const std::string& name) {
    const auto columns = layout.columns;
    TextStart start;
    start.source = {name, text.size(), {}, [&text](std::uint64_t offset, std::uint64_t count, char* target) {
                        std::memcpy(target, text.data() + offset, count);
                    }};
    start.layout = layout;
    start.begin = static_cast<std::uint64_t>(lines[layout.first_row].data() - text.data());
    start.line = layout.first_row;
    const auto rows = find_number_lines(start, start.begin, text.size());
    require_whole_last_line(rows);
    Numbers numbers{read_numbers(rows), std::vector<bool>(columns, true), std::vector<std::string>(columns)};
    const auto last = static_cast<Index>(columns - 1);
    if (numbers.values.row(last).isNaN().all()) {  // words for undefined numbers, or rows that end in separators
        numbers.has_text.assign(columns, false);
        for_each_row(lines, layout, name, [&](std::size_t, const std::vector<std::string_view>& cells) {
            for (std::size_t k = 0; k < columns; ++k)
                if (!cells[k].empty()) numbers.has_text[k] = true;
        });
    }
    return numbers;
}

/// Columns up to the last nonempty one: rows may end in separators.
std::size_t filled_columns(const Numbers& numbers) {
    auto filled = numbers.has_text.size();
    while (filled > 1 && !numbers.has_text[filled - 1]) --filled;
    return filled;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const auto& line : lines) text += (text.empty() ? "" : "\n") + line;
    return text;
}

/// Refuses commas and points that may be decimal marks or thousands separators: "1,234" without a decisive cell.
void require_decided_signs(const std::vector<std::string_view>& lines, const Layout& layout,
                           const TableOptions& options, const std::string& name) {
    if (options.decimal_point) return;
    auto doubtful = undecided_commas(lines, layout);
    if (!doubtful) doubtful = undecided_points(lines, layout);
    if (doubtful)
        throw FormatError(
            name, {.line = doubtful->line},
            fmt::format("'{:.40}' is ambiguous, as is every number with a {} here: it may separate decimals or "
                        "thousands; set decimal = \"comma\" or decimal = \"point\" in [file] of a mapping",
                        doubtful->cell, layout.dialect.decimal_point == ',' ? "comma" : "point"));
}

/// "# key: value" lines.
std::map<std::string, std::string> key_values(const std::vector<std::string>& header) {
    std::map<std::string, std::string> found;
    for (const auto& line : header) {
        if (!is_comment(line)) continue;
        const auto text = trimmed(std::string_view(line).substr(1));
        const auto colon = text.find(':');
        if (colon == std::string_view::npos || colon == 0 || colon > 60) continue;
        found.emplace(trimmed(text.substr(0, colon)), trimmed(text.substr(colon + 1)));
    }
    return found;
}

std::vector<HeaderCell> names_of(const RawTable& table, std::size_t least, std::size_t most, const std::string& name) {
    try {
        return parse_header(table.header, table.separator, least, most);
    } catch (const InvalidArgument& error) {
        throw FormatError(name, {}, error.what());
    }
}

}  // namespace

RawTable read_raw_table(const bytes::Source& source, const TableOptions& options) {
    if (is_spreadsheet(source)) return read_spreadsheet(source, options.sheet);
    if (options.sheet)
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("the file is not a workbook, but its sheet '{}' was given", *options.sheet));
    if (source.size == 0) throw FormatError(source.name, {.offset = 0}, "the file is empty; expected rows of numbers");
    const auto text = bytes::decoded(source.all(), options.encoding);
    auto lines = bytes::split_lines(text);
    const auto begin = after_header_end(lines, options, source.name);
    const std::vector<std::string_view> body(lines.begin() + static_cast<std::ptrdiff_t>(begin), lines.end());
    auto layout = find_layout(body, options);
    if (!layout) layout = find_layout_with_words(body, options);
    if (!layout)
        throw FormatError(source.name, {.line = begin + 1},
                          "the file has no row of numbers; expected columns of numbers below a header");
    layout->first_row += begin;
    if (const auto broken = broken_row_above(lines, *layout); broken && broken->line > begin && layout->text.empty())
        throw FormatError(source.name, {.line = broken->line}, described(*broken));
    require_decided_signs(lines, *layout, options, source.name);
    const auto numbers = layout->text.empty() ? parse_rows(text, lines, *layout, source.name)
                                              : parse_rows_with_words(lines, *layout, source.name);

    RawTable table{{}, {}, {}, layout->dialect.separator, layout->dialect.decimal_point};
    for (std::size_t i = 0; i < layout->first_row; ++i) {
        if (options.header_end && i + 1 == begin) continue;
        if (const auto line = trimmed(lines[i]); !line.empty()) table.header.emplace_back(line);
    }
    if (!options.separator && !options.decimal_point)
        require_separating_commas(table.header, lines[layout->first_row], layout->first_row + 1, *layout, source.name);
    table.metadata = key_values(table.header);
    const auto filled = filled_columns(numbers);
    const auto names = names_of(table, filled, layout->columns, source.name);
    const auto columns = names.empty() ? filled : names.size();
    for (std::size_t k = 0; k < columns; ++k) {
        const auto cell = names.empty() ? HeaderCell{} : names[k];
        table.columns.push_back({cell.name, cell.unit, numbers.values.row(static_cast<Index>(k)), numbers.words[k]});
    }
    return table;
}

Table read_table(const std::string& path, const TableOptions& options) {
    return table_in_si(read_raw_table(bytes::file_source(path), options), path);
}

Table table_in_si(const RawTable& raw, const std::string& path) {
    Table table;
    table.metadata = raw.metadata;
    table.metadata["file"] = path;
    if (!raw.header.empty()) table.metadata["header"] = joined(raw.header);
    for (std::size_t k = 0; k < raw.columns.size(); ++k) {
        const auto& column = raw.columns[k];
        const auto name = column.name.empty() ? fmt::format("column_{}", k + 1) : column.name;
        const auto unit = try_parse_unit(column.unit);
        if (unit) table.columns.push_back({name, si_unit(unit->dimension), column.values * unit->factor});
        else table.columns.push_back({name, column.unit, column.values});
    }
    return table;
}

std::string as_csv(const Table& table) {
    std::string text;
    for (const auto& column : table.columns) {
        if (column.values.size() != table.rows())
            throw InvalidArgument(
                fmt::format("column '{}' has {} rows, expected {}", column.name, column.values.size(), table.rows()));
        if ((column.name + column.unit).find_first_of(",\"\r\n") != std::string::npos)
            throw InvalidArgument(fmt::format("column name '{}' contains a comma, quote or line break", column.name));
        if (&column != &table.columns.front()) text += ',';
        text += column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
    }
    text += '\n';
    for (Index i = 0; i < table.rows(); ++i) {
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            if (k > 0) text += ',';
            const double value = table.columns[k].values[i];
            if (!std::isnan(value)) fmt::format_to(std::back_inserter(text), "{}", value);
            else if (table.columns.size() == 1) text += "nan";  // a single empty cell would be an empty line
        }
        text += '\n';
    }
    return text;
}

void write_csv(const std::string& path, const Table& table) { bytes::write_whole_file(path, as_csv(table)); }

}  // namespace setae::tables
