// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/workbook.hpp"

#include <cstring>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "setae/bytes/archive.hpp"
#include "setae/bytes/nesting.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"

namespace setae::tables {
namespace {

constexpr std::size_t most_rows = 1048576, most_columns = 16384;  // ECMA-376 part 1, 18.3.1.73 and Excel's limits
constexpr std::size_t most_text = std::size_t{256} << 20;  // of a sheet's cells: many may share one long string

/// Name without namespace prefix: some writers use "x:row".
const char* local_name(const pugi::xml_node& node) {
    const char* colon = std::strchr(node.name(), ':');
    return colon ? colon + 1 : node.name();
}

pugi::xml_node child(const pugi::xml_node& parent, const char* name) {
    for (const auto& node : parent.children())
        if (std::strcmp(local_name(node), name) == 0) return node;
    return {};
}

pugi::xml_document parsed(const bytes::Archive& archive, const std::string& member, const bytes::Source& source) {
    pugi::xml_document document;
    const auto text = archive.read(member);
    if (const auto at = bytes::xml_too_deep(text))
        throw FormatError(
            source.name, {},
            fmt::format("member '{}': XML of more than {} levels, at byte {}", member, bytes::most_levels, *at));
    const auto result =
        document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
    if (!result)
        throw FormatError(
            source.name, {},
            fmt::format("member '{}' is no XML: {} at byte {}", member, result.description(), result.offset));
    return document;
}

/// Text of a shared or inline string: its runs without phonetic readings.
std::string rich_text(const pugi::xml_node& node) {
    std::string text;
    for (const auto& part : node.children()) {
        if (std::strcmp(local_name(part), "t") == 0) text += part.child_value();
        if (std::strcmp(local_name(part), "r") == 0) text += child(part, "t").child_value();
    }
    return text;
}

/// Path of a relation's target within the archive.
std::string member_of(const std::string& target) { return target.starts_with('/') ? target.substr(1) : "xl/" + target; }

std::map<std::string, std::string> relations(const bytes::Archive& archive, const bytes::Source& source) {
    std::map<std::string, std::string> targets;
    const auto document = parsed(archive, "xl/_rels/workbook.xml.rels", source);
    for (const auto& relation : document.document_element().children())
        targets[relation.attribute("Id").value()] = member_of(relation.attribute("Target").value());
    return targets;
}

std::vector<Sheet> listed_sheets(const bytes::Archive& archive, const bytes::Source& source) {
    const auto targets = relations(archive, source);
    const auto document = parsed(archive, "xl/workbook.xml", source);
    std::vector<Sheet> sheets;
    for (const auto& node : child(document.document_element(), "sheets").children()) {
        std::string id;
        for (const auto& attribute : node.attributes())
            if (std::string_view(attribute.name()).ends_with(":id")) id = attribute.value();
        const auto target = targets.find(id);
        if (target != targets.end() && archive.has(target->second))
            sheets.push_back({node.attribute("name").value(), target->second});
    }
    if (sheets.empty()) throw FormatError(source.name, {}, "workbook without a sheet of cells");
    return sheets;
}

std::vector<std::string> shared_strings(const bytes::Archive& archive, const bytes::Source& source) {
    std::vector<std::string> strings;
    const std::string member = "xl/sharedStrings.xml";
    if (!archive.has(member)) return strings;
    const auto document = parsed(archive, member, source);
    for (const auto& node : document.document_element().children())
        if (std::strcmp(local_name(node), "si") == 0) strings.push_back(rich_text(node));
    return strings;
}

/// Row and column of a reference such as "AB12", from 0; false for anything else.
bool parse_reference(std::string_view text, std::size_t& row, std::size_t& column) {
    std::size_t at = 0, letters = 0;
    for (; at < text.size() && text[at] >= 'A' && text[at] <= 'Z' && at < 4; ++at)
        letters = 26 * letters + static_cast<std::size_t>(text[at] - 'A' + 1);
    const auto number = spelled<std::size_t>(text.substr(at)).value_or(0);
    if (letters < 1 || letters > most_columns || number < 1 || number > most_rows) return false;
    row = number - 1;
    column = letters - 1;
    return true;
}

}  // namespace

struct Workbook::Content {
    explicit Content(const bytes::Source& from)
        : source(from),
          archive(from),
          sheets(listed_sheets(archive, source)),
          strings(shared_strings(archive, source)) {}

    [[nodiscard]] std::string text(const pugi::xml_node& cell, const Sheet& sheet) const {
        const std::string_view type = cell.attribute("t").value();
        if (type == "inlineStr") return rich_text(child(cell, "is"));
        const std::string value = child(cell, "v").child_value();
        if (type == "e") return {};  // #N/A, #DIV/0!
        if (type != "s") return value;
        const auto index = spelled<std::size_t>(value);
        if (!index || *index >= strings.size())
            throw FormatError(source.name, {},
                              fmt::format("sheet '{}', cell {}: shared string '{}' is not among the {} there are",
                                          sheet.name, cell.attribute("r").value(), value, strings.size()));
        return strings[*index];
    }

    bytes::Source source;
    bytes::Archive archive;
    std::vector<Sheet> sheets;
    std::vector<std::string> strings;
};

Workbook::Workbook(const bytes::Source& source) : content_(std::make_unique<Content>(source)) {}
Workbook::~Workbook() = default;

const std::vector<Sheet>& Workbook::sheets() const { return content_->sheets; }

SheetRows Workbook::rows(const Sheet& sheet) const {
    SheetRows rows;
    const auto document = parsed(content_->archive, sheet.member, content_->source);
    std::size_t row = 0, bytes = 0;
    for (const auto& line : child(document.document_element(), "sheetData").children()) {
        std::size_t column = 0;
        row = line.attribute("r") ? line.attribute("r").as_ullong() - 1 : row;
        if (row >= most_rows)
            throw FormatError(content_->source.name, {},
                              fmt::format("sheet '{}': '{:.20}' is no row", sheet.name, line.attribute("r").value()));
        for (const auto& cell : line.children()) {
            const std::string_view reference = cell.attribute("r").value();
            if (!reference.empty() && !parse_reference(reference, row, column))
                throw FormatError(content_->source.name, {},
                                  fmt::format("sheet '{}': '{:.20}' is no cell", sheet.name, reference));
            auto text = content_->text(cell, sheet);
            bytes += text.size();
            if (bytes > most_text)
                throw FormatError(content_->source.name, {},
                                  fmt::format("sheet '{}': more than {} MB of text in its cells, at {}", sheet.name,
                                              most_text >> 20, cell_name(row, column)));
            if (!text.empty()) rows[row].insert_or_assign(column, std::move(text));
            ++column;
        }
        ++row;
    }
    return rows;
}

std::string cell_name(std::size_t row, std::size_t column) {
    std::string letters;
    for (auto left = column + 1; left > 0; left = (left - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (left - 1) % 26));
    return fmt::format("{}{}", letters, row + 1);
}

}  // namespace setae::tables
