// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/unix_time.hpp"
#include "setae/core/errors.hpp"
#include "storage/raster.hpp"

// MetroPro files of Zygo: a big-endian header of 834 or 4096 bytes, the intensities of every bucket, then the phases.
// Height = ± raw · S O W / R with S the interference scale factor, O the obliquity factor, W the wavelength, R by phase
// resolution.
namespace setae::formats {
namespace {

struct Version {
    std::uint32_t signature;
    unsigned header_format;
    std::uint64_t header_bytes;
};
constexpr std::array versions{Version{0x881b036f, 1, 834}, Version{0x881b0370, 2, 834}, Version{0x881b0371, 3, 4096}};
constexpr std::array resolutions{4096.0, 32768.0, 131072.0};
constexpr double greatest_phase = 2147483639.0;
constexpr std::uint64_t common_header_bytes = 834;

/// Offsets in the header.
namespace at {
constexpr std::uint64_t header_format = 4, software_date = 12, intensity_width = 52, buckets = 56, phase_width = 68,
                        time = 76, comment = 80, scale_factor = 164, wavelength = 168, obliquity = 176,
                        lateral_resolution = 184, phase_resolution = 218, sign = 232, system_type = 238, serial = 242,
                        objective = 246, part = 258, full_serial = 798;
}

struct MetroproGrid {
    Index nx = 0, ny = 0;
    [[nodiscard]] std::uint64_t points() const {
        return static_cast<std::uint64_t>(nx) * static_cast<std::uint64_t>(ny);
    }
};

MetroproGrid grid_at(bytes::Cursor& cursor, std::uint64_t offset) {
    return {cursor.number_at<std::uint16_t>(offset), cursor.number_at<std::uint16_t>(offset + 2)};
}

const Version* version_of(std::string_view head) {
    if (head.size() < sizeof(std::uint32_t)) return nullptr;
    const auto signature = bytes::load<std::uint32_t>(head.data(), std::endian::big);
    for (const auto& version : versions)
        if (version.signature == signature) return &version;
    return nullptr;
}

void check_header(const Version& version, bytes::Cursor& cursor) {
    cursor.seek(at::header_format);
    const auto format = cursor.number<std::uint16_t>();
    const auto bytes = cursor.number<std::uint32_t>();
    if (format != version.header_format || bytes != version.header_bytes)
        cursor.fail(fmt::format("header of format {} and {} bytes, expected {} and {} after this signature", format,
                                bytes, version.header_format, version.header_bytes));
    cursor.seek(0);
    cursor.skip(version.header_bytes);
}

/// Names of Zygo's systems by their number.
std::string system_name(int type) {
    static constexpr std::array names{
        "software generated data", "Mark IVxp", "Maxim 3D", "Maxim NT", "GPI-XP", "NewView", "Maxim GP", "NewView/GP",
        "Mark to GPI conversion"};
    return type >= 0 && type < static_cast<int>(names.size()) ? names[static_cast<std::size_t>(type)] : "";
}

std::string text_at(bytes::Cursor& cursor, std::uint64_t offset, std::uint64_t bytes) {
    cursor.seek(offset);
    return cursor.text(bytes);
}

topography::Metadata metadata_of(bytes::Cursor& cursor) {
    topography::Metadata metadata;
    metadata.instrument.type = "interferometer";
    metadata.instrument.name = "Zygo";
    if (const auto system = system_name(cursor.number_at<std::int16_t>(at::system_type)); !system.empty())
        metadata.instrument.name += " " + system;
    metadata.acquisition_time = bytes::utc_text(cursor.number_at<std::int32_t>(at::time));
    // the older field contains the lower 16 bits; the newer one is little-endian
    cursor.set_order(std::endian::little);
    const auto full_serial = cursor.number_at<std::int32_t>(at::full_serial);
    cursor.set_order(std::endian::big);
    const auto serial = full_serial != 0 ? full_serial : cursor.number_at<std::uint16_t>(at::serial);
    if (serial != 0) metadata.attributes["serial_number"] = fmt::format("{}", serial);
    const std::array<std::tuple<const char*, std::uint64_t, std::uint64_t>, 4> texts{
        {{"software_date", at::software_date, 30},
         {"comment", at::comment, 82},
         {"objective", at::objective, 12},
         {"part", at::part, 40}}};
    for (const auto& [key, offset, bytes] : texts)
        if (auto text = text_at(cursor, offset, bytes); !text.empty()) metadata.attributes[key] = std::move(text);
    metadata.attributes["wavelength"] = fmt::format("{} m", cursor.number_at<float>(at::wavelength));
    return metadata;
}

double phase_scale(bytes::Cursor& cursor) {
    cursor.seek(at::phase_resolution);
    const auto resolution = cursor.number<std::int16_t>();
    if (resolution < 0 || resolution >= static_cast<int>(resolutions.size()))
        cursor.fail(fmt::format("phase resolution {}, expected 0, 1 or 2", resolution));
    const double scale = static_cast<double>(cursor.number_at<float>(at::scale_factor)) *
                         static_cast<double>(cursor.number_at<float>(at::obliquity)) *
                         static_cast<double>(cursor.number_at<float>(at::wavelength)) /
                         resolutions[static_cast<std::size_t>(resolution)];
    if (!std::isfinite(scale) || scale == 0.0)
        cursor.fail(fmt::format("heights of {} m per step, expected a length; the header is damaged", scale));
    return cursor.number_at<std::int16_t>(at::sign) != 0 ? -scale : scale;
}

Match detect_metropro(std::string_view head, const bytes::Source&) { return version_of(head) ? Match::yes : Match::no; }

std::vector<Channel> open_metropro(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "MetroPro", 0, std::endian::big);
    const auto* version = version_of(source.head(sizeof(std::uint32_t)));
    if (!version || source.size < common_header_bytes)
        throw FormatError(source.name, {.offset = source.size},
                          fmt::format("MetroPro: the file ends here, its header has {} bytes; it is truncated",
                                      version ? version->header_bytes : common_header_bytes));
    check_header(*version, cursor);
    const auto phase = grid_at(cursor, at::phase_width), intensity = grid_at(cursor, at::intensity_width);
    const auto buckets = intensity.points() > 0 ? cursor.number_at<std::uint16_t>(at::buckets) : std::uint64_t{0};
    const double pixel_size = cursor.number_at<float>(at::lateral_resolution);

