// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/header_number.hpp"
#include "storage/raster.hpp"

// Alicona AL3D: a magic of 17 bytes, tags of 52 bytes (key 20, value 30, CR LF; the first two are Version and TagCount,
// the number of the following tags), a comment of 256 bytes, pictures and the depth image at offsets in tags: float32
// in metres, rows padded to 8 bytes.
namespace setae::formats {
namespace {

using namespace std::string_view_literals;

constexpr auto al3d_magic = "AliconaImaging\0\r\n"sv;
constexpr std::uint64_t key_bytes = 20, value_bytes = 30, tag_bytes = 52, comment_bytes = 256;
/// Tolerance of the marker of invalid pixels, which the header prints with fewer digits.
constexpr double marker_tolerance = 1.5e-7;

struct Tags {
    std::map<std::string, std::string> values;
    std::uint64_t end = 0;
    std::string comment;
};

std::pair<std::string, std::string> read_tag(bytes::Cursor& cursor) {
    const auto at = cursor.position();
    auto key = cursor.text(key_bytes), value = cursor.text(value_bytes);
    if (cursor.bytes(2) != "\r\n") {
        cursor.seek(at);
        cursor.fail(fmt::format("the tag '{:.20}' does not end with CR LF; the header is damaged", key));
    }
    return {std::move(key), std::move(value)};
}

std::string required_tag(bytes::Cursor& cursor, const std::string& name) {
    const auto at = cursor.position();
    const auto [key, value] = read_tag(cursor);
    if (key != name) {
        cursor.seek(at);
        cursor.fail(fmt::format("got the tag '{:.20}', expected '{}'", key, name));
    }
    return value;
}

Tags read_tags(const bytes::Source& source) {
    bytes::Cursor cursor(source, "Alicona", al3d_magic.size());
    Tags tags;
    tags.values["Version"] = required_tag(cursor, "Version");
    const auto announced = required_tag(cursor, "TagCount");
    const auto count = tables::count_in(announced);
    if (!count || static_cast<std::uint64_t>(*count) > source.size / tag_bytes)
        cursor.fail(fmt::format("'{:.30}' tags announced, more than the file can contain; it is truncated or damaged",
                                announced));
    for (Index i = 0; i < *count; ++i) {
        auto [key, value] = read_tag(cursor);
        tags.values.insert_or_assign(std::move(key), std::move(value));
    }
    tags.comment = cursor.text(comment_bytes);
    tags.end = cursor.position();
    return tags;
}

double number_of(const Tags& tags, const std::string& key, const bytes::Source& source) {
    const auto at = tags.values.find(key);
    const auto value = at == tags.values.end() ? std::nullopt : tables::finite_number(at->second);
    if (!value)
        throw FormatError(source.name, {.offset = tags.end},
                          fmt::format("Alicona: the tag '{}' is {}, expected a number", key,
                                      at == tags.values.end() ? "missing" : "'" + at->second + "'"));
    return *value;
}

Index count_of(const Tags& tags, const std::string& key, const bytes::Source& source) {
    const double value = number_of(tags, key, source);
    if (!(value >= 0.0 && value <= 0x1p40 && value == std::floor(value)))
        throw FormatError(source.name, {.offset = tags.end},
                          fmt::format("Alicona: the tag '{}' is {}, expected a whole number >= 0", key, value));
    return static_cast<Index>(value);
}

/// The float values of InvalidPixelValue: all within its tolerance, a few of either sign.
std::vector<double> undefined_values(const Tags& tags) {
    const auto at = tags.values.find("InvalidPixelValue");
    const auto marker = at == tags.values.end() ? std::nullopt : tables::finite_number(at->second);
    if (!marker || std::abs(*marker) > std::numeric_limits<float>::max()) return {};
    const auto nearest = static_cast<float>(*marker);
    const auto meant = [&](float value) {
        return std::abs(static_cast<double>(value) - *marker) <= marker_tolerance * std::abs(*marker);
    };
    std::vector<double> values{nearest};
    for (const float direction : {-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()})
        for (float value = std::nextafter(nearest, direction); *marker != 0.0 && std::isfinite(value) && meant(value);
             value = std::nextafter(value, direction))
            values.push_back(value);
    return values;
}

/// The texture after the depth image is not read, but a file with an incomplete texture is truncated: planes of bytes,
/// rows padded to 8.
void require_texture(const Tags& tags, const Raster& depth, const bytes::Source& source) {
    if (!tags.values.contains("TextureImageOffset")) return;
    const auto offset = count_of(tags, "TextureImageOffset", source);
    const auto planes = tags.values.contains("NumberOfPlanes") ? count_of(tags, "NumberOfPlanes", source) : Index{1};
    if (offset == 0 || planes == 0) return;
    constexpr Index max_planes = 16;
    if (planes > max_planes)
        throw FormatError(source.name, {.offset = tags.end},
                          fmt::format("Alicona: {} planes, expected {} at most", planes, max_planes));
    const auto row = (static_cast<std::uint64_t>(depth.nx) + 7) / 8 * 8;
    const Raster texture{.offset = static_cast<std::uint64_t>(offset),
                         .nx = depth.nx,
                         .ny = depth.ny * planes,
                         .sample = Sample::uint8,
                         .line_distance = row};
    require_raster(texture, source, "Alicona");
}

std::vector<Channel> open_al3d(const bytes::Source& source, const ReadOptions& options) {
    const auto tags = read_tags(source);
    Raster raster{
        .nx = count_of(tags, "Cols", source), .ny = count_of(tags, "Rows", source), .sample = Sample::float32};
    raster.line_distance = (static_cast<std::uint64_t>(raster.nx) * sizeof(float) + 7) / 8 * 8;
    raster.offset = static_cast<std::uint64_t>(count_of(tags, "DepthImageOffset", source));
    if (raster.offset < tags.end)
        throw FormatError(
            source.name, {.offset = tags.end},
            fmt::format("Alicona: no depth image (its offset is {}); files with only pictures are not read",
                        raster.offset));
    require_raster(raster, source, "Alicona");
    require_texture(tags, raster, source);
    ChannelInfo info{.name = "depth image", .format = "al3d"};
    info.unit = "m";
    info.orientation = "rows from the top, as stored; not stated in the file, taken as Gwyddion shows it";
    info.metadata.instrument.name = "Alicona";
    info.metadata.instrument.type = "optical";
    for (const auto& [tag, attribute] : {std::pair{"CreatingApplication", "software_version"},
                                         {"DepthResMinVal", "depth_resolution_least"},
                                         {"DepthResFilterVal", "depth_resolution_filter"},
                                         {"Version", "format_version"}})
        if (const auto at = tags.values.find(tag); at != tags.values.end() && !at->second.empty())
            info.metadata.attributes[attribute] = at->second;
    if (!tags.comment.empty()) info.metadata.attributes["comment"] = tags.comment;
    const double dx = std::abs(number_of(tags, "PixelSizeXMeter", source)),
                 dy = std::abs(number_of(tags, "PixelSizeYMeter", source));
    if (dx > 0.0 && dy > 0.0) info.size = {dx * static_cast<double>(raster.nx), dy * static_cast<double>(raster.ny)};
    return {raster_channel(std::move(info), source, raster, {.undefined = undefined_values(tags)}, options)};
}

}  // namespace

Format al3d_format() {
    return {
        .identifier = "al3d",
        .name = "Alicona Imaging",
        .extensions = ".al3d",
        .description = "focus-variation instruments of Alicona (Bruker): tags, pictures and a depth image",
        .heights = "float32 in metres; undefined: NaN and values within 1.5e-7 of InvalidPixelValue, whatever its sign",
        .orientation = "rows stored from the top; the file does not state it",
        .not_read = "the icon and the texture picture are passed over",
        .reference = "alicona module of Gwyddion, AL3D reader of SurfaceTopography 1.27",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = [](std::string_view head,
                     const bytes::Source&) { return head.starts_with(al3d_magic) ? Match::yes : Match::no; },
        .open = open_al3d};
}

}  // namespace setae::formats
