// SPDX-License-Identifier: GPL-3.0-or-later
#include <tiffio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header.hpp"
#include "storage/tiff_pixels.hpp"

// TIFF whose pixels are heights: floats, or integers of 16 or 32 bits. ImageJ writes the unit of its pixels into the
// description ("unit=um") and pixels per unit into the resolution; calibrated values as c0 + c1 · raw with their unit
// vunit. For other TIFF the user gives the unit of heights, and the size if there is no resolution.
namespace setae::formats {
namespace {

constexpr const char* height_tiff = "tiff";
constexpr std::size_t max_tiff_pages = 300;
constexpr double coarsest_printed_pixel = 20e-6;  ///< larger pixels are those for printers [m]

/// The description of the first page, as written by ImageJ.
struct ImageJText {
    std::string text;

    [[nodiscard]] bool known() const { return text.starts_with("ImageJ="); }
    [[nodiscard]] std::string entry(std::string_view key) const {
        for (const auto line : bytes::split_lines(text)) {
            const auto equals = line.find('=');
            if (equals != std::string_view::npos && trimmed(line.substr(0, equals)) == key)
                return std::string(trimmed(line.substr(equals + 1)));
        }
        return {};
    }
    [[nodiscard]] std::optional<double> number(std::string_view key) const {
        const auto value = spelled<double>(entry(key));
        return value && std::isfinite(*value) ? value : std::nullopt;
    }
};

/// A unit as ImageJ spells it.
std::string imagej_unit(const std::string& unit) {
    if (unit == "\\u00B5m" || unit == "micron" || unit == "microns" || unit == "\xC2\xB5m") return "um";
    return unit;
}

std::optional<double> metres_of(const std::string& unit) {
    if (unit == "inch") return 0.0254;
    const auto parsed = tables::try_parse_unit(unit);
    return parsed && parsed->dimension == dimension::length ? std::optional(parsed->factor) : std::nullopt;
}

/// Metres of a pixel along x and y; empty if the file states none.
std::optional<std::array<double, 2>> pixel_of(const bytes::TiffFile& file, const bytes::TiffPage& page,
                                              const ImageJText& imagej) {
    const auto x = file.number(page, TIFFTAG_XRESOLUTION), y = file.number(page, TIFFTAG_YRESOLUTION);
    if (!x || !(*x > 0.0) || !std::isfinite(*x) || (y && (!(*y > 0.0) || !std::isfinite(*y)))) return std::nullopt;
    const auto of_unit = [&](double metres) { return std::array{metres / *x, metres / y.value_or(*x)}; };
    if (imagej.known()) {
        const auto metres = metres_of(imagej_unit(imagej.entry("unit")));
        return metres ? std::optional(of_unit(*metres)) : std::nullopt;
    }
    const auto unit = file.number(page, TIFFTAG_RESOLUTIONUNIT).value_or(RESUNIT_INCH);
    if (unit != RESUNIT_INCH && unit != RESUNIT_CENTIMETER) return std::nullopt;
    const auto pixel = of_unit(unit == RESUNIT_INCH ? 0.0254 : 0.01);
    return pixel[0] < coarsest_printed_pixel && pixel[1] < coarsest_printed_pixel ? std::optional(pixel) : std::nullopt;
}

/// Conversion of raw values to heights: the linear calibration of ImageJ with its unit, otherwise none.
struct TiffScale {
    double factor = 1.0, offset = 0.0;
    std::string unit;
};

TiffScale scale_of(const ImageJText& imagej) {
    TiffScale scale;
    if (!imagej.known()) return scale;
    const bool linear = imagej.entry("cf") == "0" && imagej.number("c0") && imagej.number("c1");
    if (linear) scale = {*imagej.number("c1"), *imagej.number("c0"), {}};
    const auto unit = imagej_unit(imagej.entry("vunit"));
    if (const auto metres = metres_of(unit)) {
        scale.unit = unit;
        scale.factor *= *metres;
        scale.offset *= *metres;
    }
    return scale;
}

/// Pixels of one byte, and coloured ones, are pictures.
bool can_be_heights(const bytes::TiffFile& file, const bytes::TiffPage& page) {
    return file.number(page, TIFFTAG_SAMPLESPERPIXEL).value_or(1.0) == 1.0 &&
           file.number(page, TIFFTAG_BITSPERSAMPLE).value_or(1.0) > 8.0 &&
           file.number(page, TIFFTAG_PHOTOMETRIC).value_or(PHOTOMETRIC_MINISBLACK) != PHOTOMETRIC_PALETTE;
}

Channel page_channel(const bytes::TiffFile& file, std::size_t number, const ImageJText& imagej,
                     const ReadOptions& options) {
    const auto& page = file.pages[number];
    ChannelInfo info{.name = file.pages.size() > 1 ? fmt::format("page {}", number) : "heights", .format = height_tiff};
    info.orientation = "rows from the top, as stored";
    info.metadata.file = file.source.name;
    info.metadata.acquisition_time = file.text(page, TIFFTAG_DATETIME);
    if (const auto program = file.text(page, TIFFTAG_SOFTWARE); !program.empty())
        info.metadata.attributes["software"] = program;
    const auto pixels = tiff_pixels(file, page);
    if (const auto pixel = pixel_of(file, page, imagej))
        info.size = {(*pixel)[0] * static_cast<double>(pixels.raster.nx),
                     (*pixel)[1] * static_cast<double>(pixels.raster.ny)};
    const auto scale = scale_of(imagej);
    info.unit = scale.unit;
    return raster_channel(std::move(info), pixels.source, pixels.raster,
                          {.factor = scale.factor, .offset = scale.offset}, options);
}

std::vector<Channel> open_height_tiff(const bytes::Source& source, const ReadOptions& options) {
    const auto file = bytes::open_tiff(source, "TIFF", max_tiff_pages);
    const ImageJText imagej{file.text(file.pages.front(), TIFFTAG_IMAGEDESCRIPTION)};
    std::vector<Channel> channels;
    for (std::size_t k = 0; k < file.pages.size(); ++k)
        if (can_be_heights(file, file.pages[k])) channels.push_back(page_channel(file, k, imagej, options));
    if (channels.empty()) refuse_tiff(source);
    return channels;
}

Match detect_height_tiff(std::string_view head, const bytes::Source&) {
    return bytes::is_tiff(head) ? Match::maybe : Match::no;
}

}  // namespace

Format height_tiff_format() {
    return {
        .identifier = height_tiff,
        .name = "TIFF of heights",
        .extensions = ".tif .tiff",
        .description =
            "TIFF with one number a pixel, floats or integers of 16 or 32 bits: each page is a channel, sized by ImageJ's unit and resolution; where ImageJ's calibration of values states no "
            "unit of length the unit is given, and `setae info` takes the file for a micrograph",
        .heights =
            "c0 + c1 times raw in vunit as ImageJ writes them, else the value in the unit given; NaN and infinities are undefined",
        .orientation = "rows from the top, as stored",
        .not_read = "pixels of 8 bits and colours: grey values have lost the scale of heights",
        .reference = "TIFF 6.0; ImageJ, TiffEncoder and FileInfo",
        .tested_on_real_files = false,
        .carries_scale = false,
        .read_elsewhere = false,
        .detect = detect_height_tiff,
        .open = open_height_tiff};
}

}  // namespace setae::formats
