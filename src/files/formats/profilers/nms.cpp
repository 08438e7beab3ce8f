// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "storage/raster.hpp"

// NMS files of NanoFocus: a header of fixed offsets and 3468 bytes, heights as integers of 2 bytes between two limits
// in µm, then a picture of 1 byte per point. No signature: the header contains its own length, and the rest must be
// consistent.
namespace setae::formats {
namespace {

constexpr std::uint64_t nms_header_bytes = 3468;
constexpr std::string_view program = "OM_MS_";
constexpr double steps_of_range = 65534.0;
constexpr std::uint32_t max_points_of_nms = 100000;

namespace at {
constexpr std::uint64_t limits = 16, program = 32, title = 52, date = 1076, header_length = 1352, points = 1368,
                        pitch = 1376;
}

template <class T>
T value_at(std::string_view head, std::uint64_t offset) {
    return bytes::load<T>(head.data() + offset, std::endian::little);
}

/// Whether the fields are consistent with heights.
bool is_consistent(std::string_view head) {
    if (value_at<std::uint32_t>(head, at::header_length) != nms_header_bytes) return false;
    const auto lowest = value_at<double>(head, at::limits), highest = value_at<double>(head, at::limits + 8);
    const auto nx = value_at<std::uint32_t>(head, at::points), ny = value_at<std::uint32_t>(head, at::points + 4);
    const auto dx = value_at<double>(head, at::pitch), dy = value_at<double>(head, at::pitch + 8);
    constexpr double farthest = 1e6, min_pitch = 1e-3, greatest_pitch = 1e9;  // µm, nm
    return std::abs(lowest) < farthest && std::abs(highest) < farthest && lowest < highest && nx > 0 && ny > 0 &&
           nx <= max_points_of_nms && ny <= max_points_of_nms && dx > min_pitch && dy > min_pitch &&
           dx < greatest_pitch && dy < greatest_pitch;
}

Match detect_nms(std::string_view head, const bytes::Source&) {
    if (head.size() < at::pitch + 16) return Match::no;
    if (!is_consistent(head)) return Match::no;
    return head.substr(at::program).starts_with(program) ? Match::yes : Match::maybe;
}

std::vector<Channel> open_nms(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "NMS", nms_header_bytes);
    const auto lowest = cursor.number_at<double>(at::limits), highest = cursor.number_at<double>(at::limits + 8);
    const auto nx = cursor.number_at<std::uint32_t>(at::points), ny = cursor.number_at<std::uint32_t>(at::points + 4);
    const auto dx = cursor.number_at<double>(at::pitch), dy = cursor.number_at<double>(at::pitch + 8);
    const auto text = [&](std::uint64_t offset, std::uint64_t bytes) {
        cursor.seek(offset);
        return cursor.text(bytes);
    };
    ChannelInfo info;
    info.format = "nms";
    info.name = text(at::title, 64);
    if (info.name.empty()) info.name = "heights";
    info.unit = "µm";
    info.size = {nx * dx * units::nm, ny * dy * units::nm};
    info.orientation = "rows from the top, as stored; not stated in the file";
    info.metadata.name = info.name;
    info.metadata.instrument.type = "confocal";
    info.metadata.acquisition_time = text(at::date, 16);
    if (auto version = text(at::program, 16); !version.empty())
        info.metadata.attributes["software_version"] = std::move(version);
    const Raster raster{.offset = nms_header_bytes, .nx = nx, .ny = ny, .sample = Sample::uint16};
    auto picture = info;
    const RawScale scale{.factor = (highest - lowest) * units::um / steps_of_range, .offset = lowest * units::um};
    std::vector<Channel> channels{raster_channel(std::move(info), source, raster, scale, options)};
    const auto points = std::uint64_t{nx} * ny;
    const auto rest = source.size - nms_header_bytes - 2 * points;
    if (rest > 0 && rest < points)
        throw FormatError(
            source.name, {.offset = source.size},
            fmt::format("NMS: the file ends here, expected the end of its picture at byte {}; it is truncated",
                        nms_header_bytes + 3 * points));
    if (rest >= points) {
        picture.name = picture.metadata.name = "Intensity";
        picture.shape = {nx, ny};
        picture.unit.clear();
        channels.push_back(non_height_channel(std::move(picture)));
    }
    return channels;
}

}  // namespace

Format nms_format() {
    return {
        .identifier = "nms",
        .name = "NMS",
        .extensions = ".nms",
        .description = "NanoFocus µsurf confocal microscopes: one map between two limits of height, and a picture",
        .heights =
            "lower limit plus raw times the range of limits over 65534, in µm; no point is undefined (over 65535, the highest raw value, heights would be 15 millionths closer)",
        .orientation = "rows from the top, as stored; not stated in the file",
        .not_read = "the picture after the heights is listed without being read",
        .reference = "SurfaceTopography and surfalize, and a file: its pitch of 312.5 is nm, for a map of 160 µm",
        .tested_on_real_files = true,
        .detect = detect_nms,
        .open = open_nms};
}

}  // namespace setae::formats
