// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/arrays.hpp"
#include "setae/tables/dialect.hpp"

namespace setae::tables {

/// The beginning of a text: its header, how its numbers are written and where they begin.
struct TextStart {
    bytes::Source source;  ///< in UTF-8 or latin-1 with '\n' at the end of lines: the file itself, or its decoded copy
    std::vector<std::string> header;  ///< lines before the first row, in UTF-8
    Layout layout;
    std::uint64_t begin = 0;                ///< byte of the first row
    std::uint64_t line = 0;                 ///< lines before it
    std::optional<BrokenCell> broken = {};  ///< of rows above the first that are no header
};

/// Bytes from an offset to the end of its line, which ends at `end` at the latest.
[[nodiscard]] std::string whole_line(const bytes::Source& source, std::uint64_t offset, std::uint64_t end);

/// Lines of numbers in part of a text, found by their line breaks alone; blank lines and those that begin with '#' or
/// '%' are none.
struct NumberLines {
    struct Block {
        std::uint64_t offset = 0, size = 0;  ///< whole lines
        std::uint64_t line = 0;              ///< lines of the text before it
        Index row = 0;                       ///< lines of numbers before it
    };
    /// A line that begins with '#' or a letter: it may be the header of further numbers.
    struct Break {
        std::uint64_t offset = 0, line = 0;
        Index row = 0;  ///< lines of numbers before it
    };
    bytes::Source source;
    Layout layout;
    Index columns = 0, rows = 0;
    std::vector<Block> blocks;
    std::vector<Break> breaks;  ///< the first of them; more than a file of maps could need are not kept
    std::uint64_t lines = 0;    ///< of the text up to the end of the part
    std::uint64_t end = 0;      ///< byte behind the part
    Break last;                 ///< the last line of numbers
};

/// Finds the lines of a start's source from byte `begin` to `end`. Reads every byte once, on all cores, and parses
/// nothing.
[[nodiscard]] NumberLines find_number_lines(const TextStart& start, std::uint64_t begin, std::uint64_t end);

/// Refuses a last line of another number of cells, or with a cell that is no number: the text was cut within it.
/// @throws FormatError with the line.
void require_whole_last_line(const NumberLines& lines);

/// Where numbers go and what they are multiplied by: number k of line j at (k, j), or at (j, n − 1 − k) of lines that
/// are columns from the bottom.
struct NumberPlaces {
    double factor = 1.0;
    bool lines_are_columns = false;
    Index first = 0, count = -1;  ///< lines that are read; −1: all that follow
};

/// The numbers of lines as an array, read in blocks on all cores: memory is the array and a block a thread.
///
/// Lines of plain numbers are parsed as they stand; whatever holds anything else goes through parse_number_line.
/// @throws FormatError with the line: another number of cells, or a cell that is no number.
[[nodiscard]] Array2D read_numbers(const NumberLines& lines, const NumberPlaces& places = {});

/// The same, line by line through parse_number_line on one thread: slow and obviously right, what read_numbers is
/// tested against.
[[nodiscard]] Array2D read_numbers_plainly(const NumberLines& lines);

/// The numbers of one line, of whatever spelling. @throws FormatError as read_numbers.
void parse_number_line(std::string_view line, const Layout& layout, std::uint64_t number, const std::string& name,
                       double* values);

}  // namespace setae::tables
