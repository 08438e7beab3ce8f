// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/core/constants.hpp"
#include "storage/raster.hpp"

// OmniSurf3D files: texts with their lengths before them, points, spacings and origin in µm, then floating-point
// heights in µm.
namespace setae::formats {
namespace {

constexpr std::string_view os3d_signature = "OmniSurf3D";
constexpr double min_height = -3e38;

std::string counted_text(bytes::Cursor& cursor) {
    const auto length = cursor.number<std::int32_t>();
    constexpr std::int32_t longest_text = 1 << 16;
    if (length < 0 || length > longest_text)
        cursor.fail(fmt::format("a text of {} bytes, expected 0 to {}; the file is damaged", length, longest_text));
    return cursor.text(static_cast<std::uint64_t>(length));
}

Match detect_os3d(std::string_view head, const bytes::Source&) {
    return head.starts_with(os3d_signature) ? Match::yes : Match::no;
}

std::vector<Channel> open_os3d(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "OmniSurf3D", os3d_signature.size());
    ChannelInfo info;
    info.format = "os3d";
    info.name = "heights";
    info.unit = "µm";
    info.orientation = "rows from the top, as stored; not stated in the file";
    const auto major = cursor.number<std::int32_t>(), minor = cursor.number<std::int32_t>();
    info.metadata.attributes["format_version"] = fmt::format("{}.{}", major, minor);
    if (auto identification = counted_text(cursor); !identification.empty())
        info.metadata.attributes["identification"] = std::move(identification);
    info.metadata.acquisition_time = counted_text(cursor);
    Raster raster{.nx = cursor.number<std::int32_t>()};
    raster.ny = cursor.number<std::int32_t>();
    const auto dx = cursor.number<double>(), dy = cursor.number<double>();
    info.size = {static_cast<double>(raster.nx) * dx * units::um, static_cast<double>(raster.ny) * dy * units::um};
    const auto origin_x = cursor.number<double>(), origin_y = cursor.number<double>();
    if (origin_x != 0.0 || origin_y != 0.0)
        info.metadata.attributes["origin"] = fmt::format("{} {} µm", origin_x, origin_y);
    raster.offset = cursor.position();
    return {raster_channel(std::move(info), source, raster, {.factor = units::um, .least = min_height}, options)};
}

}  // namespace

Format os3d_format() {
    return {.identifier = "os3d",
            .name = "OmniSurf3D",
            .extensions = ".os3d",
            .description =
                "Digital Metrology's OmniSurf3D: one map of floating-point heights, with identification and time",
            .heights = "as stored, in µm; values below -3e38 are undefined",
            .orientation = "rows from the top, as stored; not stated in the file",
            .not_read = "the picture that may follow the heights",
            .reference = "Digital Metrology, The OmniSurf3D data file format, version 1.01",
            .detect = detect_os3d,
            .open = open_os3d};
}

}  // namespace setae::formats
