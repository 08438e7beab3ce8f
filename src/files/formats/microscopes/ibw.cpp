// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "igor_wave.hpp"
#include "probe_channels.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/force_curve_formats.hpp"

// Igor binary waves of Asylum Research (Oxford Instruments): a wave of x × y × channels whose labels along the third
// dimension are the names of the channels and whose note describes the scan. The wave has one unit for all channels,
// that of the heights; the units of the others follow from their names.
namespace setae::formats {
namespace {

constexpr std::uint64_t max_channels_of_ibw = 1000;

using Note = std::map<std::string, std::string, std::less<>>;

Note parsed_note(const std::string& text) {
    Note note;
    for (const auto line : bytes::split_lines(text)) {
        const auto colon = line.find(':');
        if (colon != std::string_view::npos)
            note.emplace(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
    }
    return note;
}

std::string entry(const Note& note, std::string_view key) {
    const auto found = note.find(key);
    return found == note.end() ? std::string() : found->second;
}

/// "NapPotentialTrace" and "PotentialRetraceMod0" are both of "Potential".
std::string quantity_of(std::string name) {
    const auto modulation = name.rfind("Mod");
    if (modulation != std::string::npos && name.find_first_not_of("0123456789", modulation + 3) == std::string::npos)
        name.resize(modulation);
    for (const std::string_view direction : {"Retrace", "Trace"})
        if (name.ends_with(direction)) name.resize(name.size() - direction.size());
    for (const std::string_view pass : {"DAC", "Nap"})
        if (name.starts_with(pass)) name.erase(0, pass.size());
    return name;
}

/// The unit of a channel of Asylum instruments: that in the note, otherwise that of the measured quantity; a voltage
/// for all others.
std::string asylum_unit(const std::string& name, const Note& note) {
    static constexpr std::pair<std::string_view, std::string_view> units[] = {
        {"Height", "m"},    {"ZSensor", "m"}, {"Deflection", "m"}, {"Amplitude", "m"},
        {"Phase", "deg"},   {"Current", "A"}, {"Frequency", "Hz"}, {"Capacitance", "F"},
        {"Potential", "V"}, {"Count", "1"},   {"QFactor", "1"}};
    const auto quantity = quantity_of(name);
    if (const auto noted = note.find(quantity + "Unit"); noted != note.end()) return noted->second;
    for (const auto& [prefix, unit] : units)
        if (quantity.starts_with(prefix)) return std::string(unit);
    return "V";
}

/// Igor counts seconds from 1904 in local time.
std::string date_of(std::uint32_t seconds) {
    using namespace std::chrono;
    const sys_seconds time = sys_days{year{1904} / January / 1} + std::chrono::seconds{seconds};
    const auto day = floor<days>(time);
    const year_month_day date{day};
    const hh_mm_ss clock{time - day};
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), clock.hours().count(),
                       clock.minutes().count(), clock.seconds().count());
}

topography::Metadata metadata_of(const IgorWave& wave, const Note& note, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "ibw";
    metadata.acquisition_time =
        entry(note, "Date").empty() ? "" : fmt::format("{} {}", entry(note, "Date"), entry(note, "Time"));
    if (metadata.acquisition_time.empty() && wave.created != 0) metadata.acquisition_time = date_of(wave.created);
    metadata.instrument.name = entry(note, "MicroscopeModel");
    if (!metadata.instrument.name.empty()) metadata.instrument.type = "afm";
    for (const auto& [key, attribute] : {std::pair{"ScanSize", "scan_size"},
                                         {"ScanAngle", "scan_angle"},
                                         {"ScanDown", "scan_down"},
                                         {"ImagingMode", "mode"},
                                         {"SpringConstant", "spring_constant"},
                                         {"Version", "software_version"},
                                         {"IgorFileVersion", "igor_version"}})
        if (const auto value = entry(note, key); !value.empty()) metadata.attributes[attribute] = value;
    if (!wave.name.empty()) metadata.attributes["wave"] = wave.name;
    return metadata;
}

/// Place of the numbers of one channel: points along x are contiguous, rows begin at the bottom.
Raster raster_of(const IgorWave& wave, std::uint64_t channel) {
    const auto nx = wave.points[0], ny = std::max<std::uint64_t>(wave.points[1], 1);
    return {.offset = wave.data_at + channel * nx * ny * bytes_of(wave.sample),
            .nx = static_cast<Index>(nx),
            .ny = static_cast<Index>(ny),
            .sample = wave.sample,
            .order = wave.order,
            .bottom_up = true};
}

/// Extent n · step if the wave states a unit of length; without a unit the steps of 1 are Igor's default.
std::vector<double> size_of(const IgorWave& wave, std::size_t dimensions, const bytes::Source& source) {
    std::vector<double> size;
    for (std::size_t k = 0; k < dimensions; ++k) {
        if (wave.units[k].empty()) return {};
        size.push_back(std::abs(wave.step[k]) * static_cast<double>(wave.points[k]) *
                       length_unit(wave.units[k], source).factor);
    }
    return size;
}

void require_topography(const IgorWave& wave, const bytes::Source& source) {
    const auto refuse = [&](const std::string& what) {
        throw FormatError(source.name, {.offset = wave.data_at}, "Igor: " + what);
    };
    if (tables::is_igor_force(source)) refuse("a force curve, not a topography; `setae jkr fit` reads it");
    if (wave.points[0] < 2) refuse(fmt::format("a wave of {} points", wave.count()));
    if (wave.points[3] > 1) refuse("a wave of four dimensions (a force volume or a movie), expected x, y and channels");
    if (wave.points[1] > 0 && wave.points[2] == 0 && !wave.labels[1].empty())
        refuse(
            fmt::format("curves of {} columns ('{}' is the first), not a map", wave.points[1], wave.labels[1].front()));
    if (wave.points[1] == 1) refuse("a map of one line");
    if (wave.points[2] > max_channels_of_ibw)
        refuse(fmt::format("a wave of {} layers, expected at most {} channels", wave.points[2], max_channels_of_ibw));
    for (std::size_t k = 0; k < 2; ++k)
        if (wave.points[k] > 0 && !wave.units[k].empty() && !holds_heights({}, wave.units[k]))
            refuse(fmt::format("a wave over '{}', expected a length along each direction of a surface", wave.units[k]));
}

std::string name_of(const IgorWave& wave, std::size_t channel) {
    const auto& labels = wave.labels[2];
    if (channel < labels.size() && !labels[channel].empty()) return labels[channel];
    return wave.points[2] > 1 ? fmt::format("{} {}", wave.name, channel) : wave.name;
}

Channel channel_of(const IgorWave& wave, const Note& note, std::size_t channel, ChannelInfo info,
                   const bytes::Source& source, const ReadOptions& options) {
    info.name = info.metadata.name = name_of(wave, channel);
    const bool asylum = note.contains("MicroscopeModel") && channel < wave.labels[2].size();
    info.unit = asylum ? asylum_unit(info.name, note) : plain_unit(wave.data_unit);
    // names show which channels are heights, the wave gives their unit
    if (holds_heights(info.name, info.unit) && holds_heights({}, wave.data_unit)) info.unit = wave.data_unit;
    if (info.name.find("Retrace") != std::string::npos || info.name.find("Trace") != std::string::npos)
        info.metadata.attributes["line_direction"] =
            info.name.find("Retrace") != std::string::npos ? "retrace" : "trace";
    const bool line = wave.points[1] == 0;
    info.shape = line ? std::vector{static_cast<Index>(wave.points[0])}
                      : std::vector{static_cast<Index>(wave.points[0]), static_cast<Index>(wave.points[1])};
    info.size = size_of(wave, info.shape.size(), source);
    if (!info.unit.empty() && !holds_heights(info.name, info.unit)) return non_height_channel(std::move(info));
    if (!line) info.orientation = "rows from the bottom, turned";
    const double metre = info.unit.empty() ? 1.0 : length_unit(info.unit, source).factor;
    return raster_channel(std::move(info), source, raster_of(wave, channel), {.factor = metre}, options);
}

Match detect_ibw(std::string_view head, const bytes::Source&) { return igor_order(head) ? Match::yes : Match::no; }

std::vector<Channel> open_ibw(const bytes::Source& source, const ReadOptions& options) {
    const auto wave = igor_wave(source);
    require_topography(wave, source);
    const auto note = parsed_note(wave.note);
    ChannelInfo common;
    common.format = "ibw";
    common.metadata = metadata_of(wave, note, source);
    std::vector<Channel> channels;
    const auto count = std::max<std::uint64_t>(wave.points[2], 1);
    for (std::uint64_t k = 0; k < count; ++k) channels.push_back(channel_of(wave, note, k, common, source, options));
    return channels;
}

}  // namespace

Format ibw_format() {
    return {
        .identifier = "ibw",
        .name = "Igor binary wave",
        .extensions = ".ibw",
        .description =
            "Asylum Research (Oxford Instruments) and Igor Pro: versions 5 (maps, one a channel) and 2 (lines), either byte order, with note and labels",
        .heights =
            "numbers in the wave's unit, NaN undefined; sizes are n times the distance of points as Igor scales waves: Asylum sets it to scan size over n − 1, so a map is n/(n − 1) scans wide",
        .orientation = "rows stored from the bottom, turned",
        .not_read =
            "channels that are not heights are listed, in the unit that their name implies; the preview "
            "after the wave; force curves (`setae jkr fit` reads them)",
        .reference =
            "WaveMetrics, Technical Note 3, Igor Binary Format; names of channels as Gwyddion's module igorfile takes them",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_ibw,
        .open = open_ibw};
}

}  // namespace setae::formats
