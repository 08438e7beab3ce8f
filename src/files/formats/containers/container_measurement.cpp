// SPDX-License-Identifier: GPL-3.0-or-later
#include "container_measurement.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "container_index.hpp"
#include "format_list.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::formats {
namespace {

/// A measurement of the index, and access to its file.
struct MemberEntry {
    std::string name, member;
    bool squeezed = false;  ///< processed: scaled, filled and detrended already
    bool source = false;    ///< content of the original in another layout
    std::size_t channel = 0;
    std::optional<ContainerTopography::Channel> named;  ///< instead of the number
    double height_scale = 1.0;
    ReadOptions options;
    bool periodic = false;
    std::optional<topography::Trend> trend;
    topography::Instrument instrument;
    std::map<std::string, std::string> attributes;
    std::vector<Alert> alerts;
};

/// A field that was kept because it is invalid affects how a file is read: it is not skipped.
void require_understood(const ContainerTopography& topography) {
    if (topography.extra.empty()) return;
    const auto kept = nlohmann::json::parse(topography.extra);
    for (const char* key : {"datafile", "data_source", "channel", "size", "unit", "height_scale", "is_periodic"})
        if (kept.contains(key))
            throw InvalidArgument(
                fmt::format("the index gives {} as {:.80}, which does not have the form that the schema requires", key,
                            kept[key].dump()));
}

void choose_member(const ContainerTopography& topography, const bytes::Archive& archive, MemberEntry& entry) {
    const auto& datafile = topography.datafile;
    const auto &original = datafile.original, &squeezed = datafile.squeezed;
    if (original.empty() && squeezed.empty()) throw InvalidArgument("the index names no data file");
    if (!datafile.source.empty() && !original.empty() && archive.has(datafile.source)) {
        entry.source = true;
        entry.member = datafile.source;
        return;
    }
    const bool lost = !original.empty() && !archive.has(original);
    entry.squeezed = original.empty() || (lost && !squeezed.empty());
    entry.member = entry.squeezed ? squeezed : original;
    if (lost && entry.squeezed)
        entry.alerts.push_back(
            {"ORIGINAL_MISSING", original,
             "the container lacks this original; its processed copy was used, which is already scaled, "
             "filled and levelled",
             "ask the author of the container for the original"});
}

/// Sets the instrument of the index, with its ±; `file`: container of the instrument.
void take_instrument(const ContainerInstrument& instrument, const std::string& file, MemberEntry& entry) {
    const auto parameters = instrument.parameters.value_or(ContainerInstrument::Parameters{});
    entry.instrument.name = instrument.name;
    if (const auto radius = parameters.tip_radius ? parameters.tip_radius->estimate() : std::nullopt) {
        entry.instrument.tip_radius = radius->value;
        if (radius->uncertain()) entry.instrument.tip_radius_standard_error = radius->standard_error;
        else if (parameters.tip_radius_standard_error)
            entry.instrument.tip_radius_standard_error = parameters.tip_radius_standard_error->metres();
    }
    if (parameters.resolution) entry.instrument.resolution = parameters.resolution->metres();
    if (!parameters.height_calibration.empty()) entry.attributes["height_calibration"] = parameters.height_calibration;
    if (!parameters.lateral_calibration.empty())
        entry.attributes["lateral_calibration"] = parameters.lateral_calibration;
    if (!instrument.type.empty()) entry.attributes["instrument_type"] = instrument.type;
    entry.attributes["instrument_of_container"] =
        fmt::format("{} in {}", instrument.name.empty() ? "instrument" : instrument.name,
                    std::filesystem::path(file).filename().string());
}

MemberEntry entry_of(const ContainerTopography& topography, const std::string& surface, const bytes::Archive& archive,
                     const std::string& file) {
    require_understood(topography);
    MemberEntry entry;
    entry.name = topography.name;
    choose_member(topography, archive, entry);
    entry.channel = entry.squeezed ? 0
                    : entry.source ? topography.datafile.source_channel.value_or(0)
                                   : topography.data_source.value_or(0);
    if (!entry.squeezed && !entry.source && !topography.data_source) entry.named = topography.channel;
    entry.height_scale = topography.height_scale.value_or(1.0);
    if (!(entry.height_scale > 0.0) || !std::isfinite(entry.height_scale))
        throw FormatError(file, {},
                          fmt::format("{} / {}: height_scale {} of the index, expected above 0", surface,
                                      topography.name, entry.height_scale));
    if (!topography.unit.empty()) {
        entry.options.unit = topography.unit;
        const double factor = unit_factor(topography.unit, dimension::length);
        if (!topography.size.empty()) entry.options.size.emplace();
        for (const double size : topography.size) entry.options.size->push_back(size * factor);
    }
    entry.periodic = topography.is_periodic.value_or(false);
    entry.trend = trend_of(topography.detrend_mode);
    if (topography.instrument) take_instrument(*topography.instrument, file, entry);
    const std::pair<const char*, const std::string&> texts[] = {
        {"description", topography.description},
        {"measurement_date", topography.measurement_date},
        {"detrend_mode", topography.detrend_mode},
        {"fill_undefined_data_mode", topography.fill_undefined_data_mode}};
    for (const auto& [key, value] : texts)
        if (!value.empty()) entry.attributes[key] = value;
    entry.attributes["surface"] = surface;
    entry.attributes["member"] = entry.member;
    return entry;
}

void merge(const MemberEntry& entry, const std::string& container, topography::Metadata& metadata) {
    metadata.file = container;
    metadata.name = entry.name;
    if (!entry.instrument.name.empty()) metadata.instrument.name = entry.instrument.name;
    if (entry.instrument.tip_radius) {
        metadata.instrument.tip_radius = entry.instrument.tip_radius;
        metadata.instrument.tip_radius_standard_error = entry.instrument.tip_radius_standard_error;
    }
    if (entry.instrument.resolution) metadata.instrument.resolution = entry.instrument.resolution;
    for (const auto& [key, value] : entry.attributes) metadata.attributes[key] = value;
    if (metadata.acquisition_time.empty())
        if (const auto date = entry.attributes.find("measurement_date"); date != entry.attributes.end())
            metadata.acquisition_time = date->second;
}

/// A channel of a member with the scale of the index, if the format of the member defines none.
struct ScaledChannel {
    Channel channel;
    double factor = 1.0;
};

/// The channel with a name, or the only one with heights if programs use other names than setae.
std::size_t channel_of(const MemberEntry& entry, const std::vector<Channel>& channels, const bytes::Source& member) {
    if (!entry.named) {
        if (entry.channel < channels.size()) return entry.channel;
        throw FormatError(member.name, {},
                          fmt::format("no channel {}; the file has {}", entry.channel, channels.size()));
    }
    std::vector<std::size_t> of_heights;
    std::size_t before = 0;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (channels[i].info.is_height) of_heights.push_back(i);
        if (channels[i].info.name == entry.named->name && before++ == entry.named->occurrence.value_or(0)) return i;
    }
    if (of_heights.size() == 1) return of_heights.front();
    throw FormatError(member.name, {}, fmt::format("no channel '{}' among its {}", entry.named->name, channels.size()));
}

