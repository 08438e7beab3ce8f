// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/core/constants.hpp"
#include "storage/raster.hpp"

// ZMG files of KLA Zeta: a header of 205 bytes and a comment, then integers of 2 bytes. Steps along x, y and z are µm.
namespace setae::formats {
namespace {

constexpr std::string_view zmg_signature = "Zeta-Instruments";
constexpr std::uint64_t zmg_header_bytes = 205;

namespace at {
constexpr std::uint64_t points = 85, steps = 97, comment_length = 117, recipe = 131;
}

Match detect_zmg(std::string_view head, const bytes::Source&) {
    return head.starts_with(zmg_signature) ? Match::yes : Match::no;
}

std::vector<Channel> open_zmg(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "ZMG", 0);
    cursor.seek(at::points);
    const auto nx = cursor.number<std::uint32_t>(), ny = cursor.number<std::uint32_t>();
    cursor.seek(at::steps);
    const double dx = cursor.number<float>(), dy = cursor.number<float>(), dz = cursor.number<float>();
    cursor.seek(at::comment_length);
    const auto comment_bytes = cursor.number<std::uint32_t>();
    ChannelInfo info;
    info.format = "zmg";
    info.name = "heights";
    info.unit = "µm";
    info.size = {nx * dx * units::um, ny * dy * units::um};
    info.orientation = "rows from the top, as stored; not stated in the file";
    info.metadata.instrument = {.name = "KLA Zeta", .type = "optical"};
    cursor.seek(at::recipe);
    constexpr std::uint64_t recipe_bytes = 68, longest_comment = 4096;
    if (auto recipe = cursor.text(recipe_bytes); !recipe.empty())
        info.metadata.attributes["recipe"] = std::move(recipe);
    cursor.seek(zmg_header_bytes);
    if (auto comment = cursor.text(std::min<std::uint64_t>(comment_bytes, longest_comment)); !comment.empty())
        info.metadata.attributes["comment"] = std::move(comment);
    const Raster raster{.offset = zmg_header_bytes + comment_bytes, .nx = nx, .ny = ny, .sample = Sample::uint16};
    return {raster_channel(std::move(info), source, raster, {.factor = dz * units::um}, options)};
}

}  // namespace

Format zmg_format() {
    return {.identifier = "zmg",
            .name = "ZMG",
            .extensions = ".zmg",
            .description = "KLA Zeta optical profilers: one map of integer heights",
            .heights = "unsigned integer of 2 bytes times the step along z, in µm; no point is undefined",
            .orientation = "rows from the top, as stored; not stated in the file",
            .not_read = "all data after the heights",
            .reference = "Gwyddion's module zmgfile, as described by SurfaceTopography 1.27, and surfalize",
            .detect = detect_zmg,
            .open = open_zmg};
}

}  // namespace setae::formats
