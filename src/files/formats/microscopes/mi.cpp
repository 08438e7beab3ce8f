// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "probe_channels.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/text_head.hpp"
#include "storage/raster.hpp"

// Header of lines whose key is the first 14 characters; "bufferLabel" begins a channel, "data" ends the header and
// defines the storage of the channels, in sequence: integers of 2 or 4 bytes or as text, in parts of the range of the
// channel; or real numbers in its unit.
namespace setae::formats {
namespace {

constexpr std::string_view first_key = "fileType", last_key = "\ndata          ";
constexpr std::size_t key_width = 14, max_channels = 1000;

using MiEntries = std::map<std::string, std::string, std::less<>>;

struct MiFile {
    MiEntries entries;
    std::vector<MiEntries> channels;
    std::string encoding;
    std::uint64_t data_at = 0;
    std::uint64_t nx = 0, ny = 0;
};

[[noreturn]] void refuse(const bytes::Source& source, std::uint64_t offset, const std::string& what) {
    throw FormatError(source.name, {.offset = offset}, "MI: " + what);
}

std::string entry(const MiEntries& entries, std::string_view key) {
    const auto found = entries.find(key);
    return found == entries.end() ? std::string() : found->second;
}

MiFile parsed(const bytes::Source& source) {
    const auto head = tables::head_until(source, last_key, "MI");
    MiFile file;
    const auto rest_at = head.size() + last_key.size();
    const auto rest = source.bytes(rest_at, std::min<std::uint64_t>(64, source.size - rest_at));
    const auto end = rest.find('\n');
    if (end == std::string::npos)
        refuse(source, source.size,
               "the file ends here, within the line that describes how data are written; it is truncated");
    file.encoding = trimmed(std::string_view(rest).substr(0, end));
    file.data_at = rest_at + end + 1;
    auto* entries = &file.entries;
    const auto text = bytes::decoded(head, bytes::Encoding::detect);
    for (const auto line : bytes::split_lines(text)) {
        if (line.starts_with(' ') || line.size() < 2) continue;
        const std::string key(trimmed(line.substr(0, key_width)));
        if (key == "bufferLabel") {
            if (file.channels.size() == max_channels)
                refuse(source, 0, fmt::format("more than {} channels; it is damaged", max_channels));
            entries = &file.channels.emplace_back();
        }
        entries->insert_or_assign(
            key, line.size() > key_width ? std::string(trimmed(line.substr(key_width))) : std::string());
    }
    if (entry(file.entries, "fileType") != "Image")
        refuse(
            source, 0,
            fmt::format("a file of type '{:.40}', not an image; `setae jkr fit` reads force curves from the text that "
                        "the program of the instrument exports",
                        entry(file.entries, "fileType")));
    file.nx = tables::header_count(entry(file.entries, "xPixels"), "xPixels", source, "MI");
    file.ny = tables::header_count(entry(file.entries, "yPixels"), "yPixels", source, "MI");
    if (file.channels.empty()) refuse(source, 0, "no channel ('bufferLabel') in the header that begins here");
    return file;
}

topography::Metadata metadata_of(const MiFile& file, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "mi";
    metadata.instrument.type = "afm";
    metadata.instrument.name = "Agilent (Molecular Imaging)";
    metadata.acquisition_time = entry(file.entries, "dateAcquired");
    for (const auto& [key, attribute] : {std::pair{"version", "software_version"},
                                         {"mode", "mode"},
                                         {"scanAngle", "scan_angle"},
                                         {"scanSpeed", "scan_speed"},
                                         {"forceConstant", "spring_constant"},
                                         {"comment", "comment"}})
        if (const auto value = entry(file.entries, key); !value.empty()) metadata.attributes[attribute] = value;
    if (const auto up = entry(file.entries, "scanUp"); !up.empty())
        metadata.attributes["scan_direction"] = up == "TRUE" ? "up" : "down";
    return metadata;
}

/// Numbers as text, channels in sequence or in columns; rows begin at the bottom.
topography::Measurement words(const bytes::Source& source, const MiFile& file, std::size_t channel, double factor,
                              const ChannelInfo& info) {
    const auto text = source.bytes(file.data_at, source.size - file.data_at);
    const bool columns = file.encoding == "ASCII_MULTICOLUMN";
    const auto points = file.nx * file.ny;
    const auto distance = columns ? file.channels.size() : 1, first = columns ? channel : channel * points;
    if (points > text.size() / 2 + 1)
        refuse(source, source.size,
               fmt::format("the file ends here, but it announces {} × {} points; it is truncated", file.nx, file.ny));
    Array2D heights(static_cast<Index>(file.nx), static_cast<Index>(file.ny));
    std::size_t at = 0;
    std::uint64_t number = 0, found = 0;
    while (found < points) {
        at = text.find_first_not_of(" \t\r\n", at);
        if (at == std::string::npos)
            refuse(source, source.size,
                   fmt::format("the file ends here, after {} of {} numbers of '{}'; it is truncated", found, points,
                               info.name));
        const auto end = std::min(text.find_first_of(" \t\r\n", at), text.size());
        if (number >= first && (number - first) % distance == 0) {
            double value = 0.0;
            if (!bytes::parse_cell(std::string_view(text).substr(at, end - at), '.', value))
                refuse(source, file.data_at + at, fmt::format("'{:.40}' is not a number", text.substr(at, end - at)));
            heights(static_cast<Index>(found % file.nx), static_cast<Index>(file.ny - 1 - found / file.nx)) =
                factor * value;
            ++found;
        }
        at = end;
        ++number;
    }
    return checked(topography::HeightMap{std::move(heights), {info.size[0], info.size[1]}, false, info.metadata},
                   source);
}

Channel channel_of(const MiFile& file, std::size_t number, ChannelInfo info, const bytes::Source& source,
                   const ReadOptions& options) {
    const auto& entries = file.channels[number];
    info.name = entry(entries, "bufferLabel");
    info.unit = plain_unit(entry(entries, "bufferUnit"));
    if (const auto direction = bytes::lowered(entry(entries, entries.contains("trace") ? "trace" : "direction"));
        !direction.empty()) {
        info.metadata.attributes["line_direction"] = direction;
        info.name += fmt::format(" ({})", direction);
    }
    info.metadata.name = info.name;
    info.shape = {static_cast<Index>(file.nx), static_cast<Index>(file.ny)};
    info.size = {tables::header_number(entry(file.entries, "xLength"), "xLength", source, "MI"),
                 tables::header_number(entry(file.entries, "yLength"), "yLength", source, "MI")};
    const bool in_words = file.encoding.starts_with("ASCII"), in_range = !in_words || file.encoding == "ASCII";
    const bool wide = file.encoding == "BINARY_32";
    const double range =
        in_range ? tables::header_number(entry(entries, "bufferRange"), "bufferRange", source, "MI") : 1.0;
    const Sample sample = wide ? Sample::int32 : Sample::int16;
    const auto channel_bytes = file.nx * file.ny * bytes_of(sample);
    if (!in_words && (file.nx > source.size / file.ny || (number + 1) * channel_bytes > source.size - file.data_at))
        refuse(source, source.size,
               fmt::format("the file ends here, before the last of the {} × {} values of '{}'; it is truncated",
                           file.nx, file.ny, info.name));
    if (!info.unit.empty() && !holds_heights(info.name, info.unit)) return non_height_channel(std::move(info));
    info.orientation = "rows from the bottom, turned, whatever the direction of the scan";
    const double metre = info.unit.empty() ? 1.0 : length_unit(info.unit, source).factor;
    if (in_words) {
        const double given = complete(info, options, source);
        if (info.unit.empty()) return incomplete_channel(std::move(info), source);
        const double factor = given * metre * (in_range ? std::ldexp(range, -15) : 1.0);
        auto read = [source, file, number, factor, info] { return words(source, file, number, factor, info); };
        return {info, std::move(read)};
    }
    const Raster raster{.offset = file.data_at + number * channel_bytes,
                        .nx = info.shape[0],
                        .ny = info.shape[1],
                        .sample = sample,
                        .bottom_up = true};
    return raster_channel(std::move(info), source, raster, {.factor = metre * std::ldexp(range, wide ? -31 : -15)},
                          options);
}

std::vector<Channel> open_mi(const bytes::Source& source, const ReadOptions& options) {
    const auto file = parsed(source);
    bool known = false;
    for (const auto* encoding : {"", "BINARY", "BINARY_32", "ASCII", "ASCII_ABSOLUTE", "ASCII_MULTICOLUMN"})
        known = known || file.encoding == encoding;
    if (!known)
        refuse(
            source, file.data_at,
            fmt::format("data written as '{}', expected BINARY, BINARY_32, ASCII, ASCII_ABSOLUTE or ASCII_MULTICOLUMN",
                        file.encoding));
    ChannelInfo common;
    common.format = "mi";
    common.metadata = metadata_of(file, source);
    std::vector<Channel> channels;
    for (std::size_t k = 0; k < file.channels.size(); ++k)
        channels.push_back(channel_of(file, k, common, source, options));
    return channels;
}

Match detect_mi(std::string_view head, const bytes::Source&) {
    const bool found =
        head.starts_with(first_key) && head.size() > key_width &&
        (head.substr(key_width).starts_with("Image") || head.substr(key_width).starts_with("Spectroscopy"));
    return found ? Match::yes : Match::no;
}

}  // namespace

Format mi_format() {
    return {
        .identifier = "mi",
        .name = "Agilent PicoView",
        .extensions = ".mi",
        .description =
            "Agilent and Molecular Imaging: text header and channels of integers of 2 or 4 bytes, or numbers in words (ASCII, ASCII_ABSOLUTE, ASCII_MULTICOLUMN)",
        .heights =
            "raw over 2^15 or 2^31 times the range of the channel, in its unit; absolute and multicolumn text is in that unit; sizes are in metres; no point is undefined",
        .orientation = "rows stored from the bottom, turned, for scans upwards and downwards",
        .not_read = "channels that are not heights are listed; spectroscopy files; a thumbnail after the channels",
        .reference = "Gwyddion's module mifile, by Molecular Imaging; text dialects as the package magni takes them",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_mi,
        .open = open_mi};
}

}  // namespace setae::formats
