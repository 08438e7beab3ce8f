// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/spreadsheet.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/column_guess.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/workbook.hpp"

namespace setae::tables {
namespace {

/// A number of a cell; cells have decimal points in every locale of the program.
bool is_number(const std::string& cell) {
    double value = undefined;
    return bytes::parse_cell(cell, '.', value) && !std::isnan(value);
}

/// Converts cells of text with numbers and decimal commas to points, column by column, if one of the cells of the
/// column shows that its comma is no thousands separator.
void read_decimal_commas(SheetRows& rows) {
    const Dialect comma{.separator = '\t', .decimal_point = ',', .grouped = true};
    struct Found {
        std::vector<std::string*> cells;
        bool decided = false;
    };
    std::map<std::size_t, Found> columns;
    for (auto& [row, cells] : rows)
        for (auto& [column, cell] : cells) {
            double value = 0.0;
            if (cell.find(',') == std::string::npos || is_number(cell) || !parse_cell(cell, comma, value) ||
                std::isnan(value))
                continue;
            columns[column].cells.push_back(&cell);
            columns[column].decided = columns[column].decided || !is_grouped(cell, ',');
        }
    for (auto& [column, found] : columns)
        for (auto* cell : found.cells) {
            double value = 0.0;
            if (found.decided && parse_cell(*cell, comma, value)) *cell = fmt::format("{}", value);
        }
}

/// Refuses a sheet of formulas without stored results, as written by programs other than spreadsheets.
void require_results(const SheetRows& rows, const Sheet& sheet, const bytes::Source& source) {
    std::size_t numbers = 0, formulas = 0;
    std::string first;
    for (const auto& [row, cells] : rows)
        for (const auto& [column, cell] : cells) {
            numbers += is_number(cell) ? 1 : 0;
            if (!cell.starts_with('=') || !cell.ends_with(formula_without_result)) continue;
            if (formulas++ == 0) first = cell_name(row, column);
        }
    if (formulas > 1 && 2 * formulas >= numbers)
        throw FormatError(
            source.name, {},
            fmt::format("sheet '{}' has {} formulas without stored results, the first in cell {}; open the workbook in "
                        "Excel or LibreOffice and save it again",
                        sheet.name, formulas, first));
}

SheetRows rows_of_sheet(const Workbook& book, const Sheet& sheet, const bytes::Source& source) {
    auto rows = book.rows(sheet);
    require_results(rows, sheet, source);
    read_decimal_commas(rows);
    return rows;
}

/// Place of the table of a sheet.
struct Place {
    std::vector<std::size_t> columns;  ///< with numbers, or with words among them
    std::vector<bool> text;
    std::size_t first_row = 0;
};

/// Nonempty cells of a column.
struct Tally {
    std::size_t cells = 0, numbers = 0;
};

std::optional<Place> find_table(const SheetRows& rows) {
    std::map<std::size_t, Tally> tallies;
    std::size_t fullest = 0;
    for (const auto& [row, cells] : rows)
        for (const auto& [column, cell] : cells) {
            auto& tally = tallies[column];
            ++tally.cells;
            tally.numbers += is_number(cell) ? 1 : 0;
            fullest = std::max(fullest, tally.numbers);
        }
    std::vector<std::size_t> numeric;
    for (const auto& [column, tally] : tallies)
        if (2 * tally.numbers >= fullest && 2 * tally.numbers >= tally.cells && fullest >= 2) numeric.push_back(column);
    if (numeric.empty()) return std::nullopt;
    Place place;
    for (const auto& [row, cells] : rows) {
        std::size_t filled = 0;
        for (const auto column : numeric) filled += cells.contains(column) && is_number(cells.at(column)) ? 1 : 0;
        place.first_row = row;
        if (2 * filled > numeric.size()) break;
    }
    // every column from the first to the last one filled by the row of names or the numbers
    for (const auto& [column, tally] : tallies) {
        const bool number = std::find(numeric.begin(), numeric.end(), column) != numeric.end();
        std::size_t words = 0, numbers = 0;
        for (auto row = rows.lower_bound(place.first_row); row != rows.end(); ++row)
            if (const auto cell = row->second.find(column); cell != row->second.end())
                ++(is_number(cell->second) ? numbers : words);
        const auto header = rows.lower_bound(place.first_row) == rows.begin()
                                ? rows.end()
                                : std::prev(rows.lower_bound(place.first_row));
        const bool named = header != rows.end() && header->second.contains(column);
        if (!number && !named) continue;  // comments next to the table
        place.columns.push_back(column);
        place.text.push_back(!number && words > numbers);
    }
    return place;
}

/// Cells above the table as lines of tab-separated text, in the form of a text file.
std::vector<std::string> lines_above(const SheetRows& rows, const Place& place, const std::string& sheet) {
    std::vector<std::string> lines{fmt::format("sheet: {}", sheet)};
    for (const auto& [row, cells] : rows) {
        if (row >= place.first_row) break;
        std::string line;
        for (const auto column : place.columns) {
            if (column != place.columns.front()) line += '\t';
            if (cells.contains(column)) line += trimmed(cells.at(column));
        }
        if (trimmed(line).empty() && !cells.empty()) line = cells.begin()->second;
        std::replace(line.begin(), line.end(), '\n', ' ');
        if (!trimmed(line).empty()) lines.push_back(line);
    }
    return lines;
}

RawTable table_of(const SheetRows& rows, const Place& place, const Sheet& sheet, const bytes::Source& source) {
    RawTable table{{}, lines_above(rows, place, sheet.name), {}, '\t', '.'};
    std::vector<std::vector<double>> values(place.columns.size());
    table.columns.resize(place.columns.size());
    for (auto row = rows.lower_bound(place.first_row); row != rows.end(); ++row)
        for (std::size_t k = 0; k < place.columns.size(); ++k) {
            const auto cell = row->second.find(place.columns[k]);
            double value = undefined;
            if (cell != row->second.end() && !bytes::parse_cell(cell->second, '.', value)) {
                const auto where =
                    fmt::format("'{:.40}' in cell {}", cell->second, cell_name(row->first, place.columns[k]));
                if (!place.text[k])
                    throw FormatError(
                        source.name, {},
                        fmt::format("sheet '{}': {} is not a number, expected a number as in the cells above",
                                    sheet.name, where));
                if (table.columns[k].text.empty()) table.columns[k].text = where;
            }
            values[k].push_back(place.text[k] ? undefined : value);
        }
    std::vector<HeaderCell> names;
    try {
        names = parse_header(table.header, '\t', values.size(), values.size());
    } catch (const InvalidArgument& error) {
        throw FormatError(source.name, {}, fmt::format("sheet '{}': {}", sheet.name, error.what()));
    }
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!names.empty()) {
            table.columns[k].name = names[k].name;
            table.columns[k].unit = names[k].unit;
        }
        table.columns[k].values = Eigen::Map<const Array1D>(values[k].data(), static_cast<Index>(values[k].size()));
    }
    return table;
}

