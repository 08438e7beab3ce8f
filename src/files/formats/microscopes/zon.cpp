// SPDX-License-Identifier: GPL-3.0-or-later
#include "zon.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "profilers/embedded_archive.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/bytes/expanded_source.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/bytes/xml_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "storage/point_mask.hpp"
#include "storage/raster.hpp"

// Keyence ZON: "KPK0" or "KPK1", a picture, and a ZIP archive whose members have UUIDs as names; in KPK1 each is
// additionally compressed by Zstandard. Arrays have a header of four numbers (columns, rows, bytes of an element, bytes
// of a row). Height = raw · MeterPerUnit.
namespace setae::formats {
namespace {

constexpr const char* zon_name = "ZON";
constexpr const char* heights_member = "4cdb0c75-5706-48cc-a9a1-adf395d609ae";
constexpr const char* validity_member = "9e7ca6dd-0e6a-4d7b-8986-f0a7b773c916";
constexpr const char* colour_member = "c65a358c-2782-481d-9f05-b9b233b3802d";
constexpr const char* calibration_member = "686613b8-27b5-4a29-8ffc-438c2780873e";
constexpr const char* device_member = "cbc1d39b-215f-4d56-a20e-cf8e5f570755";
constexpr const char* scan_member = "1d35862b-3b48-4df2-9235-833ef590b043";
constexpr const char* inventory_of_many = "f1724dc6-686c-4502-9227-2a594bc8ed33";
constexpr std::string_view zstd_signature = "\x28\xb5\x2f\xfd";
constexpr std::uint64_t array_header = 16;
/// Bits of the validity of a point for a missing or excluded measurement; other bits rate an existing height.
constexpr std::uint8_t invalid_bits = 0x03;

/// Contiguous points in a member.
struct PointArray {
    std::int32_t nx = 0, ny = 0, element_bytes = 0, row_bytes = 0;
    bytes::Source content;
};

PointArray array_of(const bytes::Archive& archive, const char* member, std::int32_t element_bytes,
                    const bytes::Source& source) {
    constexpr std::uint64_t enough_for_a_header = 1 << 18;  // a Zstandard block holds at most 128 KiB
    auto content = archive.member(member);
    const auto packed = archive.head(member, enough_for_a_header);
    const bool zstd = packed.starts_with(zstd_signature);
    const auto header =
        zstd ? bytes::expanded_zstd_head(packed, array_header, content, 0, zon_name) : packed.substr(0, array_header);
    if (header.size() < array_header)
        throw FormatError(content.name, {.offset = header.size()},
                          "ZON: the member ends within its header; the file is damaged");
    const auto number = [&](std::size_t i) {
        return bytes::load<std::int32_t>(header.data() + 4 * i, std::endian::little);
    };
    PointArray array{number(0), number(1), number(2), number(3), content};
    if (array.nx < 1 || array.ny < 1 || array.element_bytes != element_bytes ||
        array.row_bytes / element_bytes < array.nx)
        throw FormatError(content.name, {.offset = 0},
                          fmt::format("ZON: {} × {} points of {} bytes in rows of {}, expected {} bytes per point",
                                      array.nx, array.ny, array.element_bytes, array.row_bytes, element_bytes));
    if (!zstd) return array;
    const auto size = array_header + static_cast<std::uint64_t>(array.ny) * static_cast<std::uint64_t>(array.row_bytes);
    if (size > bytes::max_expanded(content.size))
        throw FormatError(content.name, {.offset = 8},
                          fmt::format("ZON: {} × {} points announced in {} compressed bytes; the file is damaged",
                                      array.nx, array.ny, content.size));
    array.content = bytes::expanded_source(
        content.name, size, [content, source] { return bytes::expanded_zstd(content.all(), content, 0, zon_name); });
    return array;
}

pugi::xml_document document_of(const bytes::Archive& archive, const char* member, const bytes::Source& source) {
    return bytes::parsed_xml(keyence_member(archive, member, source), source, zon_name);
}

double calibration(const pugi::xml_document& document, const char* axis, const char* key, const bytes::Source& source) {
    const double value = bytes::xml_number(document.document_element().child(axis).child(key), 0.0, source, zon_name);
    if (!(value > 0.0))
        throw FormatError(source.name, {}, fmt::format("ZON: calibration without a positive {}/{}", axis, key));
    return value;
}

topography::Metadata metadata_of(const bytes::Archive& archive, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.instrument.type = "optical";
    metadata.attributes["vendor"] = "Keyence";
    if (archive.has(device_member)) {
        const auto device = document_of(archive, device_member, source);
        metadata.instrument.name = trimmed(device.document_element().child_value("DeviceModelName"));
        if (const auto serial = trimmed(device.document_element().child_value("DeviceSerialId")); !serial.empty())
            metadata.attributes["serial"] = serial;
    }
    if (archive.has(scan_member)) {
        const auto scan = document_of(archive, scan_member, source);
        metadata.acquisition_time = trimmed(scan.document_element().child_value("ScanDateTime"));
    }
    return metadata;
}

Match detect_zon(std::string_view head, const bytes::Source& source) {
    if (!is_keyence_package(head)) return Match::no;
    try {
        const bytes::Archive archive(keyence_archive(source));
        return archive.has(heights_member) ? Match::yes : archive.has(inventory_of_many) ? Match::no : Match::maybe;
    } catch (const FormatError&) {
        return Match::maybe;  // reports the problem of the file
    }
}

}  // namespace

bool is_keyence_package(std::string_view head) { return head.starts_with("KPK0") || head.starts_with("KPK1"); }

bytes::Source keyence_archive(const bytes::Source& source) {
    constexpr std::uint64_t picture = 8;
    bytes::Cursor cursor(source, zon_name);
    if (!is_keyence_package(cursor.bytes(4))) cursor.fail("the member does not begin with 'KPK0' or 'KPK1'");
    return archive_after_picture(source, picture, cursor.number<std::uint32_t>(), zon_name);
}

std::string keyence_member(const bytes::Archive& archive, const std::string& member, const bytes::Source& source) {
    auto content = archive.read(member);
    return content.starts_with(zstd_signature) ? bytes::expanded_zstd(content, source, 0, zon_name) : content;
}

std::vector<Channel> open_zon(const bytes::Source& source, const ReadOptions& options) {
    const bytes::Archive archive(keyence_archive(source));
    const auto units = document_of(archive, calibration_member, source);
    const double pixel = calibration(units, "XYCalibration", "MeterPerPixel", source),
                 step = calibration(units, "ZCalibration", "MeterPerUnit", source);
    const auto metadata = metadata_of(archive, source);
    const auto heights = array_of(archive, heights_member, 4, source);
    ChannelInfo info{.name = "Height",
                     .format = "zon",
                     .size = {heights.nx * pixel, heights.ny * pixel},
                     .unit = "m",
                     .metadata = metadata};
    if (heights.ny > 1) info.orientation = "rows from the top, as stored";
    const Raster raster{.offset = array_header,
                        .nx = heights.nx,
                        .ny = heights.ny,
                        .sample = Sample::int32,
                        .line_distance = static_cast<std::uint64_t>(heights.row_bytes)};
    std::vector<Channel> channels{raster_channel(std::move(info), heights.content, raster, {.factor = step}, options)};
    if (archive.has(validity_member) && heights.ny > 1) {
        const auto validity = array_of(archive, validity_member, 1, source);
        if (validity.nx != heights.nx || validity.ny != heights.ny)
            throw FormatError(source.name, {},
                              fmt::format("ZON: {} × {} points of validity for {} × {} heights", validity.nx,
                                          validity.ny, heights.nx, heights.ny));
        channels[0] = masked(std::move(channels[0]), {.source = validity.content,
                                                      .offset = array_header,
                                                      .row_distance = static_cast<std::uint64_t>(validity.row_bytes),
                                                      .bits = invalid_bits});
    }
    if (archive.has(colour_member)) {
        channels.push_back(non_height_channel({.name = "Colour", .format = "zon", .metadata = metadata}));
    }
    return channels;
}

Format zon_format() {
    return {
        .identifier = "zon",
        .name = "Keyence ZON",
        .extensions = ".zon",
        .description = "measurements of Keyence's VR series: a picture and an archive, packed or not",
        .heights =
            "raw times MeterPerUnit; points whose validity has one of its two low bits set were not measured and are undefined",
        .orientation = "rows stored from the top",
        .not_read =
            "the colour image is listed; palettes, settings and analyses are left out; the high bits of validity judge heights and leave them",
        .reference =
            "the members as found by M. McMalburg (Keyence issue 2) and SurfaceTopography 1.27, Gwyddion's zonfile.c as surfalize describes it",
        .detect = detect_zon,
        .open = open_zon};
}

}  // namespace setae::formats
