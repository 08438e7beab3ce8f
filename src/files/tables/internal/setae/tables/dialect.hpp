// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/text.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// How numbers are separated and spelled.
struct Dialect {
    char separator = ' ';  ///< '\t', ';', ',' or ' ' for runs of blanks
    char decimal_point = '.';
    bool grouped = false;  ///< the other sign groups thousands even where nothing else in the cell says so: "1,234"
};

/// Whether a cell is a number of groups of thousands alone: "1,234" for ','.
[[nodiscard]] bool is_grouped(std::string_view cell, char group_sign);

using bytes::parse_cell;
/// The same, in quotes or not, with thousands in groups: "1,234.5", "1,234,567", "1'234", "1 234", and "1,234" where
/// the dialect says so.
[[nodiscard]] bool parse_cell(std::string_view cell, const Dialect& dialect, double& value);

/// Whether a line is a remark: it begins with '#' or '%', and not with a spreadsheet's error such as "#NV" or
/// "#DIV/0!", which is a cell.
[[nodiscard]] bool is_remark(std::string_view line);

/// Cells of a line, with their quotes, in which separators are the cell's own; for separator ' ' runs of blanks and
/// tabs separate and none lead or trail.
void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Where the numbers of a text stand and how they are written.
struct Layout {
    Dialect dialect;
    std::size_t columns = 0;
    std::size_t filled = 0;     ///< columns up to the last that is not empty in every row looked at
    std::size_t first_row = 0;  ///< index of the line the numbers begin at
    std::vector<bool> text;     ///< per column whether it holds text; empty where none does
};

/// The dialect that makes the most of the last lines rows of numbers, and the first row; nothing where no line is one.
[[nodiscard]] std::optional<Layout> find_layout(const std::vector<std::string_view>& lines,
                                                const TableOptions& options);

/// The same for text of which some columns are words: the layout that makes the most of the last lines rows of as many
/// cells, the same columns numbers in each; nothing where there is none of at least two columns.
[[nodiscard]] std::optional<Layout> find_layout_with_words(const std::vector<std::string_view>& lines,
                                                           const TableOptions& options);

/// A cell among numbers that is none.
struct BrokenCell {
    std::string cell;
    std::size_t line = 0, column = 0;  ///< from 1
};

/// The first cell that is no number in rows directly above the first row: lines of as many cells that begin with a
/// number and of which two thirds, or one of two, are numbers are no header. Nothing where there is no such line.
[[nodiscard]] std::optional<BrokenCell> broken_row_above(const std::vector<std::string_view>& lines,
                                                         const Layout& layout);

/// The first cell that is no number in a text that has no row of numbers, but lines of which as many are numbers;
/// nothing where those are few.
[[nodiscard]] std::optional<BrokenCell> broken_row_of(const std::vector<std::string_view>& lines);

/// "'xx' in column 3 is no number, …" for messages that name the line.
[[nodiscard]] std::string described(const BrokenCell& broken);

/// Numeric columns in the first bytes of a text, 0 where there are none or it is no text.
[[nodiscard]] std::size_t numeric_columns(std::string_view head);

/// Cells of a header line with between `least` and `most` cells, by the numbers' separator or any other; else empty.
[[nodiscard]] std::vector<std::string> header_cells(std::string_view line, char separator, std::size_t least,
                                                    std::size_t most);

}  // namespace setae::tables
