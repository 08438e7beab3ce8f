// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "netcdf_classic.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/bytes/json_text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/header.hpp"
#include "storage/hdf5_file.hpp"
#include "storage/stored_array.hpp"
#include "writing.hpp"

// Topographies as in containers: variables heights(x[, y]), x and y with attributes length, periodic and unit, and
// optionally mask; or heights(n) over positions x(n); and a global attribute json with further metadata.
namespace setae::formats {
namespace {

constexpr const char* nc = "nc";
constexpr std::string_view only_dimension = "This is a netCDF dimension but not a netCDF variable";

/// NetCDF-4: the datasets in the root of an HDF5 file; a dimension without values is a dataset with this property.
ArrayFile netcdf4(const bytes::Source& source) {
    const Hdf5File hdf5(source);
    ArrayFile file{hdf5.attributes("/"), {}};
    for (const char* name : {"heights", "mask", "x", "y"}) {
        auto array = hdf5.array(std::string("/") + name);
        if (!array || text_of(array->attributes, "NAME").starts_with(only_dimension)) continue;
        array->name = name;
        file.arrays.push_back(std::move(*array));
    }
    return file;
}

std::string unit_text(const StoredArray& array) {
    const auto unit = text_of(array.attributes, "unit");
    return unit.empty() ? text_of(array.attributes, "units") : unit;
}

/// Metres per unit of an axis, by its unit or that of the heights; empty if neither is known.
std::optional<double> metres(const StoredArray& axis, const std::optional<double>& of_heights,
                             const bytes::Source& source) {
    const auto unit = unit_text(axis);
    return unit.empty() ? of_heights : length_unit(unit, source).factor;
}

bool is_line_of(const StoredArray& array, Index points) {
    return array.shape.size() == 1 && array.shape[0] == points && points > 1 && array.refusal.empty();
}

/// Extent along a coordinate in its unit: the attribute "length", or equal steps. Writers stored the attribute in
/// single precision: the coordinates, in double precision, then give the same extent with all its digits.
std::optional<double> axis_length(const StoredArray& axis, Index points) {
    const auto stated = number_of(axis.attributes, "length");
    if (!is_line_of(axis, points)) return stated;
    const auto n = static_cast<double>(points);
    if (stated) {
        const auto ends = ends_of(axis, nc);
        const double from_positions = (ends.last - ends.first) * n / (n - 1.0);
        return std::abs(from_positions / *stated - 1.0) < 1e-6 ? from_positions : *stated;
    }
    const auto positions = values_of(axis, nc);
    const double step = (positions[points - 1] - positions[0]) / (n - 1.0);
    for (Index i = 1; i < points; ++i)
        if (!(std::abs(positions[i] - positions[i - 1] - step) <= 1e-6 * std::abs(step))) return std::nullopt;
    return step * n;
}

/// Extents of heights(x[, y]) [m]; empty if one is unknown.
std::vector<double> uniform_size(const ArrayFile& file, const StoredArray& heights, const std::optional<double>& unit,
                                 const bytes::Source& source) {
    std::vector<double> size;
    for (std::size_t k = 0; k < heights.shape.size(); ++k) {
        const auto* axis = file.find(k == 0 ? "x" : "y");
        const auto length = axis ? axis_length(*axis, heights.shape[k]) : std::nullopt;
        const auto factor = axis ? metres(*axis, unit, source) : std::nullopt;
        if (!length || !factor) return {};
        size.push_back(*length * *factor);
    }
    return size;
}

/// Value that the library writes for missing data, unless the variable defines another one; none for bytes.
std::optional<double> default_fill(Sample sample) {
    switch (sample) {
        case Sample::int16: return -32767.0;
        case Sample::uint16: return 65535.0;
        case Sample::int32: return -2147483647.0;
        case Sample::uint32: return 4294967295.0;
        case Sample::int64: return -9223372036854775806.0;
        case Sample::uint64: return 18446744073709551614.0;
        case Sample::float32:
        case Sample::float64: return 9.9692099683868690e+36;
        default: return std::nullopt;
    }
}

/// Conversion of raw values to heights by the conventions of NetCDF.
RawScale raw_scale(const StoredArray& heights, double unit) {
    RawScale scale;
    const auto fill = default_fill(heights.sample);
    if (fill && !number_of(heights.attributes, "_FillValue")) scale.undefined.push_back(*fill);
    scale.factor = unit * number_of(heights.attributes, "scale_factor").value_or(1.0);
    scale.offset = unit * number_of(heights.attributes, "add_offset").value_or(0.0);
    for (const char* name : {"_FillValue", "missing_value"})
        if (const auto missing_value = number_of(heights.attributes, name)) scale.undefined.push_back(*missing_value);
    return scale;
}

std::string json_text(const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>()
                             : value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Adds the metadata in the attribute json.
void add_info(topography::Metadata& metadata, const std::string& text) {
    const auto info = bytes::json_or_null(text);
    if (!info.is_object()) return;
    for (const auto& [key, value] : info.items()) {
        if (key == "acquisition_time" && value.is_string()) metadata.acquisition_time = value.get<std::string>();
        else if (key != "instrument" || !value.is_object()) metadata.attributes[key] = json_text(value);
    }
    if (!info.contains("instrument") || !info["instrument"].is_object()) return;
    const auto& instrument = info["instrument"];
    if (instrument.contains("name") && instrument["name"].is_string())
        metadata.instrument.name = instrument["name"].get<std::string>();
    if (instrument.contains("type") && instrument["type"].is_string())
        metadata.attributes["instrument_type"] = instrument["type"].get<std::string>();
    const nlohmann::json::json_pointer value("/parameters/tip_radius/value"), unit("/parameters/tip_radius/unit");
    if (!instrument.contains(value) || !instrument.contains(unit) || !instrument[value].is_number() ||
        !instrument[unit].is_string())
        return;
    const auto length = tables::try_parse_unit(instrument[unit].get<std::string>());
    if (length && length->dimension == dimension::length)
        metadata.instrument.tip_radius = instrument[value].get<double>() * length->factor;
}

/// Sets heights undefined where the variable mask is not 0.
void apply_mask(topography::Measurement& measurement, const StoredArray& mask) {
    const auto masked = values_of(mask, nc);
    std::visit(
        [&](auto& m) {
            for (Index i = 0; i < masked.size(); ++i)
                if (masked[i] != 0.0) m.heights.data()[i] = undefined;
        },
        measurement);
}

struct Positions {
    StoredArray array;
    double factor = 1.0;
};

/// Processing of the heights of a channel after reading.
struct Finish {
    bytes::Source source;
    std::optional<StoredArray> mask;
    std::optional<Positions> positions;
    bool periodic = false;

    [[nodiscard]] bool changes_heights() const { return mask || positions; }

    topography::Measurement operator()(topography::Measurement measurement) const {
        if (mask) apply_mask(measurement, *mask);
        if (auto* map = std::get_if<topography::HeightMap>(&measurement)) map->periodic = periodic;
        if (auto* scan = std::get_if<topography::LineScan>(&measurement)) {
            scan->periodic = periodic;
            if (positions)
                measurement = topography::Profile{values_of(positions->array, nc) * positions->factor,
                                                  std::move(scan->heights), std::move(scan->metadata)};
        }
        return checked(std::move(measurement), source);
    }
};

bool is_classic(std::string_view head) {
    return head.size() > 3 && head.starts_with("CDF") && (head[3] == 1 || head[3] == 2 || head[3] == 5);
}

/// Whether an HDF5 file has heights with coordinates, or heights and the mark of NetCDF.
bool is_netcdf4(const bytes::Source& source) {
    try {
        const Hdf5File file(source);
        if (!file.array("/heights")) return false;
        return file.array("/x").has_value() || !text_of(file.attributes("/"), "_NCProperties").empty();
    } catch (const FormatError&) {
        return false;
    }
}

Match detect_netcdf(std::string_view head, const bytes::Source& source) {
    return is_classic(head) || (bytes::find_hdf5(head) == 0u && is_netcdf4(source)) ? Match::yes : Match::no;
}

/// A channel with lengths in an unknown unit.
Channel without_unit(ChannelInfo info, const bytes::Source& source) {
    const auto message = fmt::format("{}: the file states no unit; give `unit`, such as \"um\"", source.name);
    return {std::move(info), [message]() -> topography::Measurement { throw InvalidArgument(message); }};
}

std::vector<Channel> open_netcdf(const bytes::Source& source, const ReadOptions& options) {
    const auto file = is_classic(source.head(4)) ? classic_netcdf(source) : netcdf4(source);
    const auto* heights = file.find("heights");
    if (!heights)
        throw FormatError(source.name, {},
                          "NetCDF: no variable 'heights' of numbers; tables are not read as topographies");
    const bool has_points = std::all_of(heights->shape.begin(), heights->shape.end(), [](Index n) { return n > 1; });
    if (!is_map_or_line(*heights) || !has_points)
        throw FormatError(
            source.name, {},
            fmt::format("NetCDF: heights of shape ({}), expected 1 or 2 dimensions with more than one value along each",
                        fmt::join(heights->shape, ", ")));
    const auto *x = file.find("x"), *mask = file.find("mask");
    const auto own_unit = unit_text(*heights);
    const auto stated =
        own_unit.empty() && x ? unit_text(*x) : own_unit;  // if steps are unequal only the positions have a unit
    std::optional<double> unit;
    if (!stated.empty() || options.unit) unit = length_unit(stated.empty() ? *options.unit : stated, source).factor;

    ChannelInfo info{.name = "heights", .format = nc, .unit = stated};
    if (const auto text = text_of(file.attributes, "json"); !text.empty()) add_info(info.metadata, text);
    Finish finish{source, {}, {}, x && number_of(x->attributes, "periodic").value_or(0.0) != 0.0};
    if (mask) {
        if (mask->shape != heights->shape)
            throw FormatError(source.name, {}, "NetCDF: mask and heights have different shapes");
        require_array(*mask, nc);
        finish.mask = *mask;
    }
    const bool has_positions = heights->shape.size() == 1 && x && !number_of(x->attributes, "length");
    if (has_positions && !is_line_of(*x, heights->shape[0]))
        throw FormatError(source.name, {}, "NetCDF: x and heights have different lengths");
    const auto axis_unit = has_positions ? metres(*x, unit, source) : unit;
    if (has_positions && axis_unit) {
        const auto ends = ends_of(*x, nc);
        info.size = {std::abs(ends.last - ends.first) * *axis_unit};
        finish.positions = Positions{*x, *axis_unit};
    } else if (!has_positions) {
        info.size = uniform_size(file, *heights, unit, source);
    }
    const bool only_unit_missing = !unit && (has_positions || (x && number_of(x->attributes, "length")));
    auto channel = array_channel(std::move(info), *heights, FirstIndex::x_to_the_right,
                                 raw_scale(*heights, stated.empty() ? 1.0 : *unit), options);
    if (only_unit_missing) return {without_unit(std::move(channel.info), source)};
    if (finish.changes_heights() || finish.periodic)
        read_as_a_whole(channel, [read = channel.read, finish] { return finish(read()); });
    return {std::move(channel)};
}

}  // namespace

Format netcdf_format() {
    return {
        .identifier = nc,
        .name = "NetCDF topography",
        .extensions = ".nc",
        .description =
            "NetCDF, classic or version 4, with variables heights, x, y and perhaps mask, as containers hold them; with unequal steps x holds the positions",
        .heights = "in the unit of the attribute; masked points and fill values are undefined",
        .orientation = "first index x, second y downwards",
        .reference = "NetCDF Users Guide, classic format; variables as SurfaceTopography describes them",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_netcdf,
        .open = open_netcdf,
        .write = write_measurement_as_netcdf};
}

}  // namespace setae::formats
