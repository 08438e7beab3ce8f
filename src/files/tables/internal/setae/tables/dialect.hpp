// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/text.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// Separator and spelling of numbers.
struct Dialect {
    char separator = ' ';  ///< '\t', ';', ',' or ' ' for runs of blanks
    char decimal_point = '.';
    bool grouped = false;  ///< the other sign is a thousands separator even if nothing else in the cell shows it:
                           ///< "1,234"
};

/// Whether a cell consists only of groups of thousands: "1,234" for ','.
[[nodiscard]] bool is_grouped(std::string_view cell, char group_sign);

using bytes::parse_cell;
/// The number of a cell, in quotes or not, with thousands in groups: "1,234.5", "1,234,567", "1'234", "1 234", and
/// "1,234" if the dialect allows it.
[[nodiscard]] bool parse_cell(std::string_view cell, const Dialect& dialect, double& value);

/// Whether a line is a comment: it begins with '#' or '%', and not with a spreadsheet error such as "#NV" or "#DIV/0!",
/// which is a cell.
[[nodiscard]] bool is_comment(std::string_view line);

/// Cells of a line, with their quotes, in which separators are the cell's own; for separator ' ' runs of blanks and
/// tabs separate and none lead or trail.
void split_cells(std::string_view line, char separator, std::vector<std::string_view>& cells);

/// Place and dialect of the numbers of a text.
struct Layout {
    Dialect dialect;
    std::size_t columns = 0;
    std::size_t filled = 0;     ///< columns up to the last that is not empty in every examined row
    std::size_t first_row = 0;  ///< index of the first line of numbers
    std::vector<bool> text;     ///< whether each column contains text; empty if none does
};

/// The dialect for which most of the last lines are rows of numbers, and the first row; empty if no line is one.
[[nodiscard]] std::optional<Layout> find_layout(const std::vector<std::string_view>& lines,
                                                const TableOptions& options);

/// The layout of a text with columns of words: the one for which most of the last lines are rows with the same number
/// of cells and numbers in the same columns; empty if there is none of at least two columns.
[[nodiscard]] std::optional<Layout> find_layout_with_words(const std::vector<std::string_view>& lines,
                                                           const TableOptions& options);

/// A cell among numbers that is no number.
struct BrokenCell {
    std::string cell;
    std::size_t line = 0, column = 0;  ///< from 1
};

/// The first cell that is no number in rows directly above the first row: lines with as many cells that begin with a
/// number and in which two thirds, or one of two, are numbers are no header. Empty if there is no such line.
[[nodiscard]] std::optional<BrokenCell> broken_row_above(const std::vector<std::string_view>& lines,
                                                         const Layout& layout);

/// The first cell that is no number in a text without a row of numbers, but with lines that contain that many numbers;
/// empty if there are few.
[[nodiscard]] std::optional<BrokenCell> broken_row_of(const std::vector<std::string_view>& lines);

/// "'xx' in column 3 is no number, …" for messages with the line.
[[nodiscard]] std::string described(const BrokenCell& broken);

/// Numeric columns in the first bytes of a text, 0 if there are none or it is no text.
[[nodiscard]] std::size_t numeric_columns(std::string_view head);

/// Cells of a header line with between `least` and `most` cells, by the separator of the numbers or any other;
/// otherwise empty.
[[nodiscard]] std::vector<std::string> header_cells(std::string_view line, char separator, std::size_t least,
                                                    std::size_t most);

}  // namespace setae::tables
