// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/force_curve.hpp"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/force_curve_formats.hpp"

namespace setae::tables {
namespace {

struct Reader {
    const char* identifier;
    bool (*detect)(const bytes::Source&);
    ForceCurveFile (*open)(const bytes::Source&);
};

/// A file of one curve, which has the number 0.
template <ForceCurveData (*read)(const bytes::Source&)>
ForceCurveFile one(const bytes::Source& source) {
    return {.numbers = {0}, .read = [source](long) { return read(source); }};
}

constexpr Reader readers[] = {{"jpk-force", is_jpk_force, one<read_jpk_force>},
                              {"jpk-force-map", is_jpk_map, open_jpk_map},
                              {"jpk-text", is_jpk_text, open_jpk_text},
                              {"nanoscope-force", is_nanoscope_force, open_nanoscope_force},
                              {"nanosurf-force", is_nanosurf_force, open_nanosurf_force},
                              {"afm-workshop", is_afm_workshop, one<read_afm_workshop>},
                              {"igor-force", is_igor_force, one<read_igor_force>},
                              {"nt-mdt", is_nt_mdt_text, one<read_nt_mdt_text>}};

void require_positive(const std::optional<double>& value, const char* name) {
    if (value && !(std::isfinite(*value) && *value > 0.0))
        throw InvalidArgument(fmt::format("{} = {}, expected a number > 0", name, *value));
}

Array1D joined(const std::vector<ForceSegment>& segments, Array1D ForceSegment::*series) {
    Index total = 0, at = 0;
    for (const auto& segment : segments) total += (segment.*series).size();
    Array1D all(total);
    for (const auto& segment : segments) {
        all.segment(at, (segment.*series).size()) = segment.*series;
        at += (segment.*series).size();
    }
    return all;
}

Array1D numbering(const std::vector<ForceSegment>& segments) {
    Array1D all(joined(segments, &ForceSegment::height).size());
    Index at = 0;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        all.segment(at, segments[k].height.size()) = static_cast<double>(k);
        at += segments[k].height.size();
    }
    return all;
}

/// Even steps within each segment, one after the other; empty if a duration is not known.
std::optional<Array1D> times(const std::vector<ForceSegment>& segments) {
    Array1D all(joined(segments, &ForceSegment::height).size());
    Index at = 0;
    double begin = 0.0;
    for (const auto& segment : segments) {
        if (!(segment.duration > 0.0)) return std::nullopt;
        const auto n = segment.height.size();
        for (Index i = 0; i < n; ++i)
            all[at + i] = begin + segment.duration * static_cast<double>(i) / static_cast<double>(n);
        at += n;
        begin += segment.duration;
    }
    return all;
}

/// Deflection [m]; empty if the constants it needs are not known.
std::optional<Array1D> deflection(const ForceCurveData& data, const Array1D& reading,
                                  const ForceCurveOptions& constants) {
    if (data.reading == Reading::deflection) return reading;
    const auto& factor = data.reading == Reading::force ? constants.spring_constant : constants.sensitivity;
    if (!factor) return std::nullopt;
    return data.reading == Reading::force ? Array1D(reading / *factor) : Array1D(reading * *factor);
}

std::string missing(const ForceCurveData& data, const ForceCurveOptions& constants) {
    std::vector<std::string> names;
    if (!constants.spring_constant) names.emplace_back("spring_constant");
    const bool needs_sensitivity = data.reading == Reading::volts || data.reading == Reading::amperes;
    if (needs_sensitivity && !constants.sensitivity) names.emplace_back("sensitivity");
    return fmt::format("{}", fmt::join(names, ", "));
}

Table table_of(const ForceCurveData& data, const ForceCurveOptions& constants) {
    const auto reading = joined(data.segments, &ForceSegment::reading);
    const auto height = joined(data.segments, &ForceSegment::height);
    const auto bent = deflection(data, reading, constants);
    Table table;
    if (const auto time = times(data.segments)) table.columns.push_back({"time", "s", *time});
    if (data.reading == Reading::force) table.columns.push_back({"force", "N", reading});
    else if (bent && constants.spring_constant)
        table.columns.push_back({"force", "N", *bent * *constants.spring_constant});
    if (bent) table.columns.push_back({"displacement", "m", height * data.travel_sign - *bent});
    table.columns.push_back({"height", "m", height});
    if (bent) table.columns.push_back({"deflection", "m", *bent});
    if (data.reading == Reading::volts || data.reading == Reading::amperes)
        table.columns.push_back({"reading", data.reading == Reading::volts ? "V" : "A", reading});
    table.columns.push_back({"segment", "1", numbering(data.segments)});
    return table;
}

/// The table with the metadata of the file and the options.
Table described_table(const ForceCurveData& data, const ForceCurveOptions& options, const std::string& name,
                      const char* format) {
    auto constants = data.constants;
    if (options.spring_constant) constants.spring_constant = options.spring_constant;
    if (options.sensitivity) constants.sensitivity = options.sensitivity;
    auto table = table_of(data, constants);
    table.metadata = data.metadata;
    table.metadata["file"] = name;
    table.metadata["format"] = format;
    if (constants.spring_constant)
        table.metadata["spring_constant"] = fmt::format("{} N/m", *constants.spring_constant);
    if (constants.sensitivity)
        table.metadata["sensitivity"] =
            fmt::format("{} {}", *constants.sensitivity, data.reading == Reading::amperes ? "m/A" : "m/V");
    if (const auto names = missing(data, constants); !names.empty()) table.metadata["missing"] = names;
    std::vector<std::string> segments;
    for (const auto& segment : data.segments) segments.push_back(segment.name);
    table.metadata["segments"] = fmt::format("{}", fmt::join(segments, ", "));
    return table;
}

}  // namespace