    ChannelInfo common;
    common.format = "metropro";
    common.metadata = metadata_of(cursor);
    common.orientation = "rows from the top, as stored";
    const auto channel_info = [&](const char* name, const MetroproGrid& grid) {
        auto info = common;
        info.name = info.metadata.name = name;
        info.shape = {grid.nx, grid.ny};
        if (pixel_size > 0.0)
            info.size = {static_cast<double>(grid.nx) * pixel_size, static_cast<double>(grid.ny) * pixel_size};
        return info;
    };
    const auto intensity_bytes = buckets * intensity.points() * sizeof(std::uint16_t);
    std::vector<Channel> channels;
    if (phase.points() > 0) {
        auto info = channel_info("Phase", phase);
        info.unit = "m";
        const Raster raster{.offset = version->header_bytes + intensity_bytes,
                            .nx = phase.nx,
                            .ny = phase.ny,
                            .sample = Sample::int32,
                            .order = std::endian::big};
        channels.push_back(raster_channel(std::move(info), source, raster,
                                          {.factor = phase_scale(cursor), .greatest = greatest_phase}, options));
    }
    if (buckets > 0) {
        cursor.seek(version->header_bytes);
        cursor.skip(intensity_bytes);
        auto info = channel_info("Intensity", intensity);
        info.metadata.attributes["buckets"] = fmt::format("{}", buckets);
        channels.push_back(non_height_channel(std::move(info)));
    }
    if (channels.empty())
        throw FormatError(source.name, {.offset = at::phase_width},
                          "MetroPro: the file has neither phases nor intensities");
    return channels;
}

}  // namespace

Format metropro_format() {
    return {.identifier = "metropro",
            .name = "MetroPro",
            .extensions = ".dat",
            .description = "Zygo MetroPro, versions 1 to 3: phases, which are heights, and intensities",
            .heights =
                "raw times scale factor times obliquity factor times wavelength over 4096, 32768 or 131072 by "
                "phase resolution, negated if the header states so; 2147483640 and above are undefined",
            .orientation = "rows from the top, as stored",
            .not_read = "intensities are listed without being read",
            .reference = "MetroPro reference guide, as used by Gwyddion's module metropro",
            .tested_on_real_files = true,
            .detect = detect_metropro,
            .open = open_metropro};
}

}  // namespace setae::formats
