// SPDX-License-Identifier: GPL-3.0-or-later
#include "ser_file.hpp"

#include <bit>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "micrograph_building.hpp"
#include "raw_pixels.hpp"
#include "setae/bytes/nesting.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging {
namespace {

constexpr std::uint64_t series_id = 0x0197, version_of_32_bit = 0x0210, version_of_64_bit = 0x0220, data_1d = 0x4120,
                        data_2d = 0x4122;
constexpr std::uint64_t head_bytes = 34;  // with a 64-bit offset

std::optional<SampleType> sample_type(std::uint64_t type) {
    switch (type) {
        case 1: return SampleType::uint8;
        case 2: return SampleType::uint16;
        case 3: return SampleType::uint32;
        case 4: return SampleType::int8;
        case 5: return SampleType::int16;
        case 6: return SampleType::int32;
        case 7: return SampleType::float32;
        case 8: return SampleType::float64;
        case 9: return SampleType::complex_float32;
        case 10: return SampleType::complex_float64;
        default: return std::nullopt;
    }
}

}  // namespace

bool is_ser(std::string_view head) {
    if (head.size() < head_bytes || !head.starts_with("II")) return false;
    const auto version = bytes::number_in(head, 4, 2);
    return bytes::number_in(head, 2, 2) == series_id && (version == version_of_32_bit || version == version_of_64_bit);
}

Micrograph read_ser(const bytes::Source& file, const MicrographOptions& options) {
    auto micrograph = unread_micrograph(file, "ser");
    const auto head = file.up_to(0, head_bytes);
    const std::size_t word = bytes::number_in(head, 4, 2) == version_of_32_bit ? 4 : 8;
    const auto kind = bytes::number_in(head, 6, 4), valid = bytes::number_in(head, 18, 4),
               offsets = bytes::number_in(head, 22, word);
    if (kind == data_1d)
        throw FormatError(file.name, {.offset = 6},
                          "a series of spectra, not a picture; choose the file with the image");
    if (kind != data_2d)
        throw FormatError(file.name, {.offset = 6},
                          fmt::format("data of type {:#x}, expected {:#x}; the file is damaged", kind, data_2d));
    if (valid == 0) throw FormatError(file.name, {.offset = 18}, "the series has no image");
    const std::uint64_t image = choose_image(micrograph, valid, options);
    const auto place = file.up_to(offsets, word * (image + 1));
    if (place.size() < word * (image + 1))
        throw FormatError(file.name, {.offset = offsets},
                          "the list of images lies beyond the end of the file, which is truncated");
    const auto start = bytes::number_in(place, word * image, word);
    constexpr std::uint64_t element_bytes = 2 * 20 + 2 + 8;
    const auto element = file.up_to(start, element_bytes);
    if (element.size() < element_bytes)
        throw FormatError(file.name, {.offset = start}, "an image lies beyond the end of the file, which is truncated");
    const auto type = sample_type(bytes::number_in(element, 40, 2));
    if (!type)
        throw FormatError(
            file.name, {.offset = start + 40},
            fmt::format("pixels of type {}, expected 1 to 10; the file is damaged", bytes::number_in(element, 40, 2)));
    const auto size =
        picture_size(file, start + 42, bytes::number_in(element, 42, 4), bytes::number_in(element, 46, 4), options);
    micrograph.pixels = read_pixels(file, {start + element_bytes, *type, false, size});
    micrograph.pixels.colwise().reverseInPlace();
    if (is_complex(*type))
        add_alert(micrograph, "COMPLEX_MAGNITUDE", "pixels are complex numbers; their magnitude is read",
                  "if this is a Fourier transform, read the real image");
    const auto real = [&](std::size_t offset) { return std::bit_cast<double>(bytes::number_in(element, offset, 8)); };
    set_pixel_size(micrograph, {real(8), "m"}, {real(28), "m"}, "SER calibration");
    add_alert(micrograph, "UNTESTED_FORMAT",
              "SER is read according to its description and was not tested on an instrument file",
              "compare picture and pixel size with those of another program");
    return micrograph;
}

void read_emi(std::string_view emi, Micrograph& micrograph) {
    constexpr std::string_view begin = "<ObjectInfo>", end = "</ObjectInfo>";
    const auto first = emi.find(begin), last = emi.find(end, first == std::string_view::npos ? 0 : first);
    if (first == std::string_view::npos || last == std::string_view::npos) return;
    pugi::xml_document document;
    const auto described = std::string_view(emi).substr(first, last + end.size() - first);
    if (bytes::xml_too_deep(described) || !document.load_buffer(described.data(), described.size())) return;
    const auto info = document.child("ObjectInfo");
    micrograph.acquisition_time = info.child_value("AcquireDate");
    for (const auto data : info.child("ExperimentalDescription").child("Root").children("Data")) {
        const std::string label = data.child_value("Label"), unit = data.child_value("Unit"),
                          value = data.child_value("Value");
        if (label == "Microscope") micrograph.instrument = value;
        else if (label == "High tension") micrograph.attributes["voltage"] = value + " " + unit;
        else if (label == "Magnification") micrograph.attributes["magnification"] = value;
        else if (label == "Mode") micrograph.attributes["operation mode"] = value;
    }
}

std::string emi_path(const std::string& ser) {
    std::filesystem::path path(ser);
    auto stem = path.stem().string();
    const auto underscore = stem.find_last_of('_');
    if (underscore != std::string::npos && underscore + 1 < stem.size() &&
        stem.find_first_not_of("0123456789", underscore + 1) == std::string::npos)
        stem.resize(underscore);
    return path.replace_filename(stem + ".emi").string();
}

}  // namespace setae::imaging
