// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/force_curve_formats.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::tables {
namespace {

constexpr std::string_view workshop_mark = "Force-Distance Curve";

/// A column in SI. @throws FormatError for a unit that is missing or of another dimension.
Array1D in_si(const RawTable::RawColumn& column, const Dimension& expected, const bytes::Source& source) {
    const auto unit = try_parse_unit(column.unit);
    if (!unit || unit->dimension != expected)
        throw FormatError(source.name, {},
                          fmt::format("column '{}' has the unit '{}', expected one of {}", column.name, column.unit,
                                      si_unit(expected)));
    return column.values * unit->factor;
}

/// A segment without the rows in which both are undefined: the shorter branch is padded with empty cells.
ForceSegment segment_of(const char* name, const Array1D& height, const Array1D& reading, const bytes::Source& source) {
    Index rows = height.size();
    while (rows > 0 && std::isnan(height[rows - 1]) && std::isnan(reading[rows - 1])) --rows;
    for (Index i = 0; i < rows; ++i)
        if (std::isnan(height[i]) || std::isnan(reading[i]))
            throw FormatError(source.name, {},
                              fmt::format("channels of different length: row {} of the {} branch has only {}", i + 1,
                                          name, std::isnan(height[i]) ? "a force" : "a height"));
    if (rows == 0) throw FormatError(source.name, {}, fmt::format("the {} branch has no numbers", name));
    return {name, height.head(rows), reading.head(rows), 0.0};
}

/// Value after "key:" among the header lines.
std::optional<std::string> entry(const RawTable& table, std::string_view key) {
    for (const auto& line : table.header) {
        const auto colon = line.find(':', key.size());
        if (line.starts_with(key) && colon != std::string::npos)
            return std::string(trimmed(std::string_view(line).substr(colon + 1)));
    }
    return std::nullopt;
}

/// A calibration in the header, which is 1 if it was not entered.
std::optional<double> calibration(const RawTable& table, std::string_view key) {
    const auto text = entry(table, key);
    double value = 0.0;
    if (!text || !parse_cell(*text, '.', value) || !(value > 0.0) || value == 1.0) return std::nullopt;
    return value;
}

Dimension volts() { return parse_unit("V").dimension; }

Reading kind_of(const RawTable::RawColumn& column, const bytes::Source& source) {
    const auto unit = try_parse_unit(column.unit);
    if (unit && unit->dimension == dimension::force) return Reading::force;
    if (unit && unit->dimension == dimension::length) return Reading::deflection;
    if (unit && unit->dimension == volts()) return Reading::volts;
    throw FormatError(
        source.name, {},
        fmt::format("column '{}' has the unit '{}', expected one of force, length or volts", column.name, column.unit));
}

Dimension dimension_of(Reading reading) {
    return reading == Reading::force ? dimension::force : reading == Reading::deflection ? dimension::length : volts();
}

/// The three columns of Nova's text, or empty.
std::optional<RawTable> nova_table(const bytes::Source& source) {
    if (!bytes::looks_like_text(source.head(bytes::detection_bytes)) ||
        numeric_columns(source.head(bytes::detection_bytes)) != 3)
        return std::nullopt;
    auto table = read_raw_table(source);
    if (!table.header.empty() || table.columns.size() != 3) return std::nullopt;
    const auto& height = table.columns[0].values;
    if (height.size() < 3 || !height.isFinite().all()) return std::nullopt;
    for (Index i = 1; i < height.size(); ++i)
        if (height[i] <= height[i - 1]) return std::nullopt;
    return table;
}

/// First row after the constant readings at the beginning of an export.
Index after_padding(const Array1D& reading) {
    Index i = 1;
    while (i < reading.size() && reading[i] == reading[0]) ++i;
    return i - 1;
}

}  // namespace

bool is_afm_workshop(const bytes::Source& source) {
    const auto head = source.head(256);
    return bytes::looks_like_text(head) &&
           trimmed(bytes::decoded(head, bytes::Encoding::latin1)).starts_with(workshop_mark);
}

ForceCurveData read_afm_workshop(const bytes::Source& source) {
    const auto table = read_raw_table(source, {.separator = ',', .decimal_point = '.'});
    if (table.columns.size() != 4 || table.columns.front().name.empty())
        throw FormatError(source.name, {},
                          fmt::format("{} columns, expected four: height and force of extension, then of retraction",
                                      table.columns.size()));
    ForceCurveData data;
    data.reading = kind_of(table.columns[1], source);
    const auto dimension = dimension_of(data.reading);
    const auto si = [&](std::size_t k, const Dimension& expected) { return in_si(table.columns[k], expected, source); };
    data.segments.push_back(segment_of("extend", si(0, dimension::length), si(1, dimension), source));
    data.segments.push_back(segment_of("retract", si(2, dimension::length), si(3, dimension), source));
    if (const auto gain = calibration(table, "Light Lever Gain, mV/nm")) data.constants.sensitivity = 1e-6 / *gain;
    data.constants.spring_constant = calibration(table, "Force Constant, nN/nm");
    for (const auto& [key, name] : {std::pair{"Date", "date"},
                                    {"Time", "time_of_day"},
                                    {"Mode", "mode"},
                                    {"Point", "point"},
                                    {"X, um", "position_x"},
                                    {"Y, um", "position_y"}})
        if (const auto value = entry(table, key))
            data.metadata.emplace(name, std::string_view(key).ends_with("um") ? *value + " um" : *value);
    return data;
}

bool is_nt_mdt_text(const bytes::Source& source) {
    try {
        return nova_table(source).has_value();
    } catch (const FormatError&) {
        return false;
    }
}

ForceCurveData read_nt_mdt_text(const bytes::Source& source) {
    const auto table = nova_table(source);
    if (!table)
        throw FormatError(
            source.name, {},
            "expected three columns without names: height, deflection of approach, deflection of retraction");
    constexpr double nano = 1e-9;
    const Array1D height = table->columns[0].values * nano;
    const auto branch = [&](std::size_t k) {
        const Array1D& reading = table->columns[k].values;
        if (!reading.isFinite().all())
            throw FormatError(source.name, {}, fmt::format("column {} has undefined values", k + 1));
        const auto first = after_padding(reading);
        if (first + 1 == reading.size())
            throw FormatError(source.name, {},
                              fmt::format("column {} is constant, so that the table is not a force curve", k + 1));
        const auto count = reading.size() - first;
        return std::pair<Array1D, Array1D>(height.tail(count), reading.tail(count) * nano);
    };
    const auto approach = branch(1), retraction = branch(2);
    ForceCurveData data;
    data.reading = Reading::amperes;
    data.travel_sign = -1.0;
    data.segments.push_back({"extend", approach.first.reverse(), approach.second.reverse(), 0.0});
    data.segments.push_back({"retract", retraction.first, retraction.second, 0.0});
    data.metadata["units"] = "nm and nA were assumed: the file states no units";
    return data;
}

}  // namespace setae::tables
