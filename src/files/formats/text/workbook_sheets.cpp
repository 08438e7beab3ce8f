// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/spreadsheet.hpp"
#include "text_channels.hpp"

// Workbooks: columns of numbers in a sheet are interpreted as in a text with the same cells.
namespace setae::formats {
namespace {

constexpr const char* workbook_identifier = "workbook";

/// An error without the name of the text of a sheet and the line, with which it begins.
std::string reason_without(const std::string& text, const std::string& name) {
    if (!text.starts_with(name + ":")) return text;
    const auto blank = text.find(": ", name.size());
    return blank == std::string::npos ? text : text.substr(blank + 2);
}

std::string channel_name(const std::string& sheet, const std::string& name, bool several) {
    if (name.empty()) return sheet;
    return several ? fmt::format("{}: {}", sheet, name) : name;
}

std::vector<Channel> open_workbook(const bytes::Source& source, const ReadOptions& options) {
    std::vector<Channel> channels;
    std::string problems;
    const auto sheets = tables::spreadsheet_texts(source);
    const auto note = [&](const std::string& problem) { problems += (problems.empty() ? "" : "; ") + problem; };
    for (const auto& sheet : sheets) {
        if (!sheet.problem.empty()) {
            note(sheet.problem);
            continue;
        }
        const auto text = bytes::memory_source(fmt::format("{}, sheet '{}'", source.name, sheet.sheet), sheet.text);
        try {
            for (auto& channel : open_text(text, options)) {
                channel.info.name = channel_name(sheet.sheet, channel.info.name, sheets.size() > 1);
                channel.info.format = workbook_identifier;
                channel.info.metadata.attributes["sheet"] = sheet.sheet;
                channels.push_back(std::move(channel));
            }
        } catch (const FormatError& error) {
            note(fmt::format("sheet '{}': {}", sheet.sheet, reason_without(error.what(), text.name)));
        }
    }
    if (channels.empty()) throw FormatError(source.name, {}, "the workbook has no heights: " + problems);
    return channels;
}

Match detect_workbook(std::string_view, const bytes::Source& source) {
    return tables::is_spreadsheet(source) ? Match::yes : Match::no;
}

}  // namespace

Format workbook_format() {
    return {
        .identifier = workbook_identifier,
        .name = "workbook",
        .extensions = ".xlsx .ods",
        .description =
            "Excel's and LibreOffice's workbooks: x and height, points x, y, z or a matrix on any sheet, "
            "each sheet read as a text with the same cells; `channel` selects a sheet by its name",
        .heights =
            "values in the unit stated or given; results of formulas count, text that spells a number too, also with a decimal comma; empty cells and errors such as #N/A are undefined",
        .orientation = "first row at the top",
        .not_read =
            "columns of words and dates, charts, and sheets without numbers; .xls and .xlsb are refused: save them as .xlsx",
        .reference = "ECMA-376 part 1, 18; OASIS, OpenDocument 1.3 part 3, 9",
        .tested_on_real_files = false,
        .carries_scale = false,
        .read_elsewhere = false,
        .detect = detect_workbook,
        .open = open_workbook};
}

}  // namespace setae::formats
