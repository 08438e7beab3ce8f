// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "workbooks/workbook_xml.hpp"

namespace setae::tables {
namespace {

/// Text of a shared or inline string: its runs without phonetic readings.
std::string rich_text(const pugi::xml_node& node) {
    std::string text;
    for (const auto& part : node.children()) {
        if (std::strcmp(local_name(part), "t") == 0) text += part.child_value();
        if (std::strcmp(local_name(part), "r") == 0) text += local_child(part, "t").child_value();
    }
    return text;
}

/// Path of the target of a relation in the archive.
std::string member_of(const std::string& target) { return target.starts_with('/') ? target.substr(1) : "xl/" + target; }

std::map<std::string, std::string> relations(const bytes::Archive& archive, const bytes::Source& source) {
    std::map<std::string, std::string> targets;
    const auto document = parsed_member(archive, "xl/_rels/workbook.xml.rels", source);
    for (const auto& relation : document.document_element().children())
        targets[relation.attribute("Id").value()] = member_of(relation.attribute("Target").value());
    return targets;
}

std::vector<Sheet> listed_sheets(const pugi::xml_document& book, const bytes::Archive& archive,
                                 const bytes::Source& source) {
    const auto targets = relations(archive, source);
    std::vector<Sheet> sheets;
    for (const auto& node : local_child(book.document_element(), "sheets").children()) {
        std::string id;
        for (const auto& attribute : node.attributes())
            if (std::string_view(attribute.name()).ends_with(":id")) id = attribute.value();
        const auto target = targets.find(id);
        const std::string_view state = node.attribute("state").value();
        if (target != targets.end() && archive.has(target->second))
            sheets.push_back({node.attribute("name").value(), target->second, state.ends_with("idden")});
    }
    if (sheets.empty()) throw FormatError(source.name, {}, "the workbook has no sheet with cells");
    return sheets;
}

std::vector<std::string> shared_strings(const bytes::Archive& archive, const bytes::Source& source) {
    std::vector<std::string> strings;
    const std::string member = "xl/sharedStrings.xml";
    if (!archive.has(member)) return strings;
    const auto document = parsed_member(archive, member, source);
    for (const auto& node : document.document_element().children())
        if (std::strcmp(local_name(node), "si") == 0) strings.push_back(rich_text(node));
    return strings;
}

/// Whether a number format is one of dates or times: it contains years, days, hours or seconds outside quotes and
/// brackets.
bool is_date_format(std::string_view code) {
    bool quoted = false, bracketed = false;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const char c = code[i];
        if (c == '"') quoted = !quoted;
        else if (quoted) continue;
        else if (c == '\\' || c == '_' || c == '*') ++i;
        else if (c == '[') bracketed = i + 1 < code.size() && std::strchr("hHmMsS", code[i + 1]) == nullptr;
        else if (c == ']') bracketed = false;
        else if (!bracketed && std::strchr("yYdDhHsS", c) != nullptr) return true;
    }
    return false;
}

/// For each style of cells, whether its number format is one of dates or times. Source: ECMA-376 part 1, 18.8.30.
std::vector<bool> date_styles(const bytes::Archive& archive, const bytes::Source& source) {
    std::vector<bool> dates;
    const std::string member = "xl/styles.xml";
    if (!archive.has(member)) return dates;
    const auto document = parsed_member(archive, member, source);
    const auto root = document.document_element();
    std::map<unsigned, bool> own;
    for (const auto& format : local_child(root, "numFmts").children())
        own[format.attribute("numFmtId").as_uint()] = is_date_format(format.attribute("formatCode").value());
    for (const auto& style : local_child(root, "cellXfs").children()) {
        const auto format = style.attribute("numFmtId").as_uint();
        const auto known = own.find(format);
        dates.push_back(known != own.end() ? known->second
                                           : (format >= 14 && format <= 22) || (format >= 45 && format <= 47));
    }
    return dates;
}

/// Row and column of a reference such as "AB12", from 0; false for anything else.
bool parse_reference(std::string_view text, std::size_t& row, std::size_t& column) {
    std::size_t at = 0, letters = 0;
    for (; at < text.size() && text[at] >= 'A' && text[at] <= 'Z' && at < 4; ++at)
        letters = 26 * letters + static_cast<std::size_t>(text[at] - 'A' + 1);
    const auto number = spelled<std::size_t>(text.substr(at)).value_or(0);
    if (letters < 1 || letters > max_sheet_columns || number < 1 || number > max_sheet_rows) return false;
    row = number - 1;
    column = letters - 1;
    return true;
}

/// Shared data referenced by the cells of a workbook.
struct Shared {
    explicit Shared(const bytes::Source& from) : source(from), archive(from) {
        const auto book = parsed_member(archive, "xl/workbook.xml", source);
        sheets = listed_sheets(book, archive, source);
        strings = shared_strings(archive, source);
        dates = date_styles(archive, source);
        constexpr double days_to_1904 = 1462.0;
        if (local_child(book.document_element(), "workbookPr").attribute("date1904").as_bool())
            first_day = days_to_1904;
    }

