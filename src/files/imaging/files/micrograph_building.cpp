// SPDX-License-Identifier: GPL-3.0-or-later
#include "micrograph_building.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include <fmt/format.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/named_choice.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"

namespace setae::imaging {
namespace {

constexpr double square_within = 1e-3;

/// Words for units in microscope software.
std::string_view symbol_of(std::string_view unit) {
    struct Word {
        std::string_view word, symbol;
    };
    static constexpr std::array words{
        Word{"micrometer", "um"},         Word{"micrometre", "um"}, Word{"nanometer", "nm"},
        Word{"nanometre", "nm"},          Word{"picometer", "pm"},  Word{"Angstrom", "angstrom"},
        Word{"\xE2\x84\xAB", "angstrom"}, Word{"meter", "m"},       Word{"\\u00B5m", "um"}};
    for (const auto& [word, symbol] : words)
        if (unit == word) return symbol;
    return unit;
}

bool no_unit(std::string_view unit) { return unit.empty() || unit == "pixels" || unit == "pixel" || unit == "px"; }

bool reciprocal(std::string_view unit) {
    return unit.find("1/") != std::string_view::npos || unit.find("-1") != std::string_view::npos ||
           unit.find("\xE2\x81\xBB\xC2\xB9") != std::string_view::npos;
}

}  // namespace

std::optional<double> metres_of(std::string_view unit) {
    if (unit == "inch") return 0.0254;
    try {
        return unit_factor(symbol_of(unit), dimension::length);
    } catch (const InvalidArgument&) {
        return std::nullopt;
    }
}

Micrograph unread_micrograph(const bytes::Source& file, std::string format) {
    Micrograph micrograph;
    micrograph.format = std::move(format);
    micrograph.file = file.name;
    micrograph.name = std::filesystem::path(file.name).filename().string();
    return micrograph;
}

void add_alert(Micrograph& micrograph, std::string code, std::string message, std::string action) {
    micrograph.alerts.push_back({std::move(code), micrograph.name, std::move(message), std::move(action)});
}

void set_pixel_size(Micrograph& micrograph, const AxisScale& x, const AxisScale& y, const std::string& source) {
    const auto unit_x = std::string(trimmed(x.unit)), unit_y = std::string(trimmed(y.unit));
    if (no_unit(unit_x) && no_unit(unit_y)) return;
    micrograph.unit = unit_x == unit_y ? unit_x : unit_x + ", " + unit_y;
    const std::string remedy = "give the pixel size, or calibrate on the scale bar";
    const auto metres_x = metres_of(unit_x), metres_y = metres_of(unit_y);
    if (!metres_x || !metres_y) {
        if (reciprocal(unit_x) || reciprocal(unit_y))
            return add_alert(micrograph, "RECIPROCAL_UNITS",
                             fmt::format("{} has axes in '{}': a diffraction pattern or a Fourier transform", source,
                                         micrograph.unit),
                             "read the image itself instead of the diffraction pattern or transform");
        return add_alert(micrograph, "UNKNOWN_UNIT",
                         fmt::format("{} has the unit '{}', which is not a length", source, micrograph.unit), remedy);
    }
    const PixelSize size{std::abs(x.scale) * *metres_x,
                         std::abs(y.scale) * *metres_y};  // a negative scale reverses an axis
    if (!(size.x > 0 && size.y > 0 && std::isfinite(size.x) && std::isfinite(size.y)))
        return add_alert(micrograph, "BAD_CALIBRATION",
                         fmt::format("{} states pixels of {:g} {} × {:g} {}", source, x.scale, unit_x, y.scale, unit_y),
                         remedy);
    micrograph.pixel_size = size;
    micrograph.pixel_size_source = source;
    if (std::abs(size.x / size.y - 1.0) > square_within)
        add_alert(micrograph, "PIXELS_NOT_SQUARE",
                  fmt::format("pixels are {} wide and {} high", format_value(size.x, "m"), format_value(size.y, "m")),
                  "check both sizes, which are both used, if the camera has square pixels");
}

bool is_energy(std::string_view unit) {
    unit = trimmed(unit);
    return unit == "eV" || unit == "keV" || unit == "meV" || unit == "MeV";
}

PictureSize picture_size(const bytes::Source& file, std::uint64_t offset, std::uint64_t width, std::uint64_t height,
                         const MicrographOptions& options) {
    if (width == 0 || height == 0)
        throw FormatError(file.name, {.offset = offset},
                          fmt::format("a picture of {} × {} pixels; the file is damaged", width, height));
    if (width == 1 || height == 1)
        throw FormatError(
            file.name, {.offset = offset},
            fmt::format("{} × {} numbers: a spectrum or a line, not a picture; choose the file with the image", width,
                        height));
    const auto most = static_cast<std::uint64_t>(std::max(0L, options.max_pixels));
    if (width > most / height)
        throw FormatError(
            file.name, {.offset = offset},
            fmt::format("{} × {} pixels, more than the {} that can be read; crop the picture to the edge, or bin it, "
                        "with ImageJ or the program of the microscope",
                        width, height, most));
    return {static_cast<long>(width), static_cast<long>(height)};
}

namespace {

/// "0 'HAADF', 1 'HAADF' (Fourier transform)"; only the first ones of many.
std::string listed_images(const std::vector<ImageEntry>& images) {
    constexpr std::size_t max_listed = 12;
    std::string text;
    for (std::size_t i = 0; i < std::min(images.size(), max_listed); ++i) {
        const auto& [title, kind] = images[i];
        text += fmt::format("{}{}{}{}", i == 0 ? "" : ", ", i, title.empty() ? "" : fmt::format(" '{}'", title),
                            images[i].is_picture() ? "" : fmt::format(" ({})", kind));
    }
    return images.size() > max_listed ? fmt::format("{}, … {}", text, images.size() - 1) : text;
}

}  // namespace

std::size_t choose_image(Micrograph& micrograph, std::vector<ImageEntry> images, const MicrographOptions& options) {
    std::vector<std::string> titles;
    for (const auto& image : images) titles.push_back(image.title);
    std::size_t chosen = 0;
    if (options.image.empty()) {
        while (chosen < images.size() && !images[chosen].is_picture()) ++chosen;
        if (chosen == images.size()) chosen = 0;
    } else {
        try {
            chosen = chosen_by_name(options.image, titles, "image");
        } catch (const InvalidArgument& error) {
            throw InvalidArgument(fmt::format("{}: {}", micrograph.file, error.what()));
        }
    }
    if (images.size() > 1)
        add_alert(micrograph, "SEVERAL_IMAGES",
                  fmt::format("the file contains {} images: {}; number {} is read", images.size(),
                              listed_images(images), chosen),
                  "choose another with `image`, by its number, counted from 0, or by its title");
    micrograph.images = std::move(images);
    micrograph.image = chosen;
    return chosen;
}

std::size_t choose_image(Micrograph& micrograph, std::uint64_t count, const MicrographOptions& options) {
    constexpr std::uint64_t max_listed = 1 << 20;  // a damaged header may state any number
    return choose_image(micrograph, std::vector<ImageEntry>(std::min(count, max_listed)), options);
}

std::optional<double> number_of(std::string_view text) {
    const auto value = spelled<double>(trimmed(text));
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace setae::imaging
