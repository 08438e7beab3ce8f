// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <pugixml.hpp>

#include "setae/bytes/archive.hpp"
#include "setae/tables/workbook.hpp"

namespace setae::tables {

inline constexpr std::size_t max_sheet_rows = 1048576, max_sheet_columns = 16384;  // limits of Excel and LibreOffice
inline constexpr std::size_t max_sheet_text = std::size_t{256} << 20;  // of the cells of a sheet: many may share one
                                                                       // string

/// A workbook of one kind, opened.
struct WorkbookContent {
    std::vector<Sheet> sheets;
    std::function<SheetRows(const Sheet&)> rows;
};

/// Office Open XML (.xlsx). Source: ECMA-376 part 1, 18.2 to 18.4 and 18.8.
[[nodiscard]] WorkbookContent open_office_open_xml(const bytes::Source& source);
/// OpenDocument spreadsheets (.ods). Source: OASIS, OpenDocument 1.3 part 3, 9.
[[nodiscard]] WorkbookContent open_document_spreadsheet(const bytes::Source& source);

/// Whether an archive is an OpenDocument spreadsheet, by its member mimetype.
[[nodiscard]] bool is_open_document(const bytes::Archive& archive);

/// Name without namespace prefix: some writers use "x:row".
[[nodiscard]] const char* local_name(const pugi::xml_node& node);
/// The first child of that local name.
[[nodiscard]] pugi::xml_node local_child(const pugi::xml_node& parent, const char* name);
/// A member of an archive as XML. @throws FormatError for text that is none, or too deep.
[[nodiscard]] pugi::xml_document parsed_member(const bytes::Archive& archive, const std::string& member,
                                               const bytes::Source& source);

/// A date or a time of day as text, "2026-01-05 10:20:30" or "10:20:30", from days since 1899-12-30; columns of dates
/// are then not read as numbers.
[[nodiscard]] std::string date_text(double days);

/// Stores the text of a cell. `bytes`: of all cells so far.
/// @throws FormatError for a cell beyond the limits of sheets and for more text than allowed per sheet.
void put_cell(SheetRows& rows, std::size_t row, std::size_t column, std::string text, std::size_t& bytes,
              const Sheet& sheet, const bytes::Source& source);

}  // namespace setae::tables
