// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::tables {

/// Cells of a sheet as text, by row and column from 0, without empty ones.
using SheetRows = std::map<std::size_t, std::map<std::size_t, std::string>>;

struct Sheet {
    std::string name;
    std::string member;   ///< of the archive
    bool hidden = false;  ///< the sheet is hidden in the program that wrote it
};

/// Kind of workbook. Those of Excel before 2007 and binary ones are recognised, not read.
enum class WorkbookKind { none, office_open_xml, open_document, old_excel, binary_excel };
[[nodiscard]] WorkbookKind workbook_kind(const bytes::Source& source);

/// End of the text of a formula without a stored result.
inline constexpr std::string_view formula_without_result = " (no result)";

/// A workbook (.xlsx, .ods): its sheets, read one by one. Numbers and results of formulas are spelled with a point,
/// dates as "2026-01-05 10:20:30", errors such as #N/A are empty; a formula without a stored result is its text.
class Workbook {
public:
    /// @throws FormatError for an incomplete workbook, and for .xls and .xlsb, with the remedy.
    explicit Workbook(const bytes::Source& source);
    ~Workbook();
    Workbook(const Workbook&) = delete;
    Workbook& operator=(const Workbook&) = delete;

    [[nodiscard]] const std::vector<Sheet>& sheets() const;
    /// @throws FormatError for a sheet that does not parse.
    [[nodiscard]] SheetRows rows(const Sheet& sheet) const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

/// "C7" for column 2, row 6.
[[nodiscard]] std::string cell_name(std::size_t row, std::size_t column);

}  // namespace setae::tables
