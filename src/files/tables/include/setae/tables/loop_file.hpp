// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/core/estimate.hpp"
#include "setae/core/table.hpp"
#include "setae/core/units.hpp"

namespace setae::tables {

/// A key of a loop file: meaning, and expected quantity.
struct LoopKey {
    std::string_view name;
    std::string_view meaning;
    std::optional<Expected> expected{};  ///< empty: text
    bool uncertain = false;              ///< allows a ±: "1.25 ± 0.01 mm"
};

/// The known keys; others are kept as text. docs/reference/loop-format.md lists them.
[[nodiscard]] const std::vector<LoopKey>& loop_keys();

/// A loop as text in the open format of setae: '# key: value' lines, then CSV with "name [unit]" cells in SI.
///
///   # format: setae loop
///   # version: 1
///   # sphere_radius: 1.25 ± 0.01 mm
///   time [s],force [N],displacement [m],contact_radius [m]
///
/// Numbers have all their digits, NaN is an empty cell. All keys of `metadata` except "format", "version", "file",
/// "header" and "mapping" are written, in alphabetical order.
/// @throws InvalidArgument for a table that is no loop, a key that is no lower-case identifier, a value with line
/// breaks or outer blanks, and a known quantity that does not parse or has another dimension.
[[nodiscard]] std::string as_loop_file(const Table& table, const std::map<std::string, std::string>& metadata);

/// Writes as_loop_file(table, metadata) as a whole.
/// @throws FileError; InvalidArgument as as_loop_file.
void write_loop(const std::string& path, const Table& table, const std::map<std::string, std::string>& metadata);

/// The entries of a table's metadata that a loop file can contain: lower-case keys, values of one line, known
/// quantities with their dimension.
[[nodiscard]] std::map<std::string, std::string> loop_metadata(const Table& table);

/// Whether bytes are the beginning of a loop file.
[[nodiscard]] bool is_loop_file(std::string_view head);

/// Whether a source is a loop file, by its first line. @throws FileError.
[[nodiscard]] bool is_loop_file(const bytes::Source& source);

/// A loop file: columns in SI, metadata as written and "file". The output of write_loop is read exactly, to the last
/// digit.
/// @throws FileError; FormatError with the line: no loop file, an unknown version, a malformed key or quantity, a key
/// given twice, a row of another length, a cell that is no number, columns that are no loop.
[[nodiscard]] Table read_loop(const std::string& path);

/// A quantity of the metadata in SI, with its ± if the file states one; empty if missing.
/// @throws InvalidArgument if `key` is no known quantity or its value is malformed.
[[nodiscard]] std::optional<Estimate> loop_quantity(const Table& loop, const std::string& key);

}  // namespace setae::tables
