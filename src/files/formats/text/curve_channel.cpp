// SPDX-License-Identifier: GPL-3.0-or-later
#include "curve_channel.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"
#include "setae/topography/no_data.hpp"
#include "trace.hpp"

namespace setae::formats {
namespace {

using topography::Measurement;
using topography::Profile;

struct Units {
    std::string x;
    std::string heights;
};

/// Units from the header, otherwise the given ones; if a column has neither, the unit of the other column applies to
/// both (a measurement has one length unit), with a warning. Empty without any unit.
Units find_units(const HeightCurve& curve, ChannelInfo& info, const ReadOptions& options, const bytes::Source& source) {
    Units units{curve.x.unit, curve.heights.unit};
    if (tables::is_unit_of(units.x, dimension::wavevector))
        throw FormatError(
            source.name, {.line = 1},
            fmt::format("the header gives {} for the first column, so that this is a spectrum; expected its density in "
                        "a unit such as um3 (C1D) or um4 (C_iso), got '{}': divide f S(f) by f, square amplitudes, and "
                        "undo logarithms and decibels",
                        units.x, units.heights));
    for (const auto* unit : {&units.x, &units.heights})
        if (!unit->empty() && !is_length_unit(*unit))
            throw FormatError(
                source.name, {.line = 1},
                fmt::format(
                    "the header gives the unit '{}', expected a length such as um; force curves are read by `setae jkr fit`",
                    *unit));
    const auto given = given_units(options);
    if (units.x.empty() && units.heights.empty()) return {given.positions, given.heights};
    const bool one_missing = units.x.empty() || units.heights.empty();
    auto& missing = units.x.empty() ? units.x : units.heights;
    if (one_missing && options.unit) {
        missing = units.x.empty() ? given.positions : given.heights;
        return units;
    }
    if (one_missing) {
        const auto* column = units.x.empty() ? "x" : "heights";
        missing = units.x.empty() ? units.heights : units.x;
        info.alerts.push_back(
            {"UNIT_ASSUMED", source.name,
             fmt::format("the header states no unit for {}; {} was assumed, the unit of the other column", column,
                         missing),
             "compare the heights with what is known about the surface, or give `unit`"});
    }
    info.unit = units.heights;
    compare_unit(info, options, source);
    return units;
}

void require_positions(const Array1D& x, const bytes::Source& source) {
    for (Index i = 0; i < x.size(); ++i)
        if (!std::isfinite(x[i])) throw FormatError(source.name, {}, fmt::format("x of point {} is undefined", i + 1));
}

/// The points of one pass.
HeightCurve part_of(const HeightCurve& curve, const Pass& pass) {
    const Index n = pass.last - pass.first + 1;
    auto part = curve;
    part.x.values = curve.x.values.segment(pass.first, n);
    part.heights.values = curve.heights.values.segment(pass.first, n);
    if (part.standard_error) part.standard_error->values = curve.standard_error->values.segment(pass.first, n);
    return part;
}

/// "height (forward)", for more than two passes "height (pass 3, forward)".
std::string name_of_pass(const std::string& name, std::size_t number, std::size_t count, bool backward) {
    const auto* way = backward ? "backward" : "forward";
    const auto pass = count > 2 ? fmt::format("(pass {}, {})", number + 1, way) : fmt::format("({})", way);
    return name.empty() ? pass : name + " " + pass;
}

Alert passes_alert(const std::vector<Pass>& passes, const bytes::Source& source) {
    return {"PASSES_SPLIT", source.name,
            fmt::format("x runs along the profile in {} passes, with {} points in the first: each pass is a channel",
                        passes.size(), passes.front().last - passes.front().first + 1),
            "choose one pass with `channel`; to average passes, analyse several as measurements of one "
            "surface"};
}

/// Sets markers of missing heights undefined before heights are averaged.
void undefine_marks(Profile& profile, const LengthUnit& unit, const std::string& file) {
    const auto& x = profile.positions;
    const Index n = x.size();
    if ((x.tail(n - 1) != x.head(n - 1)).all()) return;
    topography::Measurement measurement = std::move(profile);
    const auto report = topography::find_no_data(measurement, {.unit = unit.factor, .codes = {}});
    topography::undefine(measurement, report);
    profile = std::move(std::get<Profile>(measurement));
    if (!report.any_undefined()) return;
    for (auto& alert : topography::alerts_of(report, file, unit.name))
        profile.metadata.alerts.push_back(std::move(alert));
}

Channel curve_channel(ChannelInfo info, const HeightCurve& curve, const Units& units, bool keep_values,
                      const bytes::Source& source) {
    if (curve.x.values.size() < 2)
        throw FormatError(source.name, {}, fmt::format("{} point, expected at least 2", curve.x.values.size()));
    if (units.heights.empty()) {
        info.shape = {curve.x.values.size()};
        (void)complete(info, {}, source);
        return channel_without_unit(std::move(info), source);
    }
    const auto height_unit = length_unit(units.heights, source);
    info.unit = info.metadata.unit = height_unit.name;
    info.metadata.file = source.name;
    info.metadata.format = info.format;
    if (info.metadata.name.empty()) info.metadata.name = info.name;
    const double position_unit = length_unit(units.x, source).factor;
    Profile profile{curve.x.values * position_unit, curve.heights.values * height_unit.factor, info.metadata};
    if (curve.standard_error) profile.standard_error = standard_errors(*curve.standard_error, source);
    if (!keep_values) undefine_marks(profile, height_unit, source.name);
    auto trace = traced(std::move(profile), curve.x.values, position_unit, source.name);
    auto& alerts = topography::metadata(trace.measurement).alerts;
    alerts.insert(alerts.end(), trace.alerts.begin(), trace.alerts.end());
    return loaded_channel(std::move(info), checked(std::move(trace.measurement), source));
}

}  // namespace

bool increases(const Array1D& values) {
    for (Index i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1])) return false;
    return true;
}