std::string listed(const std::vector<Sheet>& sheets) {
    std::vector<std::string> names;
    for (const auto& sheet : sheets) names.push_back(fmt::format("'{}'", sheet.name));
    return fmt::format("{}", fmt::join(names, ", "));
}

/// Why a sheet has no table.
std::string without_table(const SheetRows& rows, const Sheet& sheet) {
    return fmt::format("sheet '{}' {}; expected columns of numbers below their names", sheet.name,
                       rows.empty() ? "is empty" : "does not have two rows of numbers");
}

}  // namespace

namespace {

/// Message of an error after the name of the file.
std::string without_file(const std::string& what, const bytes::Source& source) {
    return what.starts_with(source.name + ": ") ? what.substr(source.name.size() + 2) : what;
}

/// The table of a sheet, or why there is none.
struct SheetTable {
    std::string sheet;
    std::optional<RawTable> table;
    std::string problem;
};

SheetTable sheet_table(const Workbook& book, const Sheet& sheet, const bytes::Source& source) {
    try {
        const auto rows = rows_of_sheet(book, sheet, source);
        const auto place = find_table(rows);
        if (!place) return {sheet.name, std::nullopt, without_table(rows, sheet)};
        return {sheet.name, table_of(rows, *place, sheet, source), {}};
    } catch (const FormatError& error) {
        return {sheet.name, std::nullopt, without_file(error.what(), source)};
    }
}

bool is_loop(const RawTable& table) {
    const auto guess = guess_columns(table, "");
    const auto has = [&](std::string_view role) {
        return std::any_of(guess.roles.begin(), guess.roles.end(),
                           [&](const RoleGuess& found) { return found.role == role && !found.candidates.empty(); });
    };
    return has("force") && (has("displacement") || has("contact_radius"));
}

/// Whether the first column of a table counts its rows, as the index of pandas without a name.
bool counts_rows(const SheetRows& rows, const Place& place, std::size_t column) {
    double expected = undefined;
    for (auto row = rows.lower_bound(place.first_row); row != rows.end(); ++row) {
        const auto cell = row->second.find(column);
        double value = 0.0;
        if (cell == row->second.end() || !bytes::parse_cell(cell->second, '.', value)) return false;
        if (std::isnan(expected) && (value == 0.0 || value == 1.0)) expected = value;
        if (value != expected) return false;
        ++expected;
    }
    return true;
}

/// The rows of the numeric columns of a table with tabs; above them the cells of the sheet there, whole rows except for
/// the two with possible names and units.
std::string text_of(const SheetRows& rows, const Place& place) {
    std::vector<std::size_t> numeric;
    for (std::size_t k = 0; k < place.columns.size(); ++k)
        if (!place.text[k]) numeric.push_back(place.columns[k]);
    const bool indexed = numeric.size() > 1 && counts_rows(rows, place, numeric.front());
    std::string text;
    const auto add = [&](const std::map<std::size_t, std::string>& cells, std::size_t column, bool first) {
        if (!first) text += '\t';
        const auto cell = cells.find(column);
        if (cell == cells.end()) return;
        for (const char c : std::string(trimmed(cell->second))) text += c == '\n' || c == '\t' || c == '\r' ? ' ' : c;
    };
    for (const auto& [row, cells] : rows) {
        if (row + 2 < place.first_row) {
            bool first = true;
            for (const auto& [column, cell] : cells) add(cells, column, std::exchange(first, false));
        } else {
            if (row < place.first_row && std::none_of(numeric.begin(), numeric.end(),
                                                      [&](std::size_t column) { return cells.contains(column); }))
                continue;
            if (row + 1 == place.first_row && indexed && !cells.contains(numeric.front())) text += "index";
            for (const auto column : numeric) add(cells, column, column == numeric.front());
        }
        text += '\n';
    }
    return text;
}

}  // namespace

