// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/xml_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "storage/tiff_pixels.hpp"

// TIFF whose pages are named by their descriptions (HEIGHT, INTENSITY, …). The description of the first page is XML
// with lengths per pixel and per grey value; the device settings in its Exif directory are XML with the calibration by
// the manufacturer, a factor for each axis.
namespace setae::formats {
namespace {

enum LextTag : std::uint16_t {
    description_tag = 270,
    maker_tag = 271,
    model_tag = 272,
    date_tag = 306,
    exif_tag = 34665,
    device_settings_tag = 0xa40b
};
constexpr std::string_view root_name = "TiffTagDescData", exif_root_name = "ExifTagDescData";
constexpr std::size_t max_pages = 300;  ///< further pages are ignored
constexpr double picometre = 1e-12;     ///< lengths of the XML: micrometres in millionths

/// Metres per pixel and per grey value.
struct LextScale {
    double x = 0.0, y = 0.0, z = 0.0;
};

/// The number in the element with that name, which must exist and be positive.
double length_in(const pugi::xml_node& node, const std::string& name, const bytes::TiffFile& file,
                 std::uint64_t offset) {
    const auto child = node.child(name.c_str());
    const double value = bytes::xml_number(child, 0.0, file.source, "LEXT");
    if (!(value > 0.0))
        throw FormatError(file.source.name, {.offset = offset},
                          fmt::format("LEXT: <{}> of the description is '{:.40}', expected a positive number", name,
                                      child.child_value()));
    return value;
}

/// Calibration factors of the manufacturer; 1 if the file has no device settings.
LextScale calibration_of(const bytes::TiffFile& file) {
    const auto& first = file.pages.front();
    if (!first.find(exif_tag)) return {1.0, 1.0, 1.0};
    const auto exif = file.directory_of(first, exif_tag);
    if (!exif.find(device_settings_tag)) return {1.0, 1.0, 1.0};
    const auto document = bytes::parsed_xml(file.text(exif, device_settings_tag), file.source, "LEXT");
    const auto settings = document.child(exif_root_name.data()).child("ImageCommonSettingsInfo");
    const auto factor = [&](const char* axis) {
        return bytes::xml_number(settings.child(fmt::format("MakerCalibrationValue{}", axis).c_str()), 1.0, file.source,
                                 "LEXT");
    };
    return {factor("X"), factor("Y"), factor("Z")};
}

LextScale scale_of(const bytes::TiffFile& file, const pugi::xml_node& heights, std::uint64_t offset) {
    for (const char* axis : {"X", "Y", "Z"})
        if (heights.child(fmt::format("HeightDataUnit{}", axis).c_str()).text().as_string("2") != std::string_view("2"))
            throw FormatError(file.source.name, {.offset = offset},
                              fmt::format("LEXT: <HeightDataUnit{}> is '{:.20}', expected 2 (µm)", axis,
                                          heights.child(fmt::format("HeightDataUnit{}", axis).c_str()).child_value()));
    const auto calibration = calibration_of(file);
    return {picometre * calibration.x * length_in(heights, "HeightDataPerPixelX", file, offset),
            picometre * calibration.y * length_in(heights, "HeightDataPerPixelY", file, offset),
            picometre * calibration.z * length_in(heights, "HeightDataPerPixelZ", file, offset)};
}

topography::Metadata metadata_of(const bytes::TiffFile& file) {
    const auto& first = file.pages.front();
    topography::Metadata metadata;
    metadata.file = file.source.name;
    metadata.format = "lext";
    metadata.instrument.type = "confocal";
    metadata.instrument.name = std::string(trimmed(file.text(first, maker_tag) + " " + file.text(first, model_tag)));
    if (metadata.instrument.name.empty()) metadata.instrument.name = "Olympus LEXT";
    metadata.acquisition_time = file.text(first, date_tag);
    return metadata;
}

std::vector<Channel> open_lext(const bytes::Source& source, const ReadOptions& options) {
    const auto file = bytes::open_tiff(source, "LEXT", max_pages);
    const auto& first = file.pages.front();
    const auto document = bytes::parsed_xml(file.text(first, description_tag), source, "LEXT");
    ChannelInfo common;
    common.format = "lext";
    common.metadata = metadata_of(file);
    std::vector<Channel> channels;
    bool any_heights = false;
    for (std::size_t k = 1; k < file.pages.size(); ++k) {
        auto info = common;
        info.name = info.metadata.name = bytes::lowered(file.text(file.pages[k], description_tag));
        if (info.name.empty() || info.name == "thumbnail" || info.name == "invalid") continue;
        if (info.name != "height") {
            channels.push_back(non_height_channel(std::move(info)));
            continue;
        }
        any_heights = true;
        const auto pixels = tiff_pixels(file, file.pages[k]);
        const auto scale =
            scale_of(file, document.child(root_name.data()).child("HeightInfo"), first.find(description_tag)->offset);
        info.size = {scale.x * static_cast<double>(pixels.raster.nx), scale.y * static_cast<double>(pixels.raster.ny)};
        info.unit = "um";
        info.orientation = "rows from the top, as stored";
        channels.push_back(raster_channel(std::move(info), pixels.source, pixels.raster, {.factor = scale.z}, options));
    }
    if (!any_heights)
        throw FormatError(source.name, {.offset = first.offset},
                          "LEXT: the file has no page named HEIGHT; save it with its height data");
    return channels;
}

Match detect_lext(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_tiff(head)) return Match::no;
    try {
        const auto file = bytes::open_tiff(source, "LEXT", 1);
        return file.text(file.pages.front(), description_tag).find(root_name) != std::string::npos ? Match::yes
                                                                                                   : Match::no;
    } catch (const FormatError&) {
        return Match::no;
    }
}

}  // namespace

Format lext_format() {
    return {
        .identifier = "lext",
        .name = "Olympus LEXT",
        .extensions = ".lext",
        .description =
            "Olympus LEXT confocal microscopes (OLS4000 and later): TIFF with XML in its description and its Exif directory",
        .heights =
            "grey value times HeightDataPerPixelZ (pm) times the maker's calibration along z, if the file has one; no point is undefined",
        .orientation = "rows stored from the top, as stored",
        .not_read =
            "intensity and colour are listed; the page INVALID, whose meaning is not published, marks no point as undefined",
        .reference = "Gwyddion's module lextfile and TIFF 6.0",
        .tested_on_real_files = false,
        .carries_scale = true,
        .detect = detect_lext,
        .open = open_lext};
}

}  // namespace setae::formats
