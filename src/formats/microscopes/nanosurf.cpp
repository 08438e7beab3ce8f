// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "probe_channels.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/text_head.hpp"
#include "storage/raster.hpp"

// Sections "[name]" of lines "key=value", then "#!" and the integers of all channels in the order of
// "Gr<group>-Ch<channel>" of the first section. Integers run through their whole range from Dim2Min to Dim2Min +
// Dim2Range; Dim0 and Dim1 are the axes.
namespace setae::formats {
namespace {

constexpr std::string_view first_nanosurf_line = "[DataSet]", last_nanosurf_line = "\n#!";
constexpr std::size_t most_channels_of_nanosurf = 1000;

using TextSection = std::map<std::string, std::string, std::less<>>;
using Sections = std::map<std::string, TextSection, std::less<>>;

std::string text_entry(const TextSection& section, std::string_view key) {
    const auto found = section.find(key);
    return found == section.end() ? std::string() : found->second;
}

Sections parsed(const std::string& head) {
    Sections sections;
    TextSection* current = nullptr;
    const auto text = bytes::decoded(head, bytes::Encoding::detect);
    for (const auto raw : bytes::split_lines(text)) {
        const auto line = trimmed(raw);
        const auto equals = line.find('=');
        if (line.starts_with('[') && line.ends_with(']'))
            current = &sections[std::string(line.substr(1, line.size() - 2))];
        else if (current && equals != std::string_view::npos && !line.starts_with("--"))
            current->insert_or_assign(std::string(trimmed(line.substr(0, equals))),
                                      std::string(trimmed(line.substr(equals + 1))));
    }
    return sections;
}

/// "Gr0-Ch12" and the name of the section of that channel.
struct Place {
    std::uint32_t group = 0, channel = 0;
    std::string section;
};

std::optional<Place> place_of(const std::string& key, const std::string& section) {
    if (!key.starts_with("Gr")) return std::nullopt;
    auto rest = std::string_view(key).substr(2);
    const auto group = leading<std::uint32_t>(rest);
    if (!group || !rest.starts_with("-Ch")) return std::nullopt;
    const auto channel = spelled<std::uint32_t>(rest.substr(3));
    return channel ? std::optional(Place{*group, *channel, section}) : std::nullopt;
}

std::vector<Place> places(const TextSection& dataset, const bytes::Source& source) {
    std::vector<Place> found;
    for (const auto& [key, value] : dataset)
        if (const auto place = place_of(key, value)) found.push_back(*place);
    if (found.size() > most_channels_of_nanosurf)
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("Nanosurf: {} channels, expected at most {}; it is damaged", found.size(),
                                      most_channels_of_nanosurf));
    std::sort(found.begin(), found.end(), [](const Place& a, const Place& b) {
        return std::pair{a.group, a.channel} < std::pair{b.group, b.channel};
    });
    return found;
}

topography::Metadata metadata_of(const Sections& sections, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "nanosurf";
    metadata.instrument.type = "afm";
    metadata.instrument.name = "Nanosurf";
    const auto found = sections.find("DataSet-Info");
    if (found == sections.end()) return metadata;
    const auto& about = found->second;
    if (const auto head = text_entry(about, "Head type"); !head.empty()) metadata.instrument.name += " " + head;
    metadata.acquisition_time = std::string(trimmed(text_entry(about, "Date") + " " + text_entry(about, "Time")));
    for (const auto& [key, attribute] : {std::pair{"Op. mode", "mode"},
                                         {"Cantilever", "cantilever"},
                                         {"Cantilever type", "cantilever"},
                                         {"Scan direction", "scan_direction"},
                                         {"Rotation", "scan_angle"},
                                         {"SW.Version", "software_version"},
                                         {"Software ver.", "software_version"}})
        if (const auto value = text_entry(about, key); !value.empty()) metadata.attributes[attribute] = value;
    return metadata;
}

/// Integers of a channel and the values they stand for.
struct Values {
    Raster raster;
    double factor = 0.0, offset = 0.0;  ///< to Dim2Unit
};

Values values_of(const TextSection& section, std::uint64_t at, const bytes::Source& source) {
    const auto refuse = [&](const std::string& what) {
        throw FormatError(source.name, {.offset = 0}, "Nanosurf: " + what);
    };
    if (const auto mode = text_entry(section, "SaveMode"); mode != "Binary")
        refuse(fmt::format("a channel saved as '{:.40}', expected 'Binary'", mode));
    const auto bits = text_entry(section, "SaveBits"), sign = text_entry(section, "SaveSign"),
               order = text_entry(section, "SaveOrder");
    if ((bits != "8" && bits != "16" && bits != "32") || (sign != "Signed" && sign != "Unsigned") ||
        (order != "Intel" && order != "Motorola"))
        refuse(fmt::format(
            "integers of '{:.10}' bits, '{:.10}', order '{:.10}', expected 8, 16 or 32, Signed or Unsigned, Intel or Motorola",
            bits, sign, order));
    const bool is_signed = sign == "Signed";
    Values values;
    values.raster = {
        .offset = at,
        .nx = static_cast<Index>(tables::header_count(text_entry(section, "Points"), "Points", source, "Nanosurf")),
        .ny = static_cast<Index>(tables::header_count(text_entry(section, "Lines"), "Lines", source, "Nanosurf")),
        .bottom_up = true};
    values.raster.sample = bits == "8"    ? (is_signed ? Sample::int8 : Sample::uint8)
                           : bits == "16" ? (is_signed ? Sample::int16 : Sample::uint16)
                                          : (is_signed ? Sample::int32 : Sample::uint32);
    values.raster.order = order == "Intel" ? std::endian::little : std::endian::big;
    const double range = tables::header_number(text_entry(section, "Dim2Range"), "Dim2Range", source, "Nanosurf"),
                 least = tables::header_number(text_entry(section, "Dim2Min"), "Dim2Min", source, "Nanosurf");
    values.factor = std::ldexp(range, -8 * static_cast<int>(bytes_of(values.raster.sample)));
    values.offset = least + (is_signed ? 0.5 * range : 0.0);
    require_raster(values.raster, source, "Nanosurf");
    return values;
}

/// Extent [m] along each axis; empty where one is no length.
std::vector<double> size_of(const TextSection& section, std::size_t dimensions, const bytes::Source& source) {
    std::vector<double> size;
    for (std::size_t k = 0; k < dimensions; ++k) {
        const auto unit = plain_unit(text_entry(section, fmt::format("Dim{}Unit", k)));
        const auto key = fmt::format("Dim{}Range", k);
        if (!holds_heights({}, unit)) return {};
        size.push_back(std::abs(tables::header_number(text_entry(section, key), key, source, "Nanosurf")) *
                       length_unit(unit, source).factor);
    }
    return size;
}

Channel channel_of(const TextSection& section, const Values& values, ChannelInfo info, const bytes::Source& source,
                   const ReadOptions& options) {
    const auto frame = text_entry(section, "Frame");
    info.name = info.metadata.name = frame.empty() ? text_entry(section, "Dim2Name")
                                                   : fmt::format("{} ({})", text_entry(section, "Dim2Name"), frame);
    if (frame == "Scan forward" || frame == "Scan backward")
        info.metadata.attributes["line_direction"] = frame.substr(5);
    info.unit = plain_unit(text_entry(section, "Dim2Unit"));
    const bool line = values.raster.ny == 1;
    info.shape = line ? std::vector{values.raster.nx} : std::vector{values.raster.nx, values.raster.ny};
    info.size = size_of(section, info.shape.size(), source);
    if (info.size.empty() || !holds_heights(info.name, info.unit)) return non_height_channel(std::move(info));
    if (!line) info.orientation = "rows from the bottom, turned";
    const double metre = length_unit(info.unit, source).factor;
    return raster_channel(std::move(info), source, values.raster,
                          {.factor = metre * values.factor, .offset = metre * values.offset}, options);
}

std::vector<Channel> open_nanosurf(const bytes::Source& source, const ReadOptions& options) {
    const auto head = tables::head_until(source, last_nanosurf_line, "Nanosurf");
    const auto sections = parsed(head);
    ChannelInfo common;
    common.format = "nanosurf";
    common.metadata = metadata_of(sections, source);
    std::uint64_t at = head.size() + last_nanosurf_line.size();
    std::vector<Channel> channels;
    const auto dataset = sections.find("DataSet");
    for (const auto& place : dataset == sections.end() ? std::vector<Place>{} : places(dataset->second, source)) {
        const auto found = sections.find(place.section);
        if (found == sections.end()) continue;
        const auto values = values_of(found->second, at, source);
        channels.push_back(channel_of(found->second, values, common, source, options));
        at += static_cast<std::uint64_t>(values.raster.ny) * values.raster.row_distance();
    }
    if (channels.empty())
        throw FormatError(source.name, {.offset = 0}, "Nanosurf: the header that begins here names no channel");
    return channels;
}

Match detect_nanosurf(std::string_view head, const bytes::Source&) {
    return head.starts_with(first_nanosurf_line) && (head.substr(first_nanosurf_line.size()).starts_with('\r') ||
                                                     head.substr(first_nanosurf_line.size()).starts_with('\n'))
               ? Match::yes
               : Match::no;
}

}  // namespace

Format nanosurf_format() {
    return {
        .identifier = "nanosurf",
        .name = "Nanosurf",
        .extensions = ".ezd .nid",
        .description =
            "Nanosurf easyScan and later: sections of text, then integers of 8, 16 or 32 bits, signed or not, in either byte order, a channel after the other",
        .heights =
            "Dim2Min plus raw, from its least possible value on, times Dim2Range over 2^bits; no point is undefined",
        .orientation = "rows stored from the bottom, turned",
        .not_read = "channels that are no heights, and spectra, are listed",
        .reference = "Gwyddion's module ezdfile",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_nanosurf,
        .open = open_nanosurf};
}

}  // namespace setae::formats
