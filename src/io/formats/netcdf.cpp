// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "netcdf_classic.hpp"
#include "format_list.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "writing.hpp"

// Topographies as containers hold them: variables heights(x[, y]), x and y with attributes length, periodic and unit, and
// perhaps mask; or heights(n) over positions x(n).
namespace setae::io {
namespace {

using Variable = ClassicNetcdf::Variable;

/// Extent along a coordinate: the attribute "length". Writers stored it in single precision: the coordinates, in
/// double precision, then give the same extent with all its digits.
double axis_length(const ClassicNetcdf& file, const char* axis, Index points, const Source& source) {
    const auto* variable = file.find(axis);
    const auto length = variable ? variable->number("length") : std::nullopt;
    if (!length) throw FormatError(source.name, {}, fmt::format("NetCDF: no coordinate '{}' with an attribute 'length'", axis));
    const auto positions = file.values(*variable);
    if (positions.size() < 2 || static_cast<Index>(positions.size()) != points) return *length;
    const double steps = static_cast<double>(positions.size() - 1);
    const double from_positions = (positions.back() - positions.front()) * static_cast<double>(positions.size()) / steps;
    return std::abs(from_positions / *length - 1.0) < 1e-6 ? from_positions : *length;
}

/// Heights in file order; undefined where a mask is set or the fill value stands.
std::vector<double> defined_heights(const ClassicNetcdf& file, const Variable& variable, const Source& source) {
    auto heights = file.values(variable);
    for (const char* name : {"_FillValue", "missing_value"})
        if (const auto fill = variable.number(name)) std::replace(heights.begin(), heights.end(), *fill, undefined);
    if (const auto* mask = file.find("mask")) {
        const auto masked = file.values(*mask);
        if (masked.size() != heights.size()) throw FormatError(source.name, {}, "NetCDF: mask and heights differ in shape");
        for (std::size_t i = 0; i < heights.size(); ++i)
            if (masked[i] != 0.0) heights[i] = undefined;
    }
    return heights;
}

topography::Measurement to_measurement(const ClassicNetcdf& file, const Variable& variable, double factor, const Source& source,
                                       topography::Metadata metadata) {
    const auto& shape = variable.shape;
    const auto heights = defined_heights(file, variable, source);
    const auto* x = file.find("x");
    const bool periodic = x && x->number("periodic").value_or(0.0) != 0.0;
    if (shape.size() == 2) {
        const Eigen::Map<const Array2D> map(heights.data(), shape[0], shape[1]);
        return topography::HeightMap{map * factor,
                                     {factor * axis_length(file, "x", shape[0], source), factor * axis_length(file, "y", shape[1], source)},
                                     periodic, std::move(metadata)};
    }
    if (shape.size() != 1) throw FormatError(source.name, {}, fmt::format("NetCDF: heights of {} dimensions, expected 1 or 2", shape.size()));
    const Eigen::Map<const Array1D> line(heights.data(), shape[0]);
    if (x && !x->number("length")) {
        const auto positions = file.values(*x);
        if (positions.size() != heights.size()) throw FormatError(source.name, {}, "NetCDF: x and heights differ in length");
        return topography::Profile{Eigen::Map<const Array1D>(positions.data(), shape[0]) * factor, line * factor, std::move(metadata)};
    }
    return topography::LineScan{line * factor, factor * axis_length(file, "x", shape[0], source), periodic, std::move(metadata)};
}

Match detect_netcdf(std::string_view head, const Source&) {
    const bool classic = head.size() > 3 && head.starts_with("CDF") && (head[3] == 1 || head[3] == 2 || head[3] == 5);
    return classic ? Match::yes : Match::no;
}

std::vector<Channel> open_netcdf(const Source& source, const ReadOptions& options) {
    const ClassicNetcdf file(source);
    const auto* heights = file.find("heights");
    if (!heights) throw FormatError(source.name, {}, "NetCDF: no variable 'heights'; tables are not read as topographies");
    const auto stated = heights->text("unit");
    const auto unit = length_unit(stated.empty() ? required_unit(options, source) : stated, source);
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "nc";
    metadata.unit = unit.name;
    ChannelInfo info{.name = "heights", .format = "nc", .unit = unit.name, .orientation = heights->shape.size() == 2 ? "first index x, second y downwards, as stored" : ""};
    return {loaded_channel(std::move(info), checked(to_measurement(file, *heights, unit.factor, source, metadata), source))};
}

}  // namespace

Format netcdf_format() {
    return {.identifier = "nc",
            .name = "NetCDF topography",
            .extensions = ".nc",
            .description = "classic NetCDF with variables heights, x, y and perhaps mask, as containers hold them",
            .heights = "in the unit of the attribute; masked points and fill values are undefined",
            .orientation = "first index x, second y downwards",
            .reference = "NetCDF Users Guide, classic format",
            .tested_on_real_files = true,
            .carries_scale = true,
            .detect = detect_netcdf,
            .open = open_netcdf,
            .write = write_measurement_as_netcdf};
}

}  // namespace setae::io
