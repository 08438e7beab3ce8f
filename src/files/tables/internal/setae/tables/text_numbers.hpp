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

/// The beginning of a text: its header, and dialect and start of its numbers.
struct TextStart {
    bytes::Source source;  ///< in UTF-8 or latin-1 with '\n' at the end of lines: the file, or its decoded copy
    std::vector<std::string> header;  ///< lines before the first row, in UTF-8
    Layout layout;
    std::uint64_t begin = 0;                ///< byte of the first row
    std::uint64_t line = 0;                 ///< lines before it
    std::optional<BrokenCell> broken = {};  ///< in rows above the first that are no header
};

/// Bytes from an offset to the end of its line, at most to `end`.
[[nodiscard]] std::string whole_line(const bytes::Source& source, std::uint64_t offset, std::uint64_t end);

/// Lines of numbers in part of a text, found by line breaks only, without blank lines and those that begin with '#' or
/// '%'.
struct NumberLines {
    struct Block {
        std::uint64_t offset = 0, size = 0;  ///< whole lines
        std::uint64_t line = 0;              ///< lines of the text before it
        Index row = 0;                       ///< lines of numbers before it
    };
    /// A line that begins with '#' or a letter: possibly the header of further numbers.
    struct Break {
        std::uint64_t offset = 0, line = 0;
        Index row = 0;  ///< lines of numbers before it
    };
    bytes::Source source;
    Layout layout;
    Index columns = 0, rows = 0;
    std::vector<Block> blocks;
    std::vector<Break> breaks;  ///< the first of them; no more are kept than a file of maps can need
    std::uint64_t lines = 0;    ///< of the text up to the end of the part
    std::uint64_t end = 0;      ///< byte after the part
    Break last;                 ///< the last line of numbers
};

/// Finds the lines of a start's source from byte `begin` to `end`. Reads every byte once, on all cores, without
/// parsing.
[[nodiscard]] NumberLines find_number_lines(const TextStart& start, std::uint64_t begin, std::uint64_t end);

/// Refuses a last line with another number of cells, or with a cell that is no number: the text was truncated within
/// it.
/// @throws FormatError with the line.
void require_whole_last_line(const NumberLines& lines);

/// Place and factor of numbers: number k of line j at (k, j), or at (j, n − 1 − k) for lines that are columns from the
/// bottom.
struct NumberPlaces {
    double factor = 1.0;
    bool lines_are_columns = false;
    Index first = 0, count = -1;  ///< lines to read; −1: all that follow
};

/// The numbers of lines as an array, read in blocks on all cores: memory: the array and one block per thread.
///
/// Lines of plain numbers are parsed directly; lines with anything else by parse_number_line.
/// @throws FormatError with the line: another number of cells, or a cell that is no number.
[[nodiscard]] Array2D read_numbers(const NumberLines& lines, const NumberPlaces& places = {});

/// The numbers of lines by parse_number_line on one thread: a slow and simple reference for tests of read_numbers.
[[nodiscard]] Array2D read_numbers_plainly(const NumberLines& lines);

/// The numbers of one line in any spelling. @throws FormatError as read_numbers.
void parse_number_line(std::string_view line, const Layout& layout, std::uint64_t number, const std::string& name,
                       double* values);

}  // namespace setae::tables
