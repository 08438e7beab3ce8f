// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <memory>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "workbooks/workbook_xml.hpp"

namespace setae::tables {
namespace {

constexpr const char* open_document_content = "content.xml";
constexpr std::string_view open_document_type = "application/vnd.oasis.opendocument.spreadsheet";

bool is_named(const pugi::xml_node& node, const char* name) { return std::strcmp(local_name(node), name) == 0; }

/// An attribute by its local name: "value" of office:value.
std::string_view attribute(const pugi::xml_node& node, std::string_view name) {
    for (const auto& candidate : node.attributes()) {
        const std::string_view full = candidate.name();
        if (full.substr(full.find(':') + 1) == name) return candidate.value();
    }
    return {};
}

std::size_t repeats(const pugi::xml_node& node, std::string_view name) {
    const auto text = attribute(node, name);
    if (text.empty()) return 1;
    const auto count = std::strtoull(std::string(text).c_str(), nullptr, 10);
    return count == 0 ? 1 : static_cast<std::size_t>(count);
}

/// The text of paragraphs and their spans.
void add_text(const pugi::xml_node& node, std::string& text) {
    for (const auto& part : node.children()) {
        if (part.type() == pugi::node_pcdata) text += part.value();
        else if (is_named(part, "s")) text.append(std::min<std::size_t>(repeats(part, "c"), 1000), ' ');
        else if (is_named(part, "tab")) text += '\t';
        else if (!is_named(part, "annotation")) add_text(part, text);
    }
}

std::string text_of_cell(const pugi::xml_node& cell) {
    const auto type = attribute(cell, "value-type");
    if (type == "float" || type == "percentage" || type == "currency") return std::string(attribute(cell, "value"));
    if (type == "date") return std::string(attribute(cell, "date-value"));
    if (type == "time") return std::string(attribute(cell, "time-value"));
    if (type == "boolean") return std::string(attribute(cell, "boolean-value"));
    std::string text;
    add_text(cell, text);
    if (text.starts_with('#') || text.starts_with("Err:")) return {};  // #N/A, #DIV/0!, Err:502
    return text;
}

/// The cells of a row with their column; empty ones at the end may be repeated to the edge of the sheet.
std::vector<std::pair<std::size_t, std::string>> cells_of(const pugi::xml_node& row) {
    std::vector<std::pair<std::size_t, std::string>> cells;
    std::size_t column = 0;
    for (const auto& cell : row.children()) {
        if (!is_named(cell, "table-cell") && !is_named(cell, "covered-table-cell")) continue;
        const auto count = repeats(cell, "number-columns-repeated");
        const auto text = is_named(cell, "table-cell") ? text_of_cell(cell) : std::string();
        if (!text.empty())
            for (std::size_t k = 0; k < std::min(count, max_sheet_columns); ++k) cells.emplace_back(column + k, text);
        column += std::min(count, max_sheet_columns);
    }
    return cells;
}

/// Whether a table is hidden by its style.
bool is_hidden(const pugi::xml_document& document, std::string_view style) {
    for (const auto& node : local_child(document.document_element(), "automatic-styles").children())
        if (attribute(node, "name") == style)
            return attribute(local_child(node, "table-properties"), "display") == "false";
    return false;
}

/// The document of a spreadsheet, parsed once.
struct OpenDocument {
    explicit OpenDocument(const bytes::Source& from) : source(from) {
        const bytes::Archive archive(from);
        if (!archive.has(open_document_content))
            throw FormatError(from.name, {}, "an OpenDocument spreadsheet without 'content.xml'; it is damaged");
        document = parsed_member(archive, open_document_content, from);
        const auto body = local_child(document.document_element(), "body");
        for (const auto& table : local_child(body, "spreadsheet").children())
            if (is_named(table, "table")) {
                tables.push_back(table);
                sheets.push_back({std::string(attribute(table, "name")), fmt::format("{}", sheets.size()),
                                  is_hidden(document, attribute(table, "style-name"))});
            }
        if (sheets.empty()) throw FormatError(from.name, {}, "the spreadsheet has no table");
    }

    bytes::Source source;
    pugi::xml_document document;
    std::vector<pugi::xml_node> tables;
    std::vector<Sheet> sheets;
};

/// Adds the rows below a node, which may be groups of rows, and returns the row after them.
std::size_t add_rows(const pugi::xml_node& parent, std::size_t row, SheetRows& rows, std::size_t& bytes,
                     const Sheet& sheet, const bytes::Source& source) {
    for (const auto& node : parent.children()) {
        if (is_named(node, "table-header-rows") || is_named(node, "table-row-group") || is_named(node, "table-rows")) {
            row = add_rows(node, row, rows, bytes, sheet, source);
            continue;
        }
        if (!is_named(node, "table-row")) continue;
        const auto count = std::min(repeats(node, "number-rows-repeated"), max_sheet_rows);
        const auto cells = cells_of(node);
        for (std::size_t k = 0; !cells.empty() && k < count; ++k)
            for (const auto& [column, text] : cells) put_cell(rows, row + k, column, text, bytes, sheet, source);
        row += count;
    }
    return row;
}

SheetRows rows_of_table(const OpenDocument& document, const Sheet& sheet) {
    SheetRows rows;
    std::size_t bytes = 0;
    for (std::size_t k = 0; k < document.sheets.size(); ++k)
        if (document.sheets[k].member == sheet.member)
            (void)add_rows(document.tables[k], 0, rows, bytes, sheet, document.source);
    return rows;
}

}  // namespace

bool is_open_document(const bytes::Archive& archive) {
    return archive.has("mimetype") && trimmed(archive.head("mimetype", 128)) == open_document_type;
}

WorkbookContent open_document_spreadsheet(const bytes::Source& source) {
    const auto document = std::make_shared<const OpenDocument>(source);
    return {document->sheets, [document](const Sheet& sheet) { return rows_of_table(*document, sheet); }};
}

}  // namespace setae::tables
