// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header.hpp"
#include "storage/raster.hpp"

// BCR-STM and BCRF files: a text header of "key = value" lines in 2048 or `headersize` characters of one byte or two
// (UTF-16), then integers of 2 bytes or floating-point values of 4, row after row.
namespace setae::formats {
namespace {

constexpr std::uint64_t usual_characters = 2048, max_characters = 1 << 20;
constexpr double void_integer = 32767.0;
/// Image Metrology writes 1.7014118e38 for a void, NanoFocus 3.402823e38.
constexpr double greatest_float = 1.7e38;

using BcrHeader = std::map<std::string, std::string>;

/// Bytes of a character of the header: 1 or 2; 0 if the bytes are no such header.
std::uint64_t character_bytes(std::string_view head) {
    using namespace std::string_view_literals;
    const bool wide =
        head.starts_with("f\0i\0l\0e\0"sv) || head.starts_with("\xff\xfe") || head.starts_with("\xfe\xff");
    const auto characters = bytes::lowered(
        bytes::decoded(std::string(head.substr(0, 128)), wide ? bytes::Encoding::utf16 : bytes::Encoding::latin1));
    std::string packed;
    for (const char c : characters)
        if (c != ' ' && c != '\t') packed += c;
    return !packed.starts_with("fileformat=bcr") ? 0 : wide ? 2 : 1;
}

BcrHeader parsed(std::string bytes, std::uint64_t width) {
    auto text = bytes::decoded(std::move(bytes), width == 2 ? bytes::Encoding::utf16 : bytes::Encoding::latin1);
    text.resize(std::min(text.find('\0'), text.size()));
    BcrHeader header;
    for (const auto line : bytes::split_lines(text)) {
        const auto equals = line.find('=');
        const auto trimmed_line = trimmed(line);
        if (equals == std::string_view::npos || trimmed_line.starts_with('%') || trimmed_line.starts_with('#'))
            continue;
        header.emplace(bytes::lowered(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1)));
    }
    return header;
}

std::optional<double> number(const BcrHeader& header, const std::string& key, const bytes::Source& source) {
    const auto at = header.find(key);
    if (at == header.end() || at->second.empty()) return std::nullopt;
    double value = 0.0;
    if (!bytes::parse_cell(at->second, '.', value) || !std::isfinite(value))
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("BCR: '{}' is '{:.40}', expected a number", key, at->second));
    return value;
}

std::uint64_t count(const BcrHeader& header, const std::string& key, const bytes::Source& source) {
    const auto value = number(header, key, source);
    if (!value || !(*value >= 1.0) || *value > 2147483648.0 || *value != std::floor(*value))
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("BCR: '{}' is {}, expected an integer from 1 to 2^31", key,
                                      value ? fmt::format("{}", *value) : "missing"));
    return static_cast<std::uint64_t>(*value);
}

/// The unit in the header; nm if there is none, as defined by the format.
std::string unit_of(const BcrHeader& header, const std::string& key) {
    const auto at = header.find(key);
    return at == header.end() || at->second.empty() ? "nm" : at->second;
}

/// n points; NanoFocus, which writes a value in place of the number of voids, counts from the first point to the last.
std::optional<double> size_along(const BcrHeader& header, char axis, std::uint64_t points, bool between_points,
                                 const bytes::Source& source) {
    const auto length = number(header, std::string(1, axis) + "length", source);
    if (!length || !(*length > 0.0)) return std::nullopt;
    const auto name = unit_of(header, std::string(1, axis) + "unit");
    const auto unit = tables::try_parse_unit(name);
    if (!unit || unit->dimension != dimension::length)
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("BCR: {}unit is '{:.40}', expected a unit of length", axis, name));
    const auto n = static_cast<double>(points);
    return *length * unit->factor * (between_points && points > 1 ? n / (n - 1.0) : 1.0);
}

topography::Metadata metadata_of(const BcrHeader& header) {
    topography::Metadata metadata;
    if (const auto at = header.find("starttime"); at != header.end()) metadata.acquisition_time = at->second;
    for (const auto* key : {"xoffset", "yoffset", "zmin", "scanspeed", "bias", "current"})
        if (const auto at = header.find(key); at != header.end()) metadata.attributes[key] = at->second;
    return metadata;
}