ScaledChannel open_member(const bytes::Archive& archive, const MemberEntry& entry) {
    const auto member = bytes::unpacked(archive.member(entry.member));
    const auto& format = detect_format(member);
    if (format.is_container)
        throw FormatError(member.name, {.offset = 0},
                          "a container within a container; extract it and open it separately");
    auto channels = open(member, format, entry.options);
    const bool scaled_already = format.carries_scale || entry.squeezed;
    return {std::move(channels[channel_of(entry, channels, member)]), scaled_already ? 1.0 : entry.height_scale};
}

topography::Measurement read_member(const bytes::Source& source, const MemberEntry& entry) {
    const bytes::Archive archive(source);
    const auto [channel, factor] = open_member(archive, entry);
    auto measurement = topography::scaled(channel.read(), factor);
    merge(entry, source.name, topography::metadata(measurement));
    std::visit(
        [&](auto& m) {
            if constexpr (requires { m.periodic; }) m.periodic = m.periodic || entry.periodic;
        },
        measurement);
    return measurement;
}

bool has_alert(const ChannelInfo& info, const char* code) {
    for (const auto& alert : info.alerts)
        if (alert.code == code) return true;
    return false;
}

/// Reports a unit of the index that differs from that of the file, which is used.
void compare_units(const MemberEntry& entry, const bytes::Source& source, ChannelInfo& info) {
    if (!entry.options.unit || info.unit.empty() || !info.is_height || has_alert(info, "UNIT_MISMATCH")) return;
    if (std::abs(length_unit(*entry.options.unit, source).factor / length_unit(info.unit, source).factor - 1.0) < 1e-12)
        return;
    info.alerts.push_back({"UNIT_MISMATCH", entry.name,
                           fmt::format("the index gives the unit {}, but the file gives {}, which was used",
                                       *entry.options.unit, info.unit),
                           "correct the index; sizes and heights are those of the unit in the file"});
}

