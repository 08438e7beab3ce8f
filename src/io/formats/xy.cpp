// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "header.hpp"
#include "format_list.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/io/profile_file.hpp"
#include "setae/io/table_file.hpp"
#include "setae/topography/line_scans.hpp"
#include "text.hpp"

namespace setae::io {
namespace {

using topography::Measurement;
using topography::Profile;
using RawColumn = RawTable::RawColumn;

bool counts_up(const Array1D& values) {
    for (Index i = 0; i < values.size(); ++i)
        if (values[i] != values[0] + static_cast<double>(i)) return false;
    return values[0] == 0.0 || values[0] == 1.0;
}

bool increases(const Array1D& values) {
    for (Index i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1])) return false;
    return true;
}

/// The two columns that are x and h, heights undefined where a third column says they are not valid.
struct Curve {
    RawColumn x;
    RawColumn heights;
    std::optional<RawColumn> standard_error = {};
};

Curve pick_columns(const RawTable& table, const Source& source) {
    const auto& columns = table.columns;
    if (columns.size() == 2) return {columns[0], columns[1]};
    if (columns.size() == 3) {
        if (lowered(columns[2].name) == "valid") {
            Curve curve{columns[0], columns[1]};
            curve.heights.values = (columns[2].values != 0.0).select(columns[1].values, undefined);
            return curve;
        }
        if (lowered(columns[2].name) == "standard_error") return {columns[0], columns[1], columns[2]};
        const bool named_index = lowered(columns[0].name) == "index";
        const bool along_x = increases(columns[1].values) || increases(-columns[1].values);
        if ((named_index || columns[0].name.empty()) && counts_up(columns[0].values) && along_x) return {columns[1], columns[2]};
    }
    throw FormatError(source.name, {},
                      fmt::format("{} of numbers, expected x and height, after an index or before a column 'valid' or 'standard_error'; "
                                  "grids of x, y, z are not read", columns.size() == 1 ? "1 column" : fmt::format("{} columns", columns.size())));
}

struct Units {
    std::string x;
    std::string heights;
    std::vector<Alert> alerts;
};

bool is_length(const std::string& text) {
    const auto unit = try_parse_unit(text);
    return text == "A" || (unit && unit->dimension == dimension::length);
}

/// Units from the header, else the one given; where neither says a column's, the other column's holds for both (a
/// measurement has one length unit), with an alert.
Units find_units(const Curve& curve, const ReadOptions& options, const Source& source) {
    Units units{curve.x.unit, curve.heights.unit, {}};
    for (const auto* unit : {&units.x, &units.heights})
        if (!unit->empty() && !is_length(*unit))
            throw FormatError(source.name, {}, fmt::format("the header gives the unit '{}', expected a length such as um", *unit));
    if (units.x.empty() && units.heights.empty()) {
        units.x = units.heights = required_unit(options, source);
        return units;
    }
    const bool one_missing = units.x.empty() || units.heights.empty();
    auto& missing = units.x.empty() ? units.x : units.heights;
    if (one_missing && options.unit) {
        missing = *options.unit;
        return units;
    }
    if (one_missing) {
        const auto* column = units.x.empty() ? "x" : "heights";
        missing = units.x.empty() ? units.heights : units.x;
        units.alerts.push_back({"UNIT_ASSUMED", source.name, fmt::format("the header states no unit for {}; taken as {} as in the other column", column, missing),
                                "compare the heights with what is known of the surface, or give --unit"});
    }
    if (options.unit && length_unit(*options.unit, source).factor != length_unit(units.heights, source).factor)
        units.alerts.push_back({"UNIT_MISMATCH", source.name, fmt::format("unit {} given, but the file says {}, which was used", *options.unit, units.heights),
                                "check the unit; correct the file's header where it is wrong"});
    return units;
}

/// "Stylus,Radius: 2.5 µm" in the header of Dektak files.
std::optional<double> stylus_radius(const std::vector<std::string>& header) {
    for (const auto& line : header) {
        const auto at = line.find("Radius:");
        if (!line.starts_with("Stylus") || at == std::string::npos) continue;
        try {
            return parse_quantity(trimmed(std::string_view(line).substr(at + 7)), dimension::length);
        } catch (const InvalidArgument&) {
            return std::nullopt;
        }
    }
    return std::nullopt;
}

void require_positions(const Array1D& x, const Source& source) {
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

constexpr std::uint64_t beyond_first_line = 64;

void require_two_points(const Profile& profile, const Source& source) {
    if (profile.positions.size() < 2)
        throw FormatError(source.name, {}, fmt::format("{} point, expected at least 2", profile.positions.size()));
}

/// One of setae's own: a profile, whatever its steps.
std::vector<Channel> open_profile(const Source& source) {
    auto profile = read_profile(source);
    require_positions(profile.positions, source);
    require_two_points(profile, source);
    ChannelInfo info;
    info.name = profile.metadata.name.empty() ? "h" : profile.metadata.name;
    info.format = "xy";
    info.unit = profile.metadata.unit;
    return {loaded_channel(std::move(info), checked(std::move(profile), source))};
}

Match detect_xy(std::string_view head, const Source&) {
    if (is_profile_file(head)) return Match::yes;
    return numeric_columns(head) > 0 ? Match::maybe : Match::no;
}

std::vector<Channel> open_xy(const Source& source, const ReadOptions& options) {
    if (is_profile_file(source.head(beyond_first_line))) return open_profile(source);
    const auto table = read_raw_table(source);
    const auto curve = pick_columns(table, source);
    const auto units = find_units(curve, options, source);
    require_positions(curve.x.values, source);
    const auto height_unit = length_unit(units.heights, source);
    Profile profile{curve.x.values * length_unit(units.x, source).factor, curve.heights.values * height_unit.factor, {}};
    profile.metadata.file = source.name;
    profile.metadata.format = "xy";
    profile.metadata.unit = height_unit.name;
    profile.metadata.name = curve.heights.name;
    profile.metadata.instrument.tip_radius = stylus_radius(table.header);
    if (profile.metadata.instrument.tip_radius) profile.metadata.instrument.type = "stylus";
    if (curve.standard_error) profile.standard_error = standard_errors(*curve.standard_error, source);

    ChannelInfo info;
    info.name = curve.heights.name;
    info.format = "xy";
    info.unit = height_unit.name;
    info.alerts = units.alerts;
    require_two_points(profile, source);
    return {loaded_channel(std::move(info), checked(to_measurement(std::move(profile)), source))};
}

}  // namespace

Format xy_format() {
    return {.identifier = "xy",
            .name = "two-column text",
            .extensions = ".txt .csv .asc .dat .hfm",
            .description = "x and height with any separator, decimal point or comma, header and units in it or given; equal steps give a line scan, others a profile as traced; also Dektak CSV, a third column 'valid' or 'standard_error', and setae's own profiles with the response of their trace",
            .heights = "values in the unit stated or given; empty cells and nan are undefined",
            .orientation = "",
            .reference = "no standard; the dialects stand in setae/io/table_file.hpp",
            .tested_on_real_files = true,
            .carries_scale = false,
            .detect = detect_xy,
            .open = open_xy};
}

}  // namespace setae::io