Match detect_bcr(std::string_view head, const bytes::Source&) {
    return character_bytes(head) > 0 ? Match::yes : Match::no;
}

std::vector<Channel> open_bcr(const bytes::Source& source, const ReadOptions& options) {
    const auto width = character_bytes(source.head(bytes::detection_bytes));
    const auto probe = parsed(source.head(usual_characters * width), width);
    const auto characters = probe.contains("headersize") ? count(probe, "headersize", source) : usual_characters;
    if (width == 0 || characters > max_characters)
        throw FormatError(
            source.name, {.offset = 0},
            fmt::format("BCR: a header of {} characters, expected {} at most", characters, max_characters));
    const auto header = parsed(source.bytes(0, characters * width), width);
    const auto format = header.contains("fileformat") ? bytes::lowered(header.at("fileformat")) : std::string();
    const bool integers = format == "bcrstm" || format == "bcrstm_unicode";
    if (!integers && format != "bcrf" && format != "bcrf_unicode")
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("BCR: fileformat is '{:.40}', expected bcrstm or bcrf", format));
    if (number(header, "forcecurve", source).value_or(0.0) != 0.0)
        throw FormatError(source.name, {.offset = 0}, "BCR: the file contains a force curve, not a map of heights");

    const auto nx = count(header, "xpixels", source), ny = count(header, "ypixels", source);
    const bool between_points = number(header, "voidpixels", source).value_or(0.0) > greatest_float;
    ChannelInfo info;
    info.format = "bcr";
    info.name = integers ? "integer heights" : "heights";
    info.orientation = "rows from the top, as stored";
    info.metadata = metadata_of(header);
    info.shape = {static_cast<Index>(nx), static_cast<Index>(ny)};
    const auto x = size_along(header, 'x', nx, between_points, source),
               y = size_along(header, 'y', ny, between_points, source);
    if (x && y) info.size = {*x, *y};
    if (between_points)
        info.alerts.push_back(
            {"SIZE_BETWEEN_POINTS", source.name,
             "xlength and ylength are distances from the first point to the last, as NanoFocus writes them; "
             "the size is n/(n − 1) times that",
             "compare with the pixel size that the instrument shows"});
    const auto little_endian = number(header, "intelmode", source).value_or(1.0) != 0.0;
    const Raster raster{.offset = characters * width,
                        .nx = static_cast<Index>(nx),
                        .ny = static_cast<Index>(ny),
                        .sample = integers ? Sample::int16 : Sample::float32,
                        .order = little_endian ? std::endian::little : std::endian::big};
    const auto name = unit_of(header, "zunit");
    const auto unit = tables::try_parse_unit(name);
    if (!unit || unit->dimension != dimension::length) {
        info.unit = name;
        require_raster(raster, source, "BCR");
        return {non_height_channel(std::move(info))};
    }
    RawScale scale{.factor = unit->factor};
    const auto step = number(header, "bit2nm", source);
    if (!integers || step) info.unit = name;
    if (integers && !step) scale.factor = 1.0;  // of a unit that the user must give
    if (integers) scale.undefined = {void_integer};
    if (integers && step) scale.factor *= *step;
    if (!integers) scale.greatest = greatest_float;
    return {raster_channel(std::move(info), source, raster, scale, options)};
}

}  // namespace

Format bcr_format() {
    return {
        .identifier = "bcr",
        .name = "BCR-STM",
        .extensions = ".bcr .bcrf",
        .description =
            "exchange files of Image Metrology, NanoFocus and others: a text header in Latin-1 or UTF-16, then integers of 2 bytes (bcrstm) or floating-point values (bcrf)",
        .heights =
            "integers times bit2nm, floating-point values as they are, in zunit (nm where none is named); 32767 and values above 1.7e38 are undefined, zero never is",
        .orientation = "rows from the top, as stored",
        .not_read = "zmin, kept as an attribute and not added; force curves are refused",
        .reference = "Image Metrology's description of BCR-STM, as used by Gwyddion's module bcrfile",
        .tested_on_real_files = true,
        .detect = detect_bcr,
        .open = open_bcr};
}

}  // namespace setae::formats
