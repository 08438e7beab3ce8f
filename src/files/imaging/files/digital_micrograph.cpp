// SPDX-License-Identifier: GPL-3.0-or-later
#include "digital_micrograph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "dm_tags.hpp"
#include "micrograph_building.hpp"
#include "raw_pixels.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging {
namespace {

std::optional<std::size_t> index_of(const std::optional<double>& number) {
    if (!number || !(*number >= 0) || *number > 1e6 || std::floor(*number) != *number) return std::nullopt;
    return static_cast<std::size_t>(*number);
}

/// Indices in ImageList without thumbnails: displayed documents first, in the order of ImageSourceList.
std::vector<std::size_t> images_of(const DmTag& root, std::size_t count) {
    std::set<std::size_t> thumbnails;
    if (const auto* list = root.find("Thumbnails"))
        for (const auto& thumbnail : list->tags)
            if (const auto index = index_of(thumbnail.number_at("ImageIndex"))) thumbnails.insert(*index);
    std::vector<std::size_t> images;
    const auto add = [&](std::optional<std::size_t> index) {
        if (index && *index < count && !thumbnails.contains(*index) &&
            std::find(images.begin(), images.end(), *index) == images.end())
            images.push_back(*index);
    };
    if (const auto* list = root.find("ImageSourceList"))
        for (const auto& source : list->tags) add(index_of(source.number_at("ImageRef")));
    if (images.empty())
        for (std::size_t i = 0; i < count; ++i) add(i);
    if (images.empty()) images.push_back(count - 1);  // only thumbnails: the last
    return images;
}

/// Samples by ImageData's DataType. Source: Gatan's scripting manual, ImageGetDataType.
std::optional<SampleType> sample_type(int data_type) {
    switch (data_type) {
        case 1: return SampleType::int16;
        case 2: return SampleType::float32;
        case 3: return SampleType::complex_float32;
        case 6:
        case 14: return SampleType::uint8;
        case 7: return SampleType::int32;
        case 8:
        case 23: return SampleType::bgra;
        case 9: return SampleType::int8;
        case 10: return SampleType::uint16;
        case 11: return SampleType::uint32;
        case 12: return SampleType::float64;
        case 13: return SampleType::complex_float64;
        case 39: return SampleType::int64;
        case 40: return SampleType::uint64;
        default: return std::nullopt;
    }
}

struct Tagged {
    const char *path, *name, *unit;
};

/// Tags of an image on its acquisition.
constexpr std::array instrument_tags{Tagged{"Microscope Info/Indicated Magnification", "magnification", ""},
                                     Tagged{"Microscope Info/Voltage", "voltage", " V"},
                                     Tagged{"Microscope Info/Illumination Mode", "illumination mode", ""},
                                     Tagged{"Microscope Info/Imaging Mode", "imaging mode", ""},
                                     Tagged{"Microscope Info/Operation Mode", "operation mode", ""},
                                     Tagged{"Microscope Info/Cs(mm)", "spherical aberration", " mm"},
                                     Tagged{"Acquisition/Parameters/High Level/Exposure (s)", "exposure", " s"},
                                     Tagged{"Acquisition/Device/Name", "camera", ""}};

void describe(Micrograph& micrograph, const DmTag& image) {
    const auto* tags = image.find("ImageTags");
    if (!tags) return;
    for (const auto& [path, name, unit] : instrument_tags) {
        if (const auto text = tags->text_at(path); !text.empty()) micrograph.attributes[name] = text;
        else if (const auto number = tags->number_at(path); number && *number != 0)
            micrograph.attributes[name] = fmt::format("{:g}{}", *number, unit);
    }
    for (const auto* path : {"Session Info/Microscope", "Microscope Info/Name", "Microscope Info/Microscope"})
        if (micrograph.instrument.empty()) micrograph.instrument = tags->text_at(path);
    const auto date = tags->text_at("DataBar/Acquisition Date"), time = tags->text_at("DataBar/Acquisition Time");
    micrograph.acquisition_time = date.empty() || time.empty() ? date + time : date + " " + time;
}

AxisScale axis_of(const DmTag& data, std::size_t axis) {
    const auto path = fmt::format("Calibrations/Dimension/{}/", axis);
    return {data.number_at(path + "Scale").value_or(0), data.text_at(path + "Units")};
}

/// Title and kind of an image, by its dimensions, their units and its type of numbers.
ImageEntry entry_of(const DmTag& image) {
    constexpr std::array complex_types{3, 5, 13, 27, 28};
    ImageEntry entry{.title = image.text_at("Name")};
    const auto* data = image.find("ImageData");
    const auto* dimensions = data ? data->find("Dimensions") : nullptr;
    if (!dimensions) return entry;
    std::size_t extended = 0;
    bool energy = false;
    for (std::size_t axis = 0; axis < dimensions->tags.size(); ++axis) {
        extended += dimensions->tags[axis].number.value_or(0) > 1 ? 1 : 0;
        energy = energy || is_energy(axis_of(*data, axis).unit);
    }
    const auto type = index_of(data->number_at("DataType"));
    const bool is_complex =
        type && std::find(complex_types.begin(), complex_types.end(), static_cast<int>(*type)) != complex_types.end();
    if (energy || extended < 2) entry.kind = extended > 1 ? "spectrum image" : "spectrum";
    else if (is_complex) entry.kind = "Fourier transform";
    return entry;
}

}  // namespace

