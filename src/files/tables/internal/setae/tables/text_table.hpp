// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace setae::tables {

/// A CSV table of texts.
struct TextTable {
    struct Column {
        std::string name, unit;  ///< "W [J/m2]" is W in J/m2
    };
    struct Row {
        std::size_t line = 0;  ///< of the file, from 1
        std::vector<std::string> cells;
    };
    std::string path;
    char separator = ',';
    std::vector<Column> columns;
    std::vector<Row> rows;

    /// Index of the column with one of these names, ignoring case; the first name found is used.
    [[nodiscard]] std::optional<std::size_t> find(const std::vector<std::string>& names) const;
    /// The names of all columns, for messages.
    [[nodiscard]] std::string names() const;
};

/// Lines that begin with '#' above the header are skipped; quoted cells may contain separators, doubled quotes and line
/// breaks. The separator is the most frequent of tab, semicolon and comma in the header.
/// @throws FileError; FormatError for a file without header, and at the line of a row with another number of cells.
[[nodiscard]] TextTable read_text_table(const std::string& path);

}  // namespace setae::tables
