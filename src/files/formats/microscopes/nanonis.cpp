// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "probe_channels.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/text_head.hpp"
#include "storage/raster.hpp"

// Nanonis scans: lines ":KEY:" with values below them up to ":SCANIT_END:", blank lines, the bytes 0x1a 0x04, then a
// map of big-endian float32 for each channel and direction of its table DATA_INFO, in SI units. Lines are stored as
// scanned: from the bottom if SCAN_DIR is up, from the right in the backward direction. Lines that were not scanned are
// NaN.
namespace setae::formats {
namespace {

constexpr const char* nanonis_name = "Nanonis";
constexpr std::string_view nanonis_first_key = ":NANONIS_VERSION:", nanonis_last_key = ":SCANIT_END:",
                           nanonis_data_mark = "\x1a\x04";
constexpr std::uint64_t longest_gap = 64;  ///< between the last key and the data

using NanonisEntries = std::map<std::string, std::vector<std::string>>;

NanonisEntries nanonis_entries(const std::string& head) {
    NanonisEntries entries;
    const auto text = bytes::decoded(head, bytes::Encoding::detect);
    std::vector<std::string>* values = nullptr;
    for (const auto line : bytes::split_lines(text)) {
        const auto content = trimmed(line);
        if (content.size() > 2 && content.front() == ':' && content.back() == ':')
            values = &entries[std::string(content.substr(1, content.size() - 2))];
        else if (values && !content.empty()) values->emplace_back(content);
    }
    return entries;
}

/// The first line below a key; empty if there is none.
std::string first_line(const NanonisEntries& entries, const std::string& key) {
    const auto found = entries.find(key);
    return found == entries.end() || found->second.empty() ? std::string() : found->second.front();
}

std::vector<std::string> nanonis_words(const std::string& line, char separator = ' ') {
    std::vector<std::string_view> cells;
    tables::split_cells(line, separator, cells);
    std::vector<std::string> words;
    for (const auto cell : cells) words.emplace_back(trimmed(cell));
    return words;
}

/// Two numbers of a line: pixels or lengths along x and y.
std::vector<std::string> pair_below(const NanonisEntries& entries, const std::string& key,
                                    const bytes::Source& source) {
    auto words = nanonis_words(first_line(entries, key));
    if (words.size() < 2)
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("Nanonis: '{}' is '{:.40}' in the header that begins here, expected two numbers",
                                      key, first_line(entries, key)));
    return words;
}

/// A channel of the table DATA_INFO.
struct NanonisChannel {
    std::string name, unit;
    bool forward = true, backward = true;
};

std::vector<NanonisChannel> nanonis_channels(const NanonisEntries& entries, const bytes::Source& source) {
    const auto table = entries.find("DATA_INFO");
    if (table == entries.end() || table->second.size() < 2)
        throw FormatError(source.name, {.offset = 0}, "Nanonis: a header without channels (DATA_INFO)");
    const auto names = nanonis_words(table->second.front(), '\t');
    const auto column = [&](const char* name) {
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end())
            throw FormatError(source.name, {.offset = 0},
                              fmt::format("Nanonis: the table DATA_INFO has no column '{}'", name));
        return static_cast<std::size_t>(found - names.begin());
    };
    const auto name = column("Name"), unit = column("Unit"), direction = column("Direction");
    std::vector<NanonisChannel> channels;
    for (std::size_t k = 1; k < table->second.size(); ++k) {
        const auto cells = nanonis_words(table->second[k], '\t');
        if (cells.size() <= std::max({name, unit, direction}))
            throw FormatError(source.name, {.offset = 0},
                              fmt::format("Nanonis: channel {} of DATA_INFO has {} cells, expected {}", k - 1,
                                          cells.size(), names.size()));
        const auto way = bytes::lowered(cells[direction]);
        if (way != "both" && !way.starts_with("forw") && !way.starts_with("back"))
            throw FormatError(source.name, {.offset = 0},
                              fmt::format("Nanonis: the direction of channel '{:.40}' is '{:.40}', expected both, "
                                          "forward or backward",
                                          cells[name], way));
        channels.push_back({cells[name], cells[unit], way == "both" || way.starts_with("forw"),
                            way == "both" || way.starts_with("back")});
    }
    return channels;
}

/// "23.11.2008" and "10:11:12" as "2008-11-23 10:11:12"; unchanged if the date has another form.
std::string nanonis_time(const NanonisEntries& entries) {
    auto date = first_line(entries, "REC_DATE");
    if (date.size() == 10 && date[2] == '.' && date[5] == '.')
        date = fmt::format("{}-{}-{}", date.substr(6, 4), date.substr(3, 2), date.substr(0, 2));
    const auto time = first_line(entries, "REC_TIME");
    return date.empty() || time.empty() ? date : date + " " + time;
}