bool is_length_unit(const std::string& text) {
    const auto unit = tables::try_parse_unit(text);
    return text == "A" || (unit && unit->dimension == dimension::length);
}

std::optional<double> try_length(std::string_view text) {
    try {
        return parse_quantity(trimmed(text), dimension::length);
    } catch (const InvalidArgument&) {
        return std::nullopt;
    }
}

void compare_unit(ChannelInfo& info, const ReadOptions& options, const bytes::Source& source) {
    const auto given = given_units(options).heights;
    if (given.empty() || info.unit.empty() ||
        length_unit(given, source).factor == length_unit(info.unit, source).factor)
        return;
    info.alerts.push_back(
        {"UNIT_MISMATCH", source.name,
         fmt::format("the unit {} was given, but the file states {}, which was used", given, info.unit),
         "check the unit; correct the header of the file if it is wrong"});
}

MapUnits units_of_map(ChannelInfo& info, MapUnits stated, const ReadOptions& options, const bytes::Source& source) {
    auto& [positions, heights] = stated;
    if (heights.empty() != positions.empty() && !options.unit) {
        info.alerts.push_back(
            {"UNIT_ASSUMED", source.name,
             fmt::format("the header states no unit for {}; {} was assumed, the unit of the others",
                         heights.empty() ? "heights" : "x and y", heights.empty() ? positions : heights),
             "compare the heights with what is known about the surface, or give `unit`"});
        (heights.empty() ? heights : positions) = heights.empty() ? positions : heights;
    }
    info.unit = heights;
    compare_unit(info, options, source);
    const auto given = given_units(options);
    if (positions.empty()) positions = given.positions;
    if (heights.empty()) heights = given.heights;
    info.unit = heights;
    return stated;
}

std::vector<Channel> curve_channels(ChannelInfo info, const HeightCurve& curve, const ReadOptions& options,
                                    const bytes::Source& source) {
    const auto units = find_units(curve, info, options, source);
    require_positions(curve.x.values, source);
    if (curve.x.values.size() < 2)
        throw FormatError(source.name, {}, fmt::format("{} point, expected at least 2", curve.x.values.size()));
    const auto passes = passes_of(curve.x.values);
    if (passes.size() == 1 && are_scattered(curve.x.values))
        throw FormatError(
            source.name, {},
            fmt::format("x of {} points jumps back and forth, as positions of scattered points do; expected a profile "
                        "with x in the order of measurement",
                        curve.x.values.size()));
    if (passes.size() == 1) return {curve_channel(std::move(info), curve, units, options.keep_values, source)};
    info.metadata.alerts.push_back(passes_alert(passes, source));
    std::vector<Channel> channels;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        auto own = info;
        own.name = own.metadata.name = name_of_pass(info.name, i, passes.size(), passes[i].backward);
        channels.push_back(
            curve_channel(std::move(own), part_of(curve, passes[i]), units, options.keep_values, source));
    }
    return channels;
}

}  // namespace setae::formats
