// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// Whether a source is an Office Open XML workbook (.xlsx).
[[nodiscard]] bool is_spreadsheet(const bytes::Source& source);

/// A table of a workbook (.xlsx, ECMA-376): of the sheet named, else of the first sheet that holds one.
///
/// A table is the columns with numbers in at least half as many rows as the fullest; names and units stand above it as
/// in text. Shared and inline strings, numbers, results of formulas; text that spells a number counts as one. Empty
/// cells and errors such as #N/A are undefined. Columns of text are kept and marked. Other sheets with a table are
/// named in the header.
/// @throws FormatError that names sheet and cell: a sheet that is not there, without cells or without numbers, text
/// among numbers. Source: ECMA-376 part 1, 18.2–18.4.
[[nodiscard]] RawTable read_spreadsheet(const bytes::Source& workbook, const std::optional<std::string>& sheet = {});

}  // namespace setae::tables
