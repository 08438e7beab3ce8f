// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/core/errors.hpp"
#include "storage/raster.hpp"

// TrueMap files, version 2: a signature in 32 bytes, a comment that ends with a NUL, points, lengths and offsets, then
// floating-point heights. Neither lengths nor heights have a unit: TrueMap works in mm.
namespace setae::formats {
namespace {

constexpr std::string_view tmd_signature = "Binary TrueMap Data File v2.0";
constexpr std::uint64_t comment_offset = 32, usual_comment_bytes = 24, longest_comment = 4096, dimensions_bytes = 24;

struct Dimensions {
    Index nx = 0, ny = 0;
    double length_x = 0.0, length_y = 0.0;
    std::uint64_t data_offset = 0;

    [[nodiscard]] std::uint64_t end() const {
        return data_offset + sizeof(float) * static_cast<std::uint64_t>(nx) * static_cast<std::uint64_t>(ny);
    }
};

Dimensions dimensions_at(bytes::Cursor& cursor, std::uint64_t offset) {
    cursor.seek(offset);
    Dimensions dimensions;
    dimensions.nx = cursor.number<std::uint32_t>();
    dimensions.ny = cursor.number<std::uint32_t>();
    dimensions.length_x = cursor.number<float>();
    dimensions.length_y = cursor.number<float>();
    dimensions.data_offset = offset + dimensions_bytes;
    return dimensions;
}

/// After the NUL of the comment, or after 24 bytes if only that is consistent with the length of the file.
Dimensions find_dimensions(bytes::Cursor& cursor, const std::string& comment) {
    const auto& source = cursor.source();
    const auto after_nul = comment_offset + comment.find('\0') + 1;
    const auto dimensions = dimensions_at(cursor, after_nul);
    constexpr auto usual_offset = comment_offset + usual_comment_bytes;
    if (dimensions.end() == source.size || after_nul == usual_offset || source.size < usual_offset + dimensions_bytes)
        return dimensions;
    const auto usual = dimensions_at(cursor, usual_offset);
    return usual.end() == source.size ? usual : dimensions;
}

Match detect_tmd(std::string_view head, const bytes::Source&) {
    return head.starts_with(tmd_signature) ? Match::yes : Match::no;
}

std::vector<Channel> open_tmd(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "TrueMap", 0);
    cursor.skip(comment_offset);
    const auto comment = cursor.bytes(std::min(longest_comment, cursor.remaining()));
    if (comment.find('\0') == std::string::npos)
        throw FormatError(source.name, {.offset = comment_offset + comment.size()},
                          "TrueMap: the comment does not end within 4096 bytes; the file is truncated or damaged");
    const auto dimensions = find_dimensions(cursor, comment);

    ChannelInfo info;
    info.format = "tmd";
    info.name = "heights";
    const auto unit = length_unit(options.unit.value_or("mm"), source);
    info.unit = unit.name;
    if (!options.unit)
        info.alerts.push_back({"UNIT_ASSUMED", source.name,
                               "the file states no unit; lengths and heights are taken as mm, the unit of TrueMap",
                               "give `unit`, such as \"um\", if this is wrong"});
    info.size = {dimensions.length_x * unit.factor, dimensions.length_y * unit.factor};
    info.orientation = "rows from the top, as stored; not stated in the file";
    cursor.seek(comment_offset);
    if (auto text = cursor.text(comment.find('\0')); !text.empty())
        info.metadata.attributes["comment"] = std::move(text);
    const Raster raster{
        .offset = dimensions.data_offset, .nx = dimensions.nx, .ny = dimensions.ny, .sample = Sample::float32};
    return {raster_channel(std::move(info), source, raster, {.factor = unit.factor}, options)};
}

}  // namespace

Format tmd_format() {
    return {.identifier = "tmd",
            .name = "TrueMap",
            .extensions = ".tmd",
            .description = "TrueMap, TrueGage and GelSight, version 2: one map of floating-point heights",
            .heights = "as stored, in mm by the vendor's convention or in the unit given; NaN is undefined",
            .orientation = "rows from the top, as stored; not stated in the file",
            .reference = "Gwyddion's list of formats and SurfaceTopography's reader",
            .tested_on_real_files = true,
            .carries_scale = false,
            .detect = detect_tmd,
            .open = open_tmd};
}

}  // namespace setae::formats