topography::Metadata nanonis_metadata(const NanonisEntries& entries, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.instrument.type = "afm";
    metadata.instrument.name = nanonis_name;
    metadata.acquisition_time = nanonis_time(entries);
    for (const auto& [key, attribute] : {std::pair{"NANONIS_VERSION", "software_version"},
                                         {"SCAN_ANGLE", "scan_angle"},
                                         {"SCAN_DIR", "scan_direction"},
                                         {"BIAS", "bias"},
                                         {"COMMENT", "comment"}})
        if (const auto value = first_line(entries, key); !value.empty()) metadata.attributes[attribute] = value;
    return metadata;
}

Match detect_nanonis(std::string_view head, const bytes::Source&) {
    return head.starts_with(nanonis_first_key) && head.find(":SCAN_PIXELS:") != std::string_view::npos ? Match::yes
                                                                                                       : Match::no;
}

/// Start of the numbers, after the end of the header.
std::uint64_t data_offset(std::uint64_t header_end, const bytes::Source& source) {
    const auto gap = source.up_to(header_end, longest_gap);
    const auto mark = gap.find(nanonis_data_mark);
    if (mark == std::string::npos)
        throw FormatError(source.name, {.offset = header_end},
                          "Nanonis: the bytes 0x1a 0x04 that begin the data are missing here; the file is truncated or "
                          "damaged");
    return header_end + mark + nanonis_data_mark.size();
}

std::vector<Channel> open_nanonis(const bytes::Source& source, const ReadOptions& options) {
    const auto head = tables::head_until(source, nanonis_last_key, nanonis_name);
    const auto entries = nanonis_entries(head);
    const auto kind = bytes::lowered(first_line(entries, "SCANIT_TYPE"));
    if (kind.find("float") == std::string::npos || kind.find("msbfirst") == std::string::npos)
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("Nanonis: data of type '{:.40}', expected FLOAT MSBFIRST", kind));
    const auto pixels = pair_below(entries, "SCAN_PIXELS", source), range = pair_below(entries, "SCAN_RANGE", source);
    Raster raster{.offset = data_offset(head.size() + nanonis_last_key.size(), source),
                  .nx = static_cast<Index>(tables::header_count(pixels[0], "SCAN_PIXELS", source, nanonis_name)),
                  .ny = static_cast<Index>(tables::header_count(pixels[1], "SCAN_PIXELS", source, nanonis_name)),
                  .sample = Sample::float32,
                  .order = std::endian::big,
                  .bottom_up = bytes::lowered(first_line(entries, "SCAN_DIR")) == "up"};
    const auto width = std::abs(tables::header_number(range[0], "SCAN_RANGE", source, nanonis_name)),
               height = std::abs(tables::header_number(range[1], "SCAN_RANGE", source, nanonis_name));
    ChannelInfo common{.format = "nanonis"};
    if (raster.ny > 1)
        common.orientation = raster.bottom_up ? "rows from the bottom, turned" : "rows from the top, as stored";
    if (width > 0.0 && height > 0.0) common.size = {width, height};
    common.metadata = nanonis_metadata(entries, source);
    std::vector<Channel> channels;
    const auto map_bytes =
        sizeof(float) * static_cast<std::uint64_t>(raster.nx) * static_cast<std::uint64_t>(raster.ny);
    for (const auto& channel : nanonis_channels(entries, source))
        for (const bool forward : {true, false}) {
            if (forward ? !channel.forward : !channel.backward) continue;
            auto info = common;
            info.name = info.metadata.name = fmt::format("{} ({})", channel.name, forward ? "forward" : "backward");
            info.metadata.attributes["line_direction"] = forward ? "forward" : "backward";
            info.unit = channel.unit;
            raster.right_to_left = !forward;
            require_raster(raster, source, nanonis_name);
            if (holds_heights(info.name, info.unit)) {
                channels.push_back(raster_channel(std::move(info), source, raster, {}, options));
            } else {
                info.shape = {raster.nx, raster.ny};
                channels.push_back(non_height_channel(std::move(info)));
            }
            raster.offset += map_bytes;
        }
    return channels;
}

}  // namespace

Format nanonis_format() {
    return {
        .identifier = "nanonis",
        .name = "Nanonis scan",
        .extensions = ".sxm",
        .description = "scans of SPECS' Nanonis controllers: every channel of the file, forward and backward",
        .heights = "float32 in metres; lines that were not scanned, NaN and infinities are undefined",
        .orientation =
            "rows from the bottom, turned, where the scan ran up, else from the top; lines scanned backward are mirrored",
        .not_read =
            "channels that are no lengths, and amplitudes, are listed; spectra and grids of Nanonis are refused",
        .reference = "Gwyddion's module nanonis; nanonispy's reader",
        .tested_on_real_files = false,
        .carries_scale = true,
        .read_elsewhere = false,
        .detect = detect_nanonis,
        .open = open_nanonis};
}

}  // namespace setae::formats
