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
#include "setae/topography/line_scans.hpp"

namespace setae::formats {
namespace {

using topography::Measurement;
using topography::Profile;

struct Units {
    std::string x;
    std::string heights;
};

/// Units from the header, else the one given; where neither says a column's, the other column's holds for both (a
/// measurement has one length unit), with an alert. Empty where nobody says any.
Units find_units(const HeightCurve& curve, ChannelInfo& info, const ReadOptions& options, const bytes::Source& source) {
    Units units{curve.x.unit, curve.heights.unit};
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
             fmt::format("the header states no unit for {}; taken as {} as in the other column", column, missing),
             "compare the heights with what is known of the surface, or give --unit"});
    }
    info.unit = units.heights;
    compare_unit(info, options, source);
    return units;
}

void require_positions(const Array1D& x, const bytes::Source& source) {
    for (Index i = 0; i < x.size(); ++i)
        if (!std::isfinite(x[i])) throw FormatError(source.name, {}, fmt::format("x of point {} is undefined", i + 1));
}

Measurement to_measurement(Profile profile) {
    if (increases(-profile.positions)) {
        profile.positions.reverseInPlace();
        profile.heights.reverseInPlace();
        profile.standard_error.reverseInPlace();
    }
    if (auto scan = topography::to_line_scan(profile)) return *scan;
    return profile;
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
    info.alerts.push_back({"UNIT_MISMATCH", source.name,
                           fmt::format("unit {} given, but the file says {}, which was used", given, info.unit),
                           "check the unit; correct the file's header where it is wrong"});
}

Channel curve_channel(ChannelInfo info, HeightCurve curve, const ReadOptions& options, const bytes::Source& source) {
    const auto units = find_units(curve, info, options, source);
    require_positions(curve.x.values, source);
    if (curve.x.values.size() < 2)
        throw FormatError(source.name, {}, fmt::format("{} point, expected at least 2", curve.x.values.size()));
    if (units.heights.empty()) {
        info.shape = {curve.x.values.size()};
        (void)complete(info, {}, source);
        const auto message = fmt::format(
            "{}: the file states no unit; give it, as in --unit um, or of x and of heights, as in --unit \"mm, um\"",
            source.name);
        return {std::move(info), [message]() -> Measurement { throw InvalidArgument(message); }};
    }
    const auto height_unit = length_unit(units.heights, source);
    info.unit = info.metadata.unit = height_unit.name;
    info.metadata.file = source.name;
    info.metadata.format = info.format;
    if (info.metadata.name.empty()) info.metadata.name = info.name;
    Profile profile{curve.x.values * length_unit(units.x, source).factor, curve.heights.values * height_unit.factor,
                    info.metadata};
    if (curve.standard_error) profile.standard_error = standard_errors(*curve.standard_error, source);
    return loaded_channel(std::move(info), checked(to_measurement(std::move(profile)), source));
}

}  // namespace setae::formats
