// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {

/// Whether a source is a workbook: .xlsx, .ods, or an older kind of Excel, which is refused on reading with the remedy.
[[nodiscard]] bool is_spreadsheet(const bytes::Source& source);

/// A table of a workbook: of the given sheet, otherwise of the first sheet whose columns are those of a loop (force
/// with displacement or contact radius), otherwise of the first sheet with a table.
///
/// A table is the columns with numbers in at least half as many rows as the fullest; names and units are above it as in
/// text. Shared and inline strings, numbers, results of formulas; text that spells a number counts as one, with a
/// decimal comma if the cells of the column show it. Empty cells and errors such as #N/A are undefined. Columns of text
/// and of dates are kept and marked. metadata["sheet"] is the sheet if there are several, metadata["other_sheets"] are
/// others with a table. The case of sheet names is ignored.
/// @throws FormatError with sheet and cell: a missing sheet, a sheet without cells or numbers, text among numbers.
/// Source: ECMA-376 part 1, 18.2–18.4; OpenDocument 1.3 part 3, 9.
[[nodiscard]] RawTable read_spreadsheet(const bytes::Source& workbook, const std::optional<std::string>& sheet = {});

/// A sheet in the form of a text file: the rows above its table, then its columns of numbers, with tabs and decimal
/// points.
struct SheetText {
    std::string sheet;
    std::string text;
    std::string problem = {};  ///< why there is no table; empty if there is one
};

/// Every sheet of a workbook as text, in order. @throws FormatError for an incomplete workbook.
[[nodiscard]] std::vector<SheetText> spreadsheet_texts(const bytes::Source& workbook);

}  // namespace setae::tables
