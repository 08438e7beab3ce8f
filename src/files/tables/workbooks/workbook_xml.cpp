// SPDX-License-Identifier: GPL-3.0-or-later
#include "workbooks/workbook_xml.hpp"

#include <chrono>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "setae/bytes/nesting.hpp"
#include "setae/core/errors.hpp"

namespace setae::tables {

const char* local_name(const pugi::xml_node& node) {
    const char* colon = std::strchr(node.name(), ':');
    return colon ? colon + 1 : node.name();
}

pugi::xml_node local_child(const pugi::xml_node& parent, const char* name) {
    for (const auto& node : parent.children())
        if (std::strcmp(local_name(node), name) == 0) return node;
    return {};
}

pugi::xml_document parsed_member(const bytes::Archive& archive, const std::string& member,
                                 const bytes::Source& source) {
    pugi::xml_document document;
    const auto text = archive.read(member);
    if (const auto at = bytes::xml_too_deep(text))
        throw FormatError(
            source.name, {},
            fmt::format("member '{}': XML of more than {} levels, at byte {}", member, bytes::max_levels, *at));
    const auto result =
        document.load_buffer(text.data(), text.size(), pugi::parse_default | pugi::parse_ws_pcdata_single);
    if (!result)
        throw FormatError(
            source.name, {},
            fmt::format("member '{}' is not XML: {} at byte {}", member, result.description(), result.offset));
    return document;
}

std::string date_text(double days) {
    using namespace std::chrono;
    constexpr double last_day = 2958466.0;  // of the year 9999
    if (!(days >= 0.0 && days < last_day)) return fmt::format("date {}", days);
    const auto whole = std::floor(days);
    const auto seconds_of_day = static_cast<long>(std::lround((days - whole) * 86400.0));
    const auto clock =
        fmt::format("{:02}:{:02}:{:02}", seconds_of_day / 3600, seconds_of_day / 60 % 60, seconds_of_day % 60);
    if (whole == 0.0) return clock;
    const year_month_day date{sys_days{year{1899} / 12 / 30} + std::chrono::days(static_cast<long>(whole))};
    const auto day = fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                                 static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
    return seconds_of_day == 0 ? day : day + " " + clock;
}

void put_cell(SheetRows& rows, std::size_t row, std::size_t column, std::string text, std::size_t& bytes,
              const Sheet& sheet, const bytes::Source& source) {
    if (row >= max_sheet_rows || column >= max_sheet_columns)
        throw FormatError(source.name, {},
                          fmt::format("sheet '{}': a cell in row {}, column {}, beyond the {} × {} that sheets have",
                                      sheet.name, row + 1, column + 1, max_sheet_rows, max_sheet_columns));
    bytes += text.size();
    if (bytes > max_sheet_text)
        throw FormatError(source.name, {},
                          fmt::format("sheet '{}': more than {} MB of text in its cells, at {}", sheet.name,
                                      max_sheet_text >> 20, cell_name(row, column)));
    if (!text.empty()) rows[row].insert_or_assign(column, std::move(text));
}

}  // namespace setae::tables
