// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "probe_channels.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "storage/tiff_pixels.hpp"

// A TIFF picture whose private tags contain the measurement: 50432 magic number, 50433 version, 50434 the samples,
// 50435 a header of 356 bytes, 580 from version 2 on; all little-endian. height = gain · (scale · raw + offset) in the
// unit of the header.
namespace setae::formats {
namespace {

enum ParkTag : std::uint16_t {
    magic_tag = 50432,
    version_tag = 50433,
    samples_tag = 50434,
    header_tag = 50435,
    comment_tag = 50436,
    date_tag = 306,
    software_tag = 305,
    strip_offsets_tag = 273,
    strip_bytes_tag = 279
};
constexpr std::uint64_t max_strips = 1 << 20;
constexpr double park_magic = 0x0E031301, version_1 = 0x1000001, version_2 = 0x1000002;
constexpr std::uint64_t park_header_bytes = 356, header_bytes_2 = 580;

struct ParkHeader {
    std::uint32_t image_type = 0;
    std::string source, mode;
    std::uint32_t nx = 0, ny = 0;
    double angle = 0.0;
    bool forward = true, upwards = true, swapped = false, logarithmic = false;
    double width = 0.0, height = 0.0;  ///< [µm]
    double gain = 1.0, scale = 1.0, offset = 0.0;
    std::string unit;
    bool compressed = false;
    std::uint32_t data_type = 0;  ///< 0 int16, 1 int32, 2 float32
    std::string cantilever;
};

/// Characters of 2 bytes, up to the first NUL.
std::string wide_text(bytes::Cursor& cursor, std::uint64_t characters) {
    auto content = cursor.bytes(2 * characters);
    std::size_t end = 0;
    while (end < content.size() && (content[end] != '\0' || content[end + 1] != '\0')) end += 2;
    content.resize(end);
    return content.empty() ? content
                           : std::string(trimmed(bytes::decoded("\xff\xfe" + content, bytes::Encoding::utf16)));
}

ParkHeader header_of(const bytes::TiffFile& file, const bytes::TiffTag& tag) {
    if (tag.bytes() < park_header_bytes)
        throw FormatError(file.source.name, {.offset = tag.offset},
                          fmt::format("Park: a header of {} bytes, expected {} or {}", tag.bytes(), park_header_bytes,
                                      header_bytes_2));
    bytes::Cursor cursor(file.source, "Park", tag.offset);
    ParkHeader header;
    const auto flag = [&] { return cursor.number<std::uint32_t>() != 0; };
    header.image_type = cursor.number<std::uint32_t>();
    header.source = wide_text(cursor, 32);
    header.mode = wide_text(cursor, 8);
    cursor.skip(8 + 4 + 4);  // low-pass filter, flattened and tracked by the instrument
    header.nx = cursor.number<std::uint32_t>();
    header.ny = cursor.number<std::uint32_t>();
    header.angle = cursor.number<double>();
    cursor.skip(4 + 8);  // sine scan, overscan
    header.forward = flag();
    header.upwards = flag();
    header.swapped = flag();
    header.width = cursor.number<double>();
    header.height = cursor.number<double>();
    cursor.skip(4 * 8 + 16 + 2 * 8);  // place of the scan, its rate, set point with unit, biases
    header.gain = cursor.number<double>();
    header.scale = cursor.number<double>();
    header.offset = cursor.number<double>();
    header.unit = wide_text(cursor, 8);
    cursor.skip(3 * 4);  // least, largest and mean raw value
    header.compressed = flag();
    header.logarithmic = flag();
    cursor.skip(4);  // square pixels
    if (tag.bytes() < header_bytes_2) return header;
    cursor.skip(2 * 8 + 3 * 16);  // servo gain, range of the scanner, modes of scanner and servo
    header.data_type = cursor.number<std::uint32_t>();
    cursor.skip(2 * 4 + 3 * 8);  // reserved, amplitude and frequency of the cantilever, and a field that is 0 in real
                                 // files
    header.cantilever = wide_text(cursor, 16);
    return header;
}

void require_readable(const ParkHeader& header, const bytes::TiffFile& file, std::uint64_t offset) {
    const auto refuse = [&](const std::string& what) {
        throw FormatError(file.source.name, {.offset = offset}, "Park: " + what);
    };
    if (header.image_type == 1) refuse("a line profile cut from a map, which contains no heights; open the map");
    if (header.image_type > 2)
        refuse(fmt::format("an image of type {}, expected 0 (map) or 2 (map with spectra)", header.image_type));
    if (header.compressed)
        refuse("compressed samples, whose layout is not published; save the file without compression");
    if (header.data_type > 2)
        refuse(fmt::format("samples of type {}, expected 0 (int16), 1 (int32) or 2 (float32)", header.data_type));
    if (!std::isfinite(header.gain) || !std::isfinite(header.scale) || !std::isfinite(header.offset))
        refuse("gain, scale or offset are not numbers");
}

topography::Metadata metadata_of(const ParkHeader& header, const bytes::TiffFile& file, double version) {
    topography::Metadata metadata;
    metadata.name = header.source;
    metadata.file = file.source.name;
    metadata.format = "park";
    metadata.instrument.type = "afm";
    metadata.instrument.name = "Park Systems";
    metadata.acquisition_time = file.text(file.pages.front(), date_tag);
    const auto keep = [&](const char* key, const std::string& value) {
        if (!value.empty()) metadata.attributes[key] = value;
    };
    keep("software", file.text(file.pages.front(), software_tag));
    keep("mode", header.mode);
    keep("cantilever", header.cantilever);
    keep("comment", file.text(file.pages.front(), comment_tag));
    metadata.attributes["header_version"] = version == version_2 ? "2" : "1";
    metadata.attributes["scan_angle"] = fmt::format("{} deg", header.angle);
    metadata.attributes["line_direction"] = header.forward ? "forward" : "backward";
    metadata.attributes["scan_direction"] = header.upwards ? "up" : "down";
    metadata.attributes["fast_axis"] = header.swapped ? "y" : "x";
    if (header.logarithmic) metadata.attributes["shown"] = "logarithmically";
    return metadata;
}

Raster raster_of(const ParkHeader& header, const bytes::TiffTag& samples, const bytes::TiffFile& file) {
    static constexpr Sample types[] = {Sample::int16, Sample::int32, Sample::float32};
    const Raster raster{.offset = samples.offset,
                        .nx = header.nx,
                        .ny = header.ny,
                        .sample = types[header.data_type],
                        .bottom_up = true};
    const auto value_bytes = bytes_of(raster.sample);
    if (header.nx == 0 || header.ny == 0 || header.nx > samples.bytes() / value_bytes / header.ny ||
        samples.bytes() != value_bytes * header.nx * header.ny)
        throw FormatError(file.source.name, {.offset = samples.offset},
                          fmt::format("Park: {} bytes of samples for {} × {} points of {} bytes", samples.bytes(),
                                      header.nx, header.ny, value_bytes));
    return raster;
}

/// The picture is not read, but a file with an incomplete picture is truncated.
void require_preview(const bytes::TiffFile& file, const bytes::TiffPage& page) {
    const auto offsets = file.integers(page, strip_offsets_tag, max_strips),
               counts = file.integers(page, strip_bytes_tag, max_strips);
    for (std::size_t k = 0; k < std::min(offsets.size(), counts.size()); ++k)
        if (offsets[k] > file.source.size || counts[k] > file.source.size - offsets[k])
            throw FormatError(
                file.source.name, {.offset = file.source.size},
                fmt::format("Park: the file ends here, expected the end of a strip of its picture at byte {}; it is "
                            "truncated",
                            offsets[k] + counts[k]));
}

std::vector<Channel> open_park(const bytes::Source& source, const ReadOptions& options) {
    const auto file = bytes::open_tiff(source, "Park", 1);
    const auto& page = file.pages.front();
    const auto *header_at = page.find(header_tag), *samples = page.find(samples_tag);
    if (!header_at || !samples)
        throw FormatError(source.name, {.offset = page.offset},
                          "Park: the tags of header (50435) and samples (50434) are not both present");
    const double version = file.number(page, version_tag).value_or(0.0);
    if (version != version_1 && version != version_2)
        throw FormatError(source.name, {.offset = page.offset},
                          fmt::format("Park: version {}, expected 1 or 2", version));
    const auto header = header_of(file, *header_at);
    require_readable(header, file, header_at->offset);
    require_preview(file, page);
    ChannelInfo info;
    info.name = header.source;
    info.format = "park";
    info.metadata = metadata_of(header, file, version);
    const auto raster = raster_of(header, *samples, file);
    info.shape = {raster.nx, raster.ny};
    info.size = {header.width * 1e-6, header.height * 1e-6};
    info.unit = header.unit;
    if (info.unit.empty()) {
        info.unit = "um";
        info.alerts.push_back({"UNIT_ASSUMED", source.name,
                               "the header names no unit of the heights; µm was assumed, the unit of its sizes",
                               "compare with the program of the instrument"});
    }
    if (!holds_heights(info.name, info.unit)) return {non_height_channel(std::move(info))};
    info.orientation = "rows from the bottom, turned";
    const double metre = length_unit(info.unit, source).factor, scale = header.scale == 0.0 ? 1.0 : header.scale;
    return {raster_channel(std::move(info), source, raster,
                           {.factor = metre * header.gain * scale, .offset = metre * header.gain * header.offset},
                           options)};
}

Match detect_park(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_tiff(head)) return Match::no;
    try {
        const auto file = bytes::open_tiff(source, "Park", 1);
        return file.number(file.pages.front(), magic_tag) == park_magic ? Match::yes : Match::no;
    } catch (const FormatError&) {
        return Match::no;
    }
}

}  // namespace

Format park_format() {
    return {
        .identifier = "park",
        .name = "Park Systems TIFF",
        .extensions = ".tiff .tif",
        .description =
            "Park Systems (PSIA): a TIFF picture whose private tags 50432 to 50435 hold the measurement, headers of versions 1 and 2",
        .heights =
            "gain times (scale times raw plus offset) of int16, int32 or float32 samples; a scale of 0 counts as 1; no point is undefined",
        .orientation = "rows stored from the bottom, turned, as in the picture of the same file",
        .not_read = "spectra and line profiles in such files; the picture itself",
        .reference = "Gwyddion's module psia and TIFF 6.0",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_park,
        .open = open_park};
}

}  // namespace setae::formats
