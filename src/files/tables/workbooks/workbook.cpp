// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/workbook.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/bytes/ole_file.hpp"
#include "setae/core/errors.hpp"
#include "workbooks/workbook_xml.hpp"

namespace setae::tables {
namespace {

constexpr std::string_view ole_signature = "\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1";

/// Excel 97 to 2003 in its compound file, or Excel 2 to 4 without one.
bool is_old_excel(const bytes::Source& source) {
    const auto head = source.head(8);
    if (head.size() == 8 && head[0] == '\x09' && (head[1] == '\x00' || head[1] == '\x02' || head[1] == '\x04') &&
        (head[2] == '\x04' || head[2] == '\x06') && head[3] == '\x00')
        return true;
    if (head != ole_signature) return false;
    try {
        const bytes::OleFile file(source, "Excel");
        return file.has("Workbook") || file.has("Book");
    } catch (const FormatError&) {
        return false;
    }
}

}  // namespace

WorkbookKind workbook_kind(const bytes::Source& source) {
    if (!bytes::is_zip(source.head(4))) return is_old_excel(source) ? WorkbookKind::old_excel : WorkbookKind::none;
    try {
        const bytes::Archive archive(source);
        if (archive.has("xl/workbook.xml")) return WorkbookKind::office_open_xml;
        if (archive.has("xl/workbook.bin")) return WorkbookKind::binary_excel;
        return is_open_document(archive) ? WorkbookKind::open_document : WorkbookKind::none;
    } catch (const FormatError&) {
        return WorkbookKind::none;
    }
}

namespace {

/// Sheets in their order, hidden ones after the others.
void hidden_last(std::vector<Sheet>& sheets) {
    std::stable_partition(sheets.begin(), sheets.end(), [](const Sheet& sheet) { return !sheet.hidden; });
}

}  // namespace

struct Workbook::Content : WorkbookContent {};

Workbook::Workbook(const bytes::Source& source) : content_(std::make_unique<Content>()) {
    const auto refuse = [&](const char* kind) {
        throw FormatError(
            source.name, {.offset = 0},
            fmt::format("{}, which cannot be read; save it as .xlsx or .ods with Excel or LibreOffice", kind));
    };
    switch (workbook_kind(source)) {
        case WorkbookKind::office_open_xml:
            static_cast<WorkbookContent&>(*content_) = open_office_open_xml(source);
            hidden_last(content_->sheets);
            return;
        case WorkbookKind::open_document:
            static_cast<WorkbookContent&>(*content_) = open_document_spreadsheet(source);
            hidden_last(content_->sheets);
            return;
        case WorkbookKind::old_excel: refuse("a workbook of Excel 97 to 2003 or older (.xls)"); break;
        case WorkbookKind::binary_excel: refuse("a binary workbook of Excel (.xlsb)"); break;
        case WorkbookKind::none: break;
    }
    throw FormatError(source.name, {.offset = 0}, "not a workbook; expected .xlsx or .ods");
}

Workbook::~Workbook() = default;

const std::vector<Sheet>& Workbook::sheets() const { return content_->sheets; }

SheetRows Workbook::rows(const Sheet& sheet) const { return content_->rows(sheet); }

std::string cell_name(std::size_t row, std::size_t column) {
    std::string letters;
    for (auto left = column + 1; left > 0; left = (left - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % 26));
    return fmt::format("{}{}", letters, row + 1);
}

}  // namespace setae::tables