std::optional<std::array<Index, 2>> MapGrid::pixel(double place_x, double place_y) const {
    const double across = place_x - x, up = place_y - y, cosine = std::cos(angle), sine = std::sin(angle);
    const double column = std::floor((0.5 + (across * cosine + up * sine) / width) * static_cast<double>(columns)),
                 row = std::floor((0.5 - (up * cosine - across * sine) / height) * static_cast<double>(rows));
    if (!(column >= 0.0 && column < static_cast<double>(columns) && row >= 0.0 && row < static_cast<double>(rows)))
        return std::nullopt;
    return std::array{static_cast<Index>(column), static_cast<Index>(row)};
}

const std::vector<ForceCurveFormat>& force_curve_formats() {
    static const std::vector<ForceCurveFormat> formats{
        {"jpk-force", "JPK force curve", ".jpk-force .jpk-qi-series",
         "ZIP with a header of properties and a big-endian channel a file for each segment; conversions "
         "from converter to volts, metres and newtons are followed in the order the file names them",
         "JPK Instruments, data format of NanoWizard, version 0.x to 2", true},
        {"jpk-force-map", "JPK force map, QI data", ".jpk-force-map .jpk-qi-data",
         "ZIP with a force curve in each numbered folder of 'index'; places, grid and what the segments share from its "
         "headers",
         "JPK Instruments, data format of NanoWizard, version 2; Gwyddion's module jpkscan", true},
        {"jpk-text", "JPK text of force curves", ".txt",
         "text that JPK's data processing exports, with 'columns', 'units' and 'segment' for each segment, of one curve or "
         "several with their 'index'; measured height before the nominal one, deflection in N, m or V, spring constant and "
         "sensitivity from the header",
         "JPK Instruments, text export of the data processing, versions 3 to 6", false},
        {"nanoscope-force", "Nanoscope force curves, force volumes", ".spm .000 .001 .pfc",
         "Digital Instruments, Veeco, Bruker from version 4.3: header with 'Ciao force image list', the channel of deflection "
         "in volts by V/LSB, the height sensor or else the ramp in equal steps; approach and retraction from the deepest "
         "point outwards, curves of a volume line by line from the lower left; spring constant and sensitivity from the "
         "header",
         "Nanoscope 7 and 8 user guides; Gwyddion's module nanoscope; pyMFD's reader", false},
        {"nanosurf-force", "Nanosurf force curves", ".nid",
         "easyScan and later: sections of text, then integers; the channels Deflection and Z-Axis "
         "Sensor, else Z-Axis, of 'Spec forward', 'Spec backward' and the pauses, one line per curve; "
         "spring constant and sensitivity from the calibration, durations from the parameters of "
         "spectroscopy",
         "names of sections and keys as Nanosurf's Python package NSFopen 2.1 takes them", false},
        {"afm-workshop", "AFM Workshop force curve", ".csv",
         "text with 'Force-Distance Curve' in the first line; height and force or volts of extension, then of retraction",
         "files of AFM Workshop instruments, format 3", true},
        {"igor-force", "Asylum force curve", ".ibw",
         "Igor binary wave of version 5 with channels Defl and ZSnsr or Raw; segments by the note's Indexes, spring constant and InvOLS "
         "from the note",
         "WaveMetrics, Technical Note 3 (Igor binary format); names of channels as Asylum's software writes them",
         false},
        {"nt-mdt", "NT-MDT force curve", ".txt",
         "text that Nova exports: height, deflection of approach and of retraction, no header; nm and nA are assumed, constant padding is cut off",
         "files of NT-MDT Nova", true}};
    return formats;
}