bool is_spreadsheet(const bytes::Source& source) { return workbook_kind(source) != WorkbookKind::none; }

std::vector<SheetText> spreadsheet_texts(const bytes::Source& workbook) {
    const Workbook book(workbook);
    std::vector<SheetText> texts;
    for (const auto& sheet : book.sheets()) {
        try {
            const auto rows = rows_of_sheet(book, sheet, workbook);
            const auto place = find_table(rows);
            texts.push_back(place ? SheetText{sheet.name, text_of(rows, *place), {}}
                                  : SheetText{sheet.name, {}, without_table(rows, sheet)});
        } catch (const FormatError& error) {
            texts.push_back({sheet.name, {}, without_file(error.what(), workbook)});
        }
    }
    return texts;
}

RawTable read_spreadsheet(const bytes::Source& workbook, const std::optional<std::string>& sheet) {
    const Workbook book(workbook);
    std::vector<SheetTable> found;
    std::string problems;
    for (const auto& candidate : book.sheets()) {
        if (sheet && bytes::lowered(candidate.name) != bytes::lowered(*sheet)) continue;
        found.push_back(sheet_table(book, candidate, workbook));
        if (!found.back().table) problems += (problems.empty() ? "" : "; ") + found.back().problem;
    }
    if (found.empty())
        throw FormatError(workbook.name, {},
                          fmt::format("no sheet '{}'; the workbook has {}", sheet.value_or(""), listed(book.sheets())));
    std::erase_if(found, [](const SheetTable& candidate) { return !candidate.table; });
    if (found.empty()) throw FormatError(workbook.name, {}, problems);
    auto chosen =
        std::find_if(found.begin(), found.end(), [](const SheetTable& candidate) { return is_loop(*candidate.table); });
    if (chosen == found.end()) chosen = found.begin();
    std::string others;
    for (const auto& candidate : found)
        if (&candidate != &*chosen) others += (others.empty() ? "" : ", ") + candidate.sheet;
    if (book.sheets().size() > 1) chosen->table->metadata["sheet"] = chosen->sheet;
    if (!others.empty()) chosen->table->metadata["other_sheets"] = others;
    return std::move(*chosen->table);
}

}  // namespace setae::tables