Micrograph read_digital_micrograph(const bytes::Source& file, const MicrographOptions& options) {
    const auto tags = read_dm_tags(file);
    auto micrograph = unread_micrograph(file, tags.version == 4 ? "dm4" : "dm3");
    const auto* list = tags.root.find("ImageList");
    if (!list || list->tags.empty())
        throw FormatError(file.name, {.offset = tags.root.offset},
                          "a DigitalMicrograph file without an image; it contains only tags");
    const auto images = images_of(tags.root, list->tags.size());
    std::vector<ImageEntry> entries;
    for (const auto index : images) entries.push_back(entry_of(list->tags[index]));
    const auto& image = list->tags[images[choose_image(micrograph, std::move(entries), options)]];
    const auto damaged = [&](const std::string& what) {
        return FormatError(file.name, {.offset = image.offset}, what);
    };
    const auto* data = image.find("ImageData");
    const auto* numbers = data ? data->find("Data") : nullptr;
    const auto* dimensions = data ? data->find("Dimensions") : nullptr;
    const auto data_type = data ? index_of(data->number_at("DataType")) : std::nullopt;
    if (!numbers || numbers->bytes == 0 || !dimensions || !data_type)
        throw damaged("an image without data, dimensions or a type of data; the file is damaged");

    std::vector<std::uint64_t> lengths;
    for (const auto& dimension : dimensions->tags) {
        const auto length = dimension.number;
        if (!length || !(*length >= 1) || *length > 1e15)
            throw damaged("an image has a dimension of length 0; the file is damaged");
        lengths.push_back(static_cast<std::uint64_t>(*length));
    }
    for (std::size_t axis = 0; axis < lengths.size(); ++axis)
        if (const auto unit = axis_of(*data, axis).unit; is_energy(unit))
            throw damaged(fmt::format(
                "axis {} is an energy in {}: a spectrum, not a picture; choose the file with the image", axis, unit));
    if (lengths.size() < 2)
        throw damaged(fmt::format(
            "{} numbers along one axis: a spectrum or a line, not a picture; choose the file with the image",
            lengths.empty() ? 0 : lengths[0]));
    const auto size = picture_size(file, image.offset, lengths[0], lengths[1], options);
    for (std::size_t axis = 2; axis < lengths.size(); ++axis)
        if (lengths[axis] > 1) {
            add_alert(micrograph, "STACK",
                      fmt::format("the image is a stack with {} planes along axis {}; the first plane is read",
                                  lengths[axis], axis),
                      "to use another plane, save it as a separate file");
            break;
        }

    const auto type = sample_type(static_cast<int>(*data_type));
    if (!type)
        throw damaged(fmt::format(
            "pixels of type {}, which is not read; convert the image to real numbers with DigitalMicrograph",
            *data_type));
    const auto needed =
        static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) * bytes_of(*type);
    if (numbers->bytes < needed)
        throw FormatError(file.name, {.offset = numbers->offset},
                          fmt::format("{} bytes of pixels, but {} × {} of {} bytes need {}; the file is damaged",
                                      numbers->bytes, size.width, size.height, bytes_of(*type), needed));
    micrograph.pixels = read_pixels(file, {numbers->offset, *type, tags.big_endian, size});
    if (is_complex(*type))
        add_alert(micrograph, "COMPLEX_MAGNITUDE", "pixels are complex numbers; their magnitude is read",
                  "if this is a Fourier transform, save the real image");

    set_pixel_size(micrograph, axis_of(*data, 0), axis_of(*data, 1), fmt::format("DM{} calibration", tags.version));
    describe(micrograph, image);
    return micrograph;
}

}  // namespace setae::imaging