double parse_sensitivity(std::string_view text) {
    const auto volt = parse_unit("V").dimension, ampere = parse_unit("A").dimension;
    try {
        return parse_quantity(text, dimension::length / volt);
    } catch (const InvalidArgument&) {
        return parse_quantity(text, dimension::length / ampere);
    }
}

std::optional<std::string> force_curve_format(const bytes::Source& source) {
    for (const auto& reader : readers)
        if (reader.detect(source)) return reader.identifier;
    return std::nullopt;
}

std::optional<std::string> stated_force_curve_format(const bytes::Source& source) {
    for (const auto& reader : readers)
        if (reader.detect != is_nt_mdt_text && reader.detect(source)) return reader.identifier;
    return std::nullopt;
}

ForceCurves open_force_curves(const bytes::Source& source, const ForceCurveOptions& options) {
    require_positive(options.spring_constant, "spring constant");
    require_positive(options.sensitivity, "sensitivity");
    for (const auto& reader : readers) {
        if (!reader.detect(source)) continue;
        const auto file = reader.open(source);
        return {.format = reader.identifier,
                .numbers = file.numbers,
                .grid = file.grid,
                .read = [read = file.read, options, name = source.name, format = reader.identifier](long number) {
                    const auto data = read(number);
                    return PlacedCurve{described_table(data, options, name, format), data.x, data.y};
                }};
    }
    throw FormatError(source.name, {},
                      "unknown kind of force curve; expected JPK, Nanoscope, Nanosurf, AFM Workshop, Asylum or NT-MDT "
                      "text; import tables with a mapping");
}

ForceCurves open_force_curves(const std::string& path, const ForceCurveOptions& options) {
    return open_force_curves(bytes::file_source(path), options);
}

Table read_force_curve(const bytes::Source& source, const ForceCurveOptions& options) {
    const auto curves = open_force_curves(source, options);
    if (curves.numbers.size() != 1)
        throw FormatError(
            source.name, {},
            fmt::format(
                "{} force curves, expected one; `setae jkr fit` fits all of them, `curve_number` selects one of "
                "{} to {}",
                curves.numbers.size(), curves.numbers.front(), curves.numbers.back()));
    return curves.read(curves.numbers.front()).table;
}

Table read_force_curve(const std::string& path, const ForceCurveOptions& options) {
    return read_force_curve(bytes::file_source(path), options);
}

}  // namespace setae::tables