    [[nodiscard]] std::string text(const pugi::xml_node& cell, const Sheet& sheet) const {
        const std::string_view type = cell.attribute("t").value();
        if (type == "inlineStr") return rich_text(local_child(cell, "is"));
        const std::string value = local_child(cell, "v").child_value();
        if (type == "e") return {};  // #N/A, #DIV/0!
        if (value.empty())
            if (const auto formula = local_child(cell, "f"))
                return fmt::format("={}{}", formula.child_value(), formula_without_result);
        if (type == "s") return shared(value, cell, sheet);
        const auto style = cell.attribute("s").as_uint(std::numeric_limits<unsigned>::max());
        double days = 0.0;
        if ((type.empty() || type == "n") && style < dates.size() && dates[style] &&
            bytes::parse_cell(value, '.', days))
            return date_text(days + first_day);
        return value;
    }

    [[nodiscard]] const std::string& shared(const std::string& value, const pugi::xml_node& cell,
                                            const Sheet& sheet) const {
        const auto index = spelled<std::size_t>(value);
        if (!index || *index >= strings.size())
            throw FormatError(source.name, {},
                              fmt::format("sheet '{}', cell {}: shared string '{}' does not exist; there are {}",
                                          sheet.name, cell.attribute("r").value(), value, strings.size()));
        return strings[*index];
    }

    bytes::Source source;
    bytes::Archive archive;
    std::vector<Sheet> sheets;
    std::vector<std::string> strings;
    std::vector<bool> dates;
    double first_day = 0.0;
};

SheetRows rows_of(const Shared& shared, const Sheet& sheet) {
    SheetRows rows;
    const auto document = parsed_member(shared.archive, sheet.member, shared.source);
    std::size_t row = 0, bytes = 0;
    for (const auto& line : local_child(document.document_element(), "sheetData").children()) {
        std::size_t column = 0;
        row = line.attribute("r") ? line.attribute("r").as_ullong() - 1 : row;
        if (row >= max_sheet_rows)
            throw FormatError(
                shared.source.name, {},
                fmt::format("sheet '{}': '{:.20}' is not a row", sheet.name, line.attribute("r").value()));
        for (const auto& cell : line.children()) {
            const std::string_view reference = cell.attribute("r").value();
            if (!reference.empty() && !parse_reference(reference, row, column))
                throw FormatError(shared.source.name, {},
                                  fmt::format("sheet '{}': '{:.20}' is not a cell", sheet.name, reference));
            put_cell(rows, row, column, shared.text(cell, sheet), bytes, sheet, shared.source);
            ++column;
        }
        ++row;
    }
    return rows;
}

}  // namespace

WorkbookContent open_office_open_xml(const bytes::Source& source) {
    const auto shared = std::make_shared<const Shared>(source);
    return {shared->sheets, [shared](const Sheet& sheet) { return rows_of(*shared, sheet); }};
}

}  // namespace setae::tables
