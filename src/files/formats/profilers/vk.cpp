// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "embedded_archive.hpp"
#include "format_list.hpp"
#include "setae/bytes/archive.hpp"
#include "setae/bytes/calendar_time.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "storage/raster.hpp"

// Keyence VK3 and VK4: a table of offsets, the conditions of the measurement, and up to three images of light and of
// height, each with a header and a palette; lengths in pm. VK6 and VK7 contain a VK4 file as member "Vk4File" of a ZIP
// archive after a picture.
namespace setae::formats {
namespace {

constexpr const char* vk_name = "VK";
constexpr std::uint64_t vk_header_bytes = 12, palette_bytes = 768;

struct Offsets {
    std::uint32_t conditions = 0, lights[3] = {}, heights[3] = {}, texts = 0;
};

Offsets offsets_of(bytes::Cursor& cursor) {
    Offsets offsets;
    offsets.conditions = cursor.number<std::uint32_t>();
    cursor.skip(2 * 4);  // colour images
    for (auto& light : offsets.lights) light = cursor.number<std::uint32_t>();
    for (auto& height : offsets.heights) height = cursor.number<std::uint32_t>();
    cursor.skip(7 * 4);  // thumbnails, assembly, line measurement, line thickness
    offsets.texts = cursor.number<std::uint32_t>();
    return offsets;
}

/// Measurement conditions: numbers of 4 bytes, by index.
struct Conditions {
    double x_pitch = 0.0, y_pitch = 0.0, z_step = 0.0;  ///< [m]
    topography::Metadata metadata;
};

Conditions conditions_of(bytes::Cursor& cursor, const Offsets& offsets) {
    const auto at = [&](std::uint64_t place) {
        return cursor.number_at<std::uint32_t>(offsets.conditions + 4 * place);
    };
    const auto whole = [&](std::uint64_t place) { return static_cast<int>(at(place)); };
    Conditions conditions{.x_pitch = at(42) * units::pm, .y_pitch = at(43) * units::pm, .z_step = at(44) * units::pm};
    auto& metadata = conditions.metadata;
    metadata.acquisition_time = bytes::iso_text({.year = whole(1),
                                                 .month = whole(2),
                                                 .day = whole(3),
                                                 .hour = whole(4),
                                                 .minute = whole(5),
                                                 .second = whole(6),
                                                 .minutes_ahead_of_utc = whole(7)});
    metadata.instrument.type = "confocal";
    metadata.attributes["vendor"] = "Keyence";
    if (const auto zoom = at(18)) metadata.attributes["optical_zoom"] = fmt::format("{}", zoom / 10.0);
    if (const auto magnification = at(24))
        metadata.attributes["lens_magnification"] = fmt::format("{}", magnification / 10.0);
    if (const auto aperture = at(56)) metadata.attributes["numerical_aperture"] = fmt::format("{}", aperture / 1000.0);
    return conditions;
}

/// UTF-16 text after its number of characters.
std::string text_of(bytes::Cursor& cursor) {
    const auto text =
        bytes::decoded(cursor.bytes(std::uint64_t{cursor.number<std::uint32_t>()} * 2), bytes::Encoding::utf16);
    return std::string(trimmed(std::string_view(text).substr(0, text.find('\0'))));
}

Raster image_raster(bytes::Cursor& cursor, std::uint32_t offset) {
    cursor.seek(offset);
    const auto width = cursor.number<std::uint32_t>(), height = cursor.number<std::uint32_t>(),
               bits = cursor.number<std::uint32_t>();
    if (bits != 8 && bits != 16 && bits != 32)
        cursor.fail(fmt::format("{} bits per point, expected 8, 16 or 32", bits));
    cursor.skip(4);  // compression, always none
    const auto bytes = cursor.number<std::uint32_t>();
    const auto bytes_per_point = bits / 8;
    if (std::uint64_t{width} * height != bytes / bytes_per_point || bytes % bytes_per_point != 0)
        cursor.fail(fmt::format("{} × {} points of {} bits in {} bytes", width, height, bits, bytes));
    cursor.skip(2 * 4 + palette_bytes);
    return {.offset = cursor.position(),
            .nx = width,
            .ny = height,
            .sample = bits == 8    ? Sample::uint8
                      : bits == 16 ? Sample::uint16
                                   : Sample::uint32};
}

std::vector<Channel> open_vk4(const bytes::Source& source, const std::string& file, const ReadOptions& options) {
    bytes::Cursor cursor(source, vk_name);
    const auto signature = cursor.bytes(4);
    if (signature != "VK3_" && signature != "VK4_") cursor.fail("the file does not begin with 'VK3_' or 'VK4_'");
    cursor.seek(vk_header_bytes);
    const auto offsets = offsets_of(cursor);
    auto conditions = conditions_of(cursor, offsets);
    conditions.metadata.file = file;
    if (offsets.texts) {
        cursor.seek(offsets.texts);
        for (const auto* key : {"title", "lens"})
            if (auto text = text_of(cursor); !text.empty()) conditions.metadata.attributes[key] = std::move(text);
    }
    std::vector<Channel> channels;
    const auto info_of = [&](const char* kind, int index) {
        return ChannelInfo{.name = index == 0 ? kind : fmt::format("{} {}", kind, index + 1),
                           .format = "vk",
                           .metadata = conditions.metadata};
    };
    for (int i = 0; i < 3; ++i) {
        if (!offsets.heights[i]) continue;
        const auto raster = image_raster(cursor, offsets.heights[i]);
        auto info = info_of("Height", i);
        info.size = {static_cast<double>(raster.nx) * conditions.x_pitch,
                     static_cast<double>(raster.ny) * conditions.y_pitch};
        info.unit = "pm";
        if (raster.ny > 1) info.orientation = "rows from the top, as stored";
        channels.push_back(raster_channel(std::move(info), source, raster, {.factor = conditions.z_step}, options));
    }
    for (int i = 0; i < 3; ++i) {
        if (!offsets.lights[i]) continue;
        const auto raster = image_raster(cursor, offsets.lights[i]);
        require_raster(raster, source, vk_name);
        auto info = info_of("Light", i);
        info.shape = {raster.nx, raster.ny};
        channels.push_back(non_height_channel(std::move(info)));
    }
    if (channels.empty())
        throw FormatError(source.name, {.offset = vk_header_bytes},
                          "VK: no image of heights or light in the table of offsets");
    return channels;
}

bool wraps_a_vk4(std::string_view head) {
    return (head.starts_with("VK6") || head.starts_with("VK7")) && head.substr(7).starts_with("BM");
}

Match detect_vk(std::string_view head, const bytes::Source&) {
    if (head.size() < 9) return head.starts_with("VK3_") || head.starts_with("VK4_") ? Match::maybe : Match::no;
    return head.starts_with("VK3_") || head.starts_with("VK4_") || wraps_a_vk4(head) ? Match::yes : Match::no;
}

std::vector<Channel> open_vk(const bytes::Source& source, const ReadOptions& options) {
    if (!wraps_a_vk4(source.head(9))) return open_vk4(source, source.name, options);
    constexpr std::uint64_t picture = 7;
    const auto picture_bytes = bytes::Cursor(source, vk_name).number_at<std::uint32_t>(3);
    return open_vk4(bytes::Archive(archive_after_picture(source, picture, picture_bytes, vk_name)).member("Vk4File"),
                    source.name, options);
}

}  // namespace

Format vk_format() {
    return {
        .identifier = "vk",
        .name = "Keyence VK",
        .extensions = ".vk3 .vk4 .vk6 .vk7",
        .description =
            "VK3, VK4, VK6 and VK7 files of Keyence's laser scanning microscopes, up to three images of heights of 8, 16 or 32 bits",
        .heights = "raw times the length a digit, in pm; no point is undefined",
        .orientation = "rows stored from the top",
        .not_read = "images of light are listed; colours, assemblies and the map of errors of VK6 are left out",
        .reference =
            "Keyence's VK4 layout as Gwyddion's keyence.c, vk4-python-driver (OSTI 1419732) and SurfaceTopography describe it",
        .detect = detect_vk,
        .open = open_vk};
}

}  // namespace setae::formats
