// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/force_curve_formats.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/nanosurf_header.hpp"
#include "setae/tables/text_head.hpp"

namespace setae::tables {
namespace {

/// A segment of each curve: the frame in the names of its channels, its name in setae, the parameter with its duration.
struct Phase {
    const char* frame;
    const char* name;
    const char* duration;
};
constexpr std::array<Phase, 4> nanosurf_phases{{{"Spec forward", "extend", "FwModTime"},
                                                {"Spec fwd pause", "pause", "FwPauseTime"},
                                                {"Spec backward", "retract", "BwModTime"},
                                                {"Spec bwd pause", "pause", "BwPauseTime"}}};

/// A channel of all curves: one line per curve.
struct CurveChannel {
    TextSection section;
    NanosurfIntegers integers;
    std::uint64_t at = 0;  ///< its first byte
    double factor = 1.0;   ///< from Dim2Unit to SI
};

struct NanosurfPhase {
    std::string name;
    CurveChannel height, deflection;
    double duration = 0.0;  ///< [s]; 0 if unknown
};

struct NanosurfCurves {
    TextSections sections;
    std::vector<NanosurfPhase> phases;
    Reading reading = Reading::deflection;
    ForceCurveOptions constants;
    std::vector<std::array<double, 2>> places;
};

const TextSection& section_named(const TextSections& sections, std::string_view name) {
    static const TextSection empty;
    const auto found = sections.find(name);
    return found == sections.end() ? empty : found->second;
}

/// The number of "D[48]*[N/m]" in SI if its unit has the wanted dimension.
std::optional<double> number_in_brackets(const std::string& text, const Dimension& wanted) {
    const auto middle = text.find("]*[");
    const auto begin = text.find('[');
    if (middle == std::string::npos || begin >= middle || !text.ends_with(']')) return std::nullopt;
    const auto value = spelled<double>(std::string_view(text).substr(begin + 1, middle - begin - 1));
    const auto unit = try_parse_unit(std::string_view(text).substr(middle + 3, text.size() - middle - 4));
    if (!value || !std::isfinite(*value) || !unit || unit->dimension != wanted) return std::nullopt;
    return *value * unit->factor;
}

/// The first property of the cantilever that is a stiffness.
std::optional<double> spring_constant_of(const TextSections& sections) {
    for (const auto& [key, value] : section_named(sections, "DataSet\\Calibration\\Cantilever"))
        if (key.starts_with("Prop"))
            if (const auto found = number_in_brackets(value, dimension::stiffness); found && *found > 0.0) return found;
    return std::nullopt;
}

/// [m/V] of the detector: an input "5,TipSignalDC,Deflection,m,2.8e-07,0" is the value of 10 V.
std::optional<double> sensitivity_of(const TextSections& sections) {
    for (const auto& [key, value] : section_named(sections, "DataSet\\Calibration\\Scanhead")) {
        std::vector<std::string_view> cells;
        split_cells(value, ',', cells);
        if (!key.starts_with("In") || cells.size() < 5 || cells[1] != "TipSignalDC" || cells[3] != "m") continue;
        const auto at_ten_volts = spelled<double>(cells[4]);
        if (at_ten_volts && *at_ten_volts > 0.0 && std::isfinite(*at_ten_volts)) return *at_ten_volts / 10.0;
    }
    return std::nullopt;
}

/// Positions of the curves: "x;y;…" in metres for each; NaN if unknown.
std::vector<std::array<double, 2>> places_of(const TextSections& sections, std::uint64_t lines) {
    std::vector<std::array<double, 2>> places(lines, {undefined, undefined});
    const std::string root = "DataSet\\SpecInfos";
    const auto& infos = section_named(sections, root);
    const auto& mode = section_named(sections, root + "\\" + text_entry(infos, "SubSection0"));
    const auto& list = section_named(sections, root + "\\" + text_entry(infos, "SubSection1"));
    const auto prefix = text_entry(mode, "SpecMode").substr(0, 3);
    for (std::uint64_t k = 0; k < lines; ++k) {
        std::vector<std::string_view> cells;
        const auto entry = text_entry(list, fmt::format("{}{}", prefix, k));
        split_cells(entry, ';', cells);
        if (cells.size() < 2) continue;
        const auto x = spelled<double>(trimmed(cells[0])), y = spelled<double>(trimmed(cells[1]));
        if (x && y && std::isfinite(*x) && std::isfinite(*y)) places[k] = {*x, *y};
    }
    return places;
}

/// Quantity of the values of a channel by its Dim2Unit; empty for another dimension.
std::optional<Reading> reading_of(const Unit& unit) {
    if (unit.dimension == dimension::length) return Reading::deflection;
    if (unit.dimension == dimension::force) return Reading::force;
    if (unit.dimension == parse_unit("V").dimension) return Reading::volts;
    return std::nullopt;
}

/// All channels of spectroscopy by frame and name, each with the offset of its bytes.
std::map<std::pair<std::string, std::string>, CurveChannel> curve_channels(const TextSections& sections,
                                                                           std::uint64_t at,
                                                                           const bytes::Source& source) {
    std::map<std::pair<std::string, std::string>, CurveChannel> channels;
    for (const auto& place : nanosurf_channels(sections, source)) {
        const auto& section = section_named(sections, place.section);
        if (section.empty()) continue;
        const auto integers = nanosurf_integers(section, source);
        if (integers.bytes() > source.size || at > source.size - integers.bytes())
            throw FormatError(
                source.name, {.offset = source.size},
                fmt::format(
                    "Nanosurf: the file ends here, but channel '{}' needs {} bytes from byte {}; it is truncated",
                    text_entry(section, "Dim2Name"), integers.bytes(), at));
        const auto unit = try_parse_unit(text_entry(section, "Dim2Unit"));
        if (const auto frame = text_entry(section, "Frame"); frame.starts_with("Spec") && unit)
            channels.emplace(std::pair{frame, text_entry(section, "Dim2Name")},
                             CurveChannel{section, integers, at, unit->factor});
        at += integers.bytes();
    }
    return channels;
}

/// The phases with height and deflection. @throws FormatError if they do not match.
NanosurfCurves curves_of(const bytes::Source& source) {
    const auto head = nanosurf_head(source);
    NanosurfCurves curves{.sections = nanosurf_sections(head)};
    const auto channels = curve_channels(curves.sections, head.size() + last_nanosurf_line.size(), source);
    const auto& times = section_named(curves.sections, "DataSet\\Parameters\\Spectroscopy");
    for (const auto& phase : nanosurf_phases) {
        const auto named = [&](const char* name) { return channels.find({phase.frame, name}); };
        auto height = named("Z-Axis Sensor");
        if (height == channels.end()) height = named("Z-Axis");
        const auto deflection = named("Deflection");
        if (height == channels.end() || deflection == channels.end()) continue;
        const auto unit = parse_unit(text_entry(deflection->second.section, "Dim2Unit"));
        const auto reading = reading_of(unit);
        const bool metres = parse_unit(text_entry(height->second.section, "Dim2Unit")).dimension == dimension::length;
        if (!reading || !metres) continue;
        if (height->second.integers.lines != deflection->second.integers.lines ||
            height->second.integers.points != deflection->second.integers.points ||
            (!curves.phases.empty() && (curves.phases.front().height.integers.lines != height->second.integers.lines ||
                                        curves.reading != *reading)))
            throw FormatError(
                source.name, {.offset = 0},
                fmt::format("Nanosurf: the channels of '{}' differ in points, curves or units", phase.frame));
        curves.reading = *reading;
        curves.phases.push_back({phase.name, height->second, deflection->second,
                                 number_in_brackets(text_entry(times, phase.duration), dimension::time).value_or(0.0)});
    }
    if (curves.phases.empty()) return curves;
    curves.constants = {spring_constant_of(curves.sections), sensitivity_of(curves.sections)};
    curves.places = places_of(curves.sections, curves.phases.front().height.integers.lines);
    return curves;
}

double stored_integer(const char* from, const NanosurfIntegers& stored) {
    const auto order = stored.big_endian ? std::endian::big : std::endian::little;
    if (stored.bits == 8)
        return stored.is_signed ? bytes::load<std::int8_t>(from, order) : bytes::load<std::uint8_t>(from, order);
    if (stored.bits == 16)
        return stored.is_signed ? bytes::load<std::int16_t>(from, order) : bytes::load<std::uint16_t>(from, order);
    return stored.is_signed ? bytes::load<std::int32_t>(from, order) : bytes::load<std::uint32_t>(from, order);
}

/// The measured values of a curve.
Array1D line_of(const CurveChannel& channel, std::uint64_t line, const bytes::Source& source) {
    const auto& stored = channel.integers;
    const auto measured = spelled<std::uint64_t>(text_entry(channel.section, fmt::format("LineDim{}Points", line)));
    const auto points = std::min(measured.value_or(stored.points), stored.points);
    const auto width = static_cast<std::uint64_t>(stored.bits / 8);
    const auto bytes = source.bytes(channel.at + line * stored.points * width, points * width);
    Array1D values(static_cast<Index>(points));
    for (std::uint64_t i = 0; i < points; ++i)
        values[static_cast<Index>(i)] =
            channel.factor * (stored.factor * stored_integer(bytes.data() + i * width, stored) + stored.offset);
    return values;
}

/// −1 if heights decrease on approach.
double travel_sign_of(const std::vector<ForceSegment>& segments) {
    for (const auto& segment : segments) {
        if (segment.name == "pause") continue;
        const double way = segment.height[segment.height.size() - 1] - segment.height[0];
        return (way < 0.0) == (segment.name == "extend") ? -1.0 : 1.0;
    }
    return 1.0;
}

ForceCurveData read_nanosurf_curve(const NanosurfCurves& curves, std::uint64_t line, const bytes::Source& source) {
    ForceCurveData data;
    data.reading = curves.reading;
    data.constants = curves.constants;
    data.x = curves.places[line][0];
    data.y = curves.places[line][1];
    for (const auto& phase : curves.phases) {
        const auto height = line_of(phase.height, line, source), reading = line_of(phase.deflection, line, source);
        const auto count = std::min(height.size(), reading.size());
        if (count > 0) data.segments.push_back({phase.name, height.head(count), reading.head(count), phase.duration});
    }
    if (data.segments.empty())
        throw FormatError(source.name, {.offset = 0}, fmt::format("Nanosurf: curve {} has no points", line));
    data.travel_sign = travel_sign_of(data.segments);
    data.metadata["height_channel"] = text_entry(curves.phases.front().height.section, "Dim2Name");
    const auto& about = section_named(curves.sections, "DataSet-Info");
    if (const auto date = text_entry(about, "Date"); !date.empty()) data.metadata["date"] = date;
    if (const auto name = text_entry(about, "Cantilever type"); !name.empty()) data.metadata["probe"] = name;
    for (const auto& [axis, value] : {std::pair{"position_x", data.x}, {"position_y", data.y}})
        if (std::isfinite(value)) data.metadata[axis] = fmt::format("{} m", value);
    return data;
}

}  // namespace

bool is_nanosurf_force(const bytes::Source& source) {
    if (!is_nanosurf(source.head(bytes::detection_bytes))) return false;
    const auto sections = nanosurf_sections(source.head(longest_text_head));
    for (const auto& [name, section] : sections)
        if (text_entry(section, "Frame").starts_with("Spec") && text_entry(section, "Dim2Name") == "Deflection")
            return true;
    return false;
}

ForceCurveFile open_nanosurf_force(const bytes::Source& source) {
    const auto curves = std::make_shared<const NanosurfCurves>(curves_of(source));
    if (curves->phases.empty())
        throw FormatError(source.name, {.offset = 0},
                          "Nanosurf: no part of the spectroscopy has a Z-Axis in metres together with a Deflection in "
                          "metres, newtons or volts");
    ForceCurveFile file;
    for (std::size_t line = 0; line < curves->places.size(); ++line) file.numbers.push_back(static_cast<long>(line));
    file.read = [curves, source](long number) {
        return read_nanosurf_curve(*curves, static_cast<std::uint64_t>(number), source);
    };
    return file;
}

}  // namespace setae::tables
