// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiff_calibration.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "micrograph_building.hpp"
#include "setae/bytes/nesting.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"

namespace setae::imaging {
namespace {

namespace tag {
constexpr std::uint16_t description = 270, make = 271, model = 272, x_resolution = 282, y_resolution = 283,
                        resolution_unit = 296, date_time = 306, olympus = 33560, zeiss = 34118, fei_sfeg = 34680,
                        fei_helios = 34682, dm_unit_x = 65003, dm_unit_y = 65004, dm_scale_x = 65009,
                        dm_scale_y = 65010;
}

using Section = std::map<std::string, std::string>;

/// "[section]" lines and "key=value" lines between them.
std::map<std::string, Section> sections_of(std::string_view text) {
    std::map<std::string, Section> sections;
    std::string name;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const auto line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.size() > 2 && line.front() == '[' && line.back() == ']') name = line.substr(1, line.size() - 2);
        else if (const auto equals = line.find('='); equals != std::string_view::npos && equals > 0)
            sections[name].emplace(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
    }
    return sections;
}

std::string value_in(const std::map<std::string, Section>& sections, const std::string& section,
                     const std::string& key) {
    const auto found = sections.find(section);
    if (found == sections.end()) return {};
    const auto value = found->second.find(key);
    return value == found->second.end() ? std::string() : value->second;
}

/// Numbers in FEI's sections with these keys; a warning for invalid text.
std::optional<double> fei_number(const std::map<std::string, Section>& sections, const std::string& section,
                                 const std::string& key, Micrograph& micrograph) {
    const auto text = value_in(sections, section, key);
    if (text.empty()) return std::nullopt;
    const auto number = number_of(text);
    if (!number)
        add_alert(micrograph, "BAD_NUMBER",
                  fmt::format("[{}] {} is '{}', which is not a number; this field is left out", section, key, text),
                  "if you need this field, read its value in the program of the microscope");
    return number;
}

/// Source: no public specification; keys as in files of Helios instruments and RosettaSciIO, lengths in metres.
bool read_fei(const TiffStack& stack, const bytes::TiffPage& page, Micrograph& micrograph) {
    auto text = stack.text(page, tag::fei_helios);
    if (text.empty()) text = stack.text(page, tag::fei_sfeg);
    if (text.empty()) return false;
    const auto sections = sections_of(text);
    micrograph.instrument = value_in(sections, "System", "SystemType");
    micrograph.acquisition_time = value_in(sections, "User", "Date") + " " + value_in(sections, "User", "Time");
    if (const auto voltage = fei_number(sections, "Beam", "HV", micrograph))
        micrograph.attributes["voltage"] = fmt::format("{:g} V", *voltage);
    if (const auto distance = fei_number(sections, "Stage", "WorkingDistance", micrograph))
        micrograph.attributes["working distance"] = fmt::format("{:g} m", *distance);
    std::vector<std::string> names{"Scan"};
    for (const auto& [name, values] : sections)
        if (name != "Scan") names.push_back(name);
    for (const auto& name : names) {
        const auto x = fei_number(sections, name, "PixelWidth", micrograph),
                   y = fei_number(sections, name, "PixelHeight", micrograph);
        if (!x || !y) continue;
        set_pixel_size(micrograph, {*x, "m"}, {*y, "m"}, fmt::format("FEI metadata [{}]", name));
        return true;
    }
    const auto columns = fei_number(sections, "Image", "ResolutionX", micrograph),
               rows = fei_number(sections, "Image", "ResolutionY", micrograph);
    for (const auto& name : names) {
        const auto width = fei_number(sections, name, "HFW", micrograph),
                   height = fei_number(sections, name, "VFW", micrograph);
        if (!width || !height || !columns || !rows || !(*columns > 0) || !(*rows > 0)) continue;
        set_pixel_size(micrograph, {*width / *columns, "m"}, {*height / *rows, "m"},
                       fmt::format("FEI metadata [{}], width of the field", name));
        return true;
    }
    return true;
}

/// Source: no public specification; the known part of the block as in tifffile.
bool read_olympus(const TiffStack& stack, const bytes::TiffPage& page, Micrograph& micrograph) {
    const auto start = stack.number(page, tag::olympus);
    if (!start) return false;
    const auto& file = stack.file();
    const auto head = file.up_to(*start, 60);
    if (head.size() < 60 || !head.starts_with("SIS0")) {
        add_alert(micrograph, "BAD_CALIBRATION", fmt::format("the Olympus block at byte {} is damaged", *start),
                  "give the pixel size, or calibrate on the scale bar");
        return true;
    }
    const auto parts = bytes::number_in(head, 58, 2);
    const auto list = file.up_to(*start + 60, 8 * parts);
    for (std::size_t at = 0; at + 8 <= list.size(); at += 8) {
        if (bytes::number_in(list, at, 2) != 1) continue;  // 1: general data
        const auto data = file.up_to(bytes::number_in(list, at + 4, 4), 112);
        if (data.size() < 112) continue;
        const auto real = [&](std::size_t offset) { return std::bit_cast<double>(bytes::number_in(data, offset, 8)); };
        const double unit = std::pow(10.0, static_cast<std::int16_t>(bytes::number_in(data, 10, 2)));
        set_pixel_size(micrograph, {real(12) * unit, "m"}, {real(20) * unit, "m"}, "Olympus SIS block");
        if (std::isfinite(real(36)) && real(36) > 0)
            micrograph.attributes["magnification"] = fmt::format("{:g}", real(36));
        return true;
    }
    return true;
}

bool read_dm(const TiffStack& stack, const bytes::TiffPage& page, Micrograph& micrograph) {
    const auto x = stack.real(page, tag::dm_scale_x), y = stack.real(page, tag::dm_scale_y);
    if (!x || !y) return false;
    set_pixel_size(micrograph, {*x, stack.text(page, tag::dm_unit_x)}, {*y, stack.text(page, tag::dm_unit_y)},
                   "DigitalMicrograph tags");
    return micrograph.pixel_size.has_value() || !micrograph.unit.empty();
}

/// The number and unit that follow a key: "AP_IMAGE_PIXEL_SIZE\r\nImage Pixel Size = 1.1 nm".
bool read_zeiss(const TiffStack& stack, const bytes::TiffPage& page, Micrograph& micrograph) {
    const auto text = stack.text(page, tag::zeiss);
    for (const std::string_view key : {"AP_IMAGE_PIXEL_SIZE", "AP_PIXEL_SIZE"}) {
        const auto at = text.find(key);
        if (at == std::string::npos) continue;
        const auto equals = text.find('=', at);
        if (equals == std::string::npos) continue;
        const auto value =
            trimmed(std::string_view(text).substr(equals + 1, text.find_first_of("\r\n", equals) - equals - 1));
        const auto blank = value.find(' ');
        if (blank == std::string_view::npos) continue;
        const auto number = number_of(value.substr(0, blank));
        if (!number) continue;
        const AxisScale axis{*number, std::string(trimmed(value.substr(blank)))};
        set_pixel_size(micrograph, axis, axis, "Zeiss metadata");
        add_alert(micrograph, "UNTESTED_FORMAT",
                  "tags of Zeiss are read according to their description and were not tested on an instrument "
                  "file",
                  "compare the pixel size with the scale bar");
        return true;
    }
    return false;
}

/// Source: OME-XML schema 2016-06, Pixels.
bool read_ome(const TiffStack& stack, Micrograph& micrograph) {
    const auto text = stack.text(stack.page(0), tag::description);
    if (text.find("<OME") == std::string::npos) return false;
    pugi::xml_document document;
    if (bytes::xml_too_deep(text) || !document.load_buffer(text.data(), text.size())) return false;
    const auto pixels = document.child("OME").child("Image").child("Pixels");
    const auto x = number_of(pixels.attribute("PhysicalSizeX").value()),
               y = number_of(pixels.attribute("PhysicalSizeY").value());
    if (!x || !y) return false;
    set_pixel_size(micrograph, {*x, pixels.attribute("PhysicalSizeXUnit").as_string("\xC2\xB5m")},
                   {*y, pixels.attribute("PhysicalSizeYUnit").as_string("\xC2\xB5m")}, "OME-XML");
    return true;
}

/// Metres per pixel by the resolution tags, if they are not those of film, screen or paper.
std::optional<PixelSize> printed_size(const TiffStack& stack, const bytes::TiffPage& page) {
    const auto x = stack.real(page, tag::x_resolution), y = stack.real(page, tag::y_resolution);
    const auto unit = stack.number(page, tag::resolution_unit).value_or(2);
    if (!x || !(*x > 0) || (y && !(*y > 0)) || (unit != 2 && unit != 3)) return std::nullopt;
    const double metres = unit == 2 ? 0.0254 : 0.01;
    return PixelSize{metres / *x, metres / y.value_or(*x)};
}

/// SightX: the description is XML, the resolution is that of the picture on the screen at the stated magnification.
/// SEM: the description contains the length of the bar in pixels and in metres.
bool read_jeol(const TiffStack& stack, const bytes::TiffPage& page, Micrograph& micrograph) {
    const auto text = stack.text(page, tag::description);
    const auto untested = [&] {
        add_alert(micrograph, "UNTESTED_FORMAT",
                  "tags of JEOL are read according to their description and were not tested on an instrument file",
                  "compare the pixel size with the scale bar");
        return true;
    };
    if (const auto root = text.find("<TemReporter"); root != std::string::npos) {
        pugi::xml_document document;
        const auto reported = std::string_view(text).substr(root);
        if (bytes::xml_too_deep(reported) || !document.load_buffer(reported.data(), reported.size())) return false;
        const auto reporter = document.child("TemReporter");
        const auto imaging = reporter.child("ImageFormingSystem");
        const auto magnification = number_of(imaging.child_value("SelectorValue"));
        const auto screen = printed_size(stack, page);
        if (std::string_view(imaging.child_value("ModeString")) != "MAG" || !magnification || !(*magnification > 0) ||
            !screen)
            return false;
        set_pixel_size(micrograph, {screen->x / *magnification, "m"}, {screen->y / *magnification, "m"},
                       "JEOL metadata");
        micrograph.attributes["magnification"] = fmt::format("{:g}", *magnification);
        return untested();
    }
    const auto word_after = [&](std::string_view key) -> std::string_view {
        const auto at = text.find(key);
        if (at == std::string::npos) return {};
        return trimmed(
            std::string_view(text).substr(at + key.size(), text.find_first_of("\r\n", at) - at - key.size()));
    };
    const auto bar = number_of(word_after("SM_MICRON_BAR"));
    const auto marker = word_after("SM_MICRON_MARKER");
    const auto digits = marker.find_first_not_of("0123456789.");
    if (!bar || !(*bar > 0) || digits == std::string_view::npos) return false;
    const auto length = number_of(marker.substr(0, digits));
    if (!length) return false;
    const AxisScale axis{*length / *bar, std::string(trimmed(marker.substr(digits)))};
    set_pixel_size(micrograph, axis, axis, "JEOL metadata");
    return untested();
}

bool read_imagej(const TiffStack& stack, const bytes::TiffPage& page, Micrograph& micrograph) {
    const auto unit = stack.description("unit");
    const auto x = stack.real(page, tag::x_resolution), y = stack.real(page, tag::y_resolution);
    if (!unit || !x || !(*x > 0) || (y && !(*y > 0))) return false;
    set_pixel_size(micrograph, {1.0 / *x, *unit}, {1.0 / y.value_or(*x), *unit}, "ImageJ calibration");
    return true;
}

}  // namespace

bool has_olympus_block(const bytes::TiffPage& page) { return page.find(tag::olympus) != nullptr; }

void read_tiff_calibration(const TiffStack& stack, std::size_t index, Micrograph& micrograph) {
    const auto& page = stack.page(index);
    const auto make = stack.text(page, tag::make), model = stack.text(page, tag::model);
    micrograph.instrument = trimmed(make.empty() || model.empty() ? make + model : make + " " + model);
    micrograph.acquisition_time = stack.text(page, tag::date_time);
    const bool stated = read_fei(stack, page, micrograph) || read_olympus(stack, page, micrograph) ||
                        read_dm(stack, page, micrograph) || read_zeiss(stack, page, micrograph) ||
                        read_ome(stack, micrograph) || read_jeol(stack, page, micrograph) ||
                        read_imagej(stack, page, micrograph);
    if (stated) return;
    const auto size = printed_size(stack, page);
    if (size && size->x < coarsest_pixel && size->y < coarsest_pixel)
        set_pixel_size(micrograph, {size->x, "m"}, {size->y, "m"}, "TIFF resolution");
}

}  // namespace setae::imaging
