// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// Whether a source is a workbook: .xlsx, .ods, or one of Excel's older kinds, which reading refuses with the remedy.
[[nodiscard]] bool is_spreadsheet(const bytes::Source& source);

/// A table of a workbook: of the sheet named, else of the first sheet whose columns are those of a loop (force beside
/// displacement or contact radius), else of the first that holds a table.
///
/// A table is the columns with numbers in at least half as many rows as the fullest; names and units stand above it as
/// in text. Shared and inline strings, numbers, results of formulas; text that spells a number counts as one, with a
/// decimal comma where the column's cells decide that it is one. Empty cells and errors such as #N/A are undefined.
/// Columns of text and of dates are kept and marked. metadata["sheet"] names the sheet of a workbook of several,
/// metadata["other_sheets"] others with a table. Sheets are named without regard to case.
/// @throws FormatError that names sheet and cell: a sheet that is not there, without cells or without numbers, text
/// among numbers. Source: ECMA-376 part 1, 18.2–18.4; OpenDocument 1.3 part 3, 9.
[[nodiscard]] RawTable read_spreadsheet(const bytes::Source& workbook, const std::optional<std::string>& sheet = {});

/// A sheet as a text file would have it: what stands above its table, then its columns of numbers, between tabs and
/// with decimal points.
struct SheetText {
    std::string sheet;
    std::string text;
    std::string problem = {};  ///< why there is no table; empty where there is
};

/// Every sheet of a workbook as text, in their order. @throws FormatError for what is no whole workbook.
[[nodiscard]] std::vector<SheetText> spreadsheet_texts(const bytes::Source& workbook);

}  // namespace setae::tables
