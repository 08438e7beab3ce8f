// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/header.hpp"
#include "storage/hdf5_file.hpp"
#include "storage/stored_array.hpp"

// DATX of Zygo's Mx: HDF5 with a table /MetaData of triples (object, relation, object or value) that leads to the
// surface, whose attributes contain unit, undefined value and pixel size.
namespace setae::formats {
namespace {

constexpr const char* datx = "datx";
constexpr double huge = 1e30;  // markers of missing data are far above any height

/// Value of an object in the table; empty if there is none.
std::string related(const std::vector<Hdf5Record>& triples, const std::string& object, const std::string& relation) {
    const auto tells = [&](const Hdf5Record& triple) {
        return triple.texts.size() == 3 && triple.texts[0] == object && triple.texts[1] == relation;
    };
    const auto found = std::find_if(triples.begin(), triples.end(), tells);
    return found == triples.end() ? std::string{} : found->texts[2];
}

/// Paths of the datasets below /Data, the measured surface first.
std::vector<std::string> data_paths(const Hdf5File& file) {
    const auto triples = file.records("/MetaData");
    auto surface = related(triples, related(triples, related(triples, "Root", "Measurement"), "Surface"), "Path");
    if (!surface.empty() && !surface.starts_with('/')) surface.insert(0, "/");
    auto paths = file.datasets();
    std::erase_if(paths, [](const std::string& path) { return !path.starts_with("/Data/"); });
    std::stable_partition(paths.begin(), paths.end(),
                          [](const std::string& path) { return path.starts_with("/Data/Surface/"); });
    std::stable_partition(paths.begin(), paths.end(), [&](const std::string& path) { return path == surface; });
    return paths;
}

/// A unit in the words of Zygo, "NanoMeters".
std::string plain_unit(const std::string& unit) {
    const auto name = bytes::lowered(unit);
    constexpr std::pair<const char*, const char*> units[] = {
        {"nanometers", "nm"},  {"micrometers", "um"}, {"microns", "um"},         {"millimeters", "mm"},
        {"centimeters", "cm"}, {"meters", "m"},       {"angstroms", "angstrom"}, {"picometers", "pm"}};
    for (const auto& [spelled, plain] : units)
        if (name == spelled) return plain;
    return unit;
}

/// Metres per pixel along a direction: the second parameter of its converter.
std::optional<double> pixel(const Hdf5File& file, const std::string& path, const char* converter) {
    const auto record = file.record_attribute(path, converter);
    if (!record || record->texts.size() < 2 || record->texts[0] != "LateralCat" || record->texts[1] != "Pixels" ||
        record->numbers.size() < 2)
        return std::nullopt;
    return record->numbers[1];
}

/// Value of one stored unit [m], and its unit; empty if that is no length.
struct HeightScale {
    double factor = 1.0;
    std::string unit;
};

std::optional<HeightScale> height_scale(const Attributes& attributes, const std::string& unit) {
    if (bytes::lowered(unit) == "fringes") {
        const auto wavelength = number_of(attributes, "Wavelength");
        if (!wavelength) return std::nullopt;
        const double factor = number_of(attributes, "Interferometric Scale Factor").value_or(0.5),
                     obliquity = number_of(attributes, "Obliquity Factor").value_or(1.0);
        return HeightScale{*wavelength * factor * obliquity, "m"};
    }
    const auto known = tables::try_parse_unit(plain_unit(unit));
    if (!known || known->dimension != dimension::length) return std::nullopt;
    return HeightScale{known->factor, plain_unit(unit)};
}

RawScale raw_scale(const Attributes& attributes, double factor) {
    RawScale scale{.factor = factor};
    const auto missing = number_of(attributes, "No Data");
    if (missing) scale.undefined = {*missing};
    if (missing && *missing > huge) scale.greatest = std::nextafter(*missing, 0.0);
    return scale;
}

/// Instrument: attributes of the surface or of a group below /Attributes with such endings of their names.
void add_instrument(const Hdf5File& file, const Attributes& surface, topography::Metadata& metadata) {
    metadata.instrument.type = "interferometer";
    auto all = surface;
    for (const auto& group : file.members("/Attributes"))
        for (auto& attribute : file.attributes("/Attributes/" + group)) all.push_back(std::move(attribute));
    for (const auto& attribute : all) {
        if (attribute.text.empty()) continue;
        if (attribute.name.ends_with("System Type") && metadata.instrument.name.empty())
            metadata.instrument.name = attribute.text;
        if (attribute.name.ends_with("System Serial Number"))
            metadata.attributes.emplace("serial_number", attribute.text);
    }
}

/// "Surface" of "/Data/Surface/{0D6D…}".
std::string name_of(const std::string& path) {
    constexpr std::size_t before = std::string_view("/Data/").size();
    return path.substr(before, std::min(path.find('/', before), path.size()) - before);
}

Channel channel_of(const Hdf5File& file, const StoredArray& array, const bytes::Source& source,
                   const ReadOptions& options) {
    const auto unit = text_of(array.attributes, "Unit");
    const auto scale = height_scale(array.attributes, unit);
    ChannelInfo info{.name = name_of(array.name), .format = datx, .orientation = "rows from the top, as stored"};
    const auto x = pixel(file, array.name, "X Converter"), y = pixel(file, array.name, "Y Converter");
    if (x && y) info.size = {*x * static_cast<double>(array.shape[1]), *y * static_cast<double>(array.shape[0])};
    add_instrument(file, array.attributes, info.metadata);
    const bool is_surface = array.name.starts_with("/Data/Surface/");
    if (!is_surface || (!scale && !unit.empty())) {
        info.unit = unit;
        info.shape = {array.shape[1], array.shape[0]};
        info.metadata.file = source.name;
        return non_height_channel(std::move(info));
    }
    if (scale) info.unit = scale->unit;
    if (bytes::lowered(unit) == "fringes") info.metadata.attributes["stored_unit"] = unit;
    const auto converter = file.record_attribute(array.name, "Z Converter");
    if (converter && converter->texts.size() > 1 && converter->texts[0] == "HeightCat" &&
        bytes::lowered(converter->texts[1]) != bytes::lowered(unit))
        info.alerts.push_back(
            {"UNIT_MISMATCH", source.name,
             fmt::format(
                 "heights are in {} according to the attribute Unit and in {} according to the Z Converter; the "
                 "first was used",
                 unit, converter->texts[1]),
             "compare the heights with those in Mx"});
    return array_channel(std::move(info), array, FirstIndex::y_downwards,
                         raw_scale(array.attributes, scale ? scale->factor : 1.0), options);
}

Match detect_datx(std::string_view head, const bytes::Source& source) {
    if (!bytes::find_hdf5(head)) return Match::no;
    try {
        const auto members = Hdf5File(source).members("/");
        const auto has = [&](const char* name) {
            return std::find(members.begin(), members.end(), name) != members.end();
        };
        return has("MetaData") && has("Data") ? Match::yes : Match::no;
    } catch (const FormatError&) {
        return Match::no;
    }
}

std::vector<Channel> open_datx(const bytes::Source& source, const ReadOptions& options) {
    const Hdf5File file(source);
    std::vector<Channel> channels;
    for (const auto& path : data_paths(file)) {
        const auto array = file.array(path);
        if (array && array->shape.size() == 2 && array->shape[0] > 1 && array->shape[1] > 1)
            channels.push_back(channel_of(file, *array, source, options));
    }
    if (channels.empty()) throw FormatError(source.name, {.offset = 0}, "DATX: no map below /Data");
    return channels;
}

}  // namespace

Format datx_format() {
    return {
        .identifier = datx,
        .name = "Zygo DATX",
        .extensions = ".datx",
        .description =
            "HDF5 files of Zygo's Mx: surfaces with their units, pixel sizes and undefined points; other maps are listed",
        .heights =
            "in the unit of the attribute Unit; fringes times wavelength, scale factor (1/2 where not stated) and obliquity; undefined at the value of the attribute No Data",
        .orientation = "rows from the top, as stored",
        .not_read = "intensities and quality maps are listed, not read",
        .reference = "SurfaceTopography's description of its reader; prysm's reader for fringes",
        .tested_on_real_files = false,
        .carries_scale = true,
        .detect = detect_datx,
        .open = open_datx};
}

}  // namespace setae::formats