Channel member_channel(const bytes::Source& source, const bytes::Archive& archive, const MemberEntry& entry) {
    auto opened = open_member(archive, entry);
    auto info = std::move(opened.channel.info);
    if (!entry.source) compare_units(entry, source, info);
    info.name = entry.name;
    merge(entry, source.name, info.metadata);
    info.recommended_trend = entry.trend;
    info.alerts.insert(info.alerts.end(), entry.alerts.begin(), entry.alerts.end());
    return {std::move(info), [source, entry] { return read_member(source, entry); }};
}

}  // namespace

std::optional<topography::Trend> trend_of(const std::string& detrend_mode) {
    if (detrend_mode == "height") return topography::Trend::tilt;
    if (detrend_mode == "curvature") return topography::Trend::parabola;
    if (detrend_mode == "center") return topography::Trend::mean;
    return std::nullopt;
}

bool repeats_scale(const bytes::Archive& archive, const ContainerTopography& topography) {
    const auto& original = topography.datafile.original;
    if (topography.height_scale.value_or(1.0) == 1.0 || original.empty() || !archive.has(original)) return false;
    try {
        return detect_format(archive.member(original)).carries_scale;
    } catch (const FormatError&) {
        return false;
    }
}

namespace {

/// @throws FormatError for instrument data with an invalid ±: the measurement is not read without it.
void require_statements(const bytes::Source& source, const bytes::Archive& archive,
                        const ContainerTopography& topography) {
    if (!topography.instrument || !topography.instrument->parameters) return;
    const auto& parameters = *topography.instrument->parameters;
    const auto require = [&](const char* key, const std::string& text, const Dimension& dimension) {
        if (text.empty()) return;
        try {
            (void)parse_uncertain_quantity(text, positive(dimension));
        } catch (const InvalidArgument& error) {
            const auto* name = archive.has(json_index) ? json_index : yaml_index;
            const auto index = archive.read(name);
            FilePosition position;
            if (const auto at = index.find(text); at != std::string::npos)
                position.line = 1 + std::count(index.begin(), index.begin() + static_cast<std::ptrdiff_t>(at), '\n');
            throw FormatError(fmt::format("{}: {}", source.name, name), position,
                              fmt::format("{}: {}", key, error.what()));
        }
    };
    if (parameters.tip_radius) require("tip_radius", parameters.tip_radius->text, dimension::length);
    require("height_calibration", parameters.height_calibration, dimension::none);
    require("lateral_calibration", parameters.lateral_calibration, dimension::none);
}

}  // namespace

Channel container_channel(const bytes::Source& source, const bytes::Archive& archive, const ContainerSurface& surface,
                          const ContainerTopography& topography, bool keep_values) {
    require_statements(source, archive, topography);
    try {
        auto entry = entry_of(topography, surface.name, archive, source.name);
        entry.options.keep_values = keep_values;
        return member_channel(source, archive, entry);
    } catch (const Error& error) {
        return unreadable_member(source, topography.name, error.what());
    }
}

}  // namespace setae::formats
