// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/archive.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/force_curve_formats.hpp"

namespace setae::tables {
namespace {

using Properties = std::map<std::string, std::string>;

/// Text of a Java properties file without its escapes.
std::string unescaped(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size()) ++i;
        result += text[i];
    }
    return result;
}

Properties parse_properties(const std::string& text) {
    Properties properties;
    for (auto line : bytes::split_lines(text)) {
        line = trimmed(line);
        const auto equal = line.find('=');
        if (line.empty() || line.front() == '#' || line.front() == '!' || equal == std::string_view::npos) continue;
        properties.insert_or_assign(unescaped(trimmed(line.substr(0, equal))),
                                    unescaped(trimmed(line.substr(equal + 1))));
    }
    return properties;
}

/// Properties of a segment, with those all segments share, and where they came from.
struct Segment {
    const bytes::Archive& archive;
    const bytes::Source& source;
    std::string folder;
    Properties own;
    const Properties& shared;

    [[nodiscard]] std::string member() const { return folder + "segment-header.properties"; }
    [[noreturn]] void fail(const std::string& what) const {
        throw FormatError(source.name, {}, fmt::format("member '{}': {}", member(), what));
    }

    [[nodiscard]] std::optional<std::string> find(const std::string& key) const {
        const auto found = own.find(key);
        return found == own.end() ? std::nullopt : std::optional(found->second);
    }

    /// channel.NAME.KEY, or what the segment says by reference: lcd-info.N.KEY of the shared header.
    [[nodiscard]] std::optional<std::string> of_channel(const std::string& channel, const std::string& key) const {
        for (const char* place : {"", "data."})
            if (auto found = find(fmt::format("channel.{}.{}{}", channel, place, key))) return found;
        const auto number = find(fmt::format("channel.{}.lcd-info.*", channel));
        if (!number) return std::nullopt;
        const auto found = shared.find(fmt::format("lcd-info.{}.{}", *number, key));
        return found == shared.end() ? std::nullopt : std::optional(found->second);
    }

    [[nodiscard]] std::string required(const std::string& channel, const std::string& key) const {
        auto found = of_channel(channel, key);
        if (!found) fail(fmt::format("channel '{}' has no '{}'", channel, key));
        return *found;
    }

    [[nodiscard]] double number(const std::string& text, const std::string& key) const {
        const auto value = spelled<double>(text);
        if (!value || !std::isfinite(*value)) fail(fmt::format("{} = '{:.40}' is no number", key, text));
        return *value;
    }
};

/// y = multiplier x + offset.
struct Scaling {
    double multiplier = 1.0, offset = 0.0;
};

Scaling scaling(const Segment& segment, const std::string& channel, const std::string& prefix) {
    const auto style = segment.of_channel(channel, prefix + "scaling.style").value_or("offsetmultiplier");
    const auto type = segment.of_channel(channel, prefix + "scaling.type").value_or("linear");
    if (style != "offsetmultiplier" || type != "linear")
        segment.fail(
            fmt::format("channel '{}': scaling '{}' of style '{}' is not known, expected linear, offsetmultiplier",
                        channel, type, style));
    const auto value = [&](const char* name) {
        const auto key = prefix + "scaling." + name;
        return segment.number(segment.required(channel, key), key);
    };
    return {value("multiplier"), value("offset")};
}

/// Whether a channel can be had in a slot, such as "force".
bool defines(const Segment& segment, const std::string& channel, const std::string& slot) {
    return segment.of_channel(channel, fmt::format("conversion-set.conversion.{}.defined", slot)).value_or("false") ==
           "true";
}

/// The conversions from the file's numbers up to a slot, one after the other.
Scaling chain(const Segment& segment, const std::string& channel, const std::string& slot) {
    Scaling total;
    std::vector<std::string> seen;
    for (std::string at = slot; defines(segment, channel, at);) {
        if (std::find(seen.begin(), seen.end(), at) != seen.end())
            segment.fail(fmt::format("channel '{}': the conversions to '{}' run in a circle", channel, slot));
        seen.push_back(at);
        const auto prefix = fmt::format("conversion-set.conversion.{}.", at);
        const auto step = scaling(segment, channel, prefix);
        total = {total.multiplier * step.multiplier, total.multiplier * step.offset + total.offset};
        at = segment.required(channel, prefix + "base-calibration-slot");
    }
    const auto base = segment.of_channel(channel, "conversion-set.conversions.base").value_or("volts");
    if (seen.empty() && slot != base) segment.fail(fmt::format("channel '{}' has no conversion '{}'", channel, slot));
    return total;
}

template <class Number>
std::vector<double> numbers(const std::string& bytes) {
    std::vector<double> values(bytes.size() / sizeof(Number));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<double>(bytes::load<Number>(bytes.data() + i * sizeof(Number), std::endian::big));
    return values;
}

/// Bytes of a number of an encoder, and the reader of them.
struct Encoder {
    std::size_t bytes = 0;
    std::vector<double> (*read)(const std::string&) = nullptr;
};

Encoder encoder(const Segment& segment, const std::string& channel) {
    auto type = segment.of_channel(channel, "encoder.type").value_or(segment.of_channel(channel, "type").value_or(""));
    if (type.ends_with("-limited")) type.resize(type.size() - 8);
    if (type == "signedshort") return {2, numbers<std::int16_t>};
    if (type == "unsignedshort") return {2, numbers<std::uint16_t>};
    if (type == "signedinteger") return {4, numbers<std::int32_t>};
    if (type == "unsignedinteger") return {4, numbers<std::uint32_t>};
    if (type == "signedlong") return {8, numbers<std::int64_t>};
    if (type == "unsignedlong") return {8, numbers<std::uint64_t>};
    if (type == "float" || type == "float-data") return {4, numbers<float>};
    if (type == "double" || type == "double-data") return {8, numbers<double>};
    segment.fail(fmt::format("channel '{}' is encoded as '{}', which setae does not know", channel, type));
}

/// A channel's numbers before any conversion of its set: volts of the converter, or what floats hold.
Array1D base_values(const Segment& segment, const std::string& channel) {
    const auto coder = encoder(segment, channel);
    auto file = segment.required(channel, "file.name");
    const auto bytes = segment.archive.read(segment.folder + file);
    if (bytes.size() % coder.bytes != 0)
        throw FormatError(
            segment.source.name, {},
            fmt::format("member '{}': {} bytes are no whole number of values of {} bytes; it is truncated",
                        segment.folder + file, bytes.size(), coder.bytes));
    const auto values = coder.read(bytes);
    const Array1D raw = Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
    if (!segment.of_channel(channel, "encoder.scaling.multiplier")) return raw;
    const auto step = scaling(segment, channel, "encoder.");
    return raw * step.multiplier + step.offset;
}

Array1D in_slot(const Segment& segment, const std::string& channel, const std::string& slot) {
    const auto step = chain(segment, channel, slot);
    return base_values(segment, channel) * step.multiplier + step.offset;
}

std::vector<std::string> channels(const Segment& segment) {
    const auto list = segment.find("channels.list").value_or("");
    std::vector<std::string_view> cells;
    split_cells(list, ' ', cells);
    return {cells.begin(), cells.end()};
}

/// The height a sensor measured, else what was asked of the piezo, in the slot that is best calibrated.
struct HeightChannel {
    std::string name, slot;
};

HeightChannel height_channel(const Segment& segment) {
    const auto there = channels(segment);
    for (const char* name :
         {"strainGaugeHeight", "capacitiveSensorHeight", "measuredHeight", "height", "head-height"}) {
        if (std::find(there.begin(), there.end(), name) == there.end()) continue;
        const bool sensor = std::string_view(name) != "height" && std::string_view(name) != "head-height";
        for (const char* slot : {sensor ? "nominal" : "calibrated", sensor ? "calibrated" : "nominal", "absolute"})
            if (defines(segment, name, slot)) return {name, slot};
    }
    segment.fail(fmt::format("no channel of height in metres, it has: {}", fmt::join(there, ", ")));
}

/// Numbers of the folders "segments/N/", in order.
std::vector<std::string> segment_folders(const bytes::Archive& archive) {
    std::map<long, std::string> folders;
    for (const auto& name : archive.names()) {
        constexpr std::string_view begin = "segments/", end = "/segment-header.properties";
        if (!name.starts_with(begin) || !name.ends_with(end) || name.size() < begin.size() + end.size()) continue;
        const auto digits = std::string_view(name).substr(begin.size(), name.size() - begin.size() - end.size());
        if (const auto number = spelled<long>(digits))
            folders.emplace(*number, name.substr(0, name.size() - end.size() + 1));
    }
    std::vector<std::string> result;
    for (const auto& [number, folder] : folders) result.push_back(folder);
    return result;
}

std::string style(const Segment& segment) {
    for (const char* key :
         {"force-segment-header.settings.segment-settings.style", "force-segment-header.settings.style"})
        if (const auto found = segment.find(key)) return *found;
    return "segment";
}

ForceSegment read_segment(const Segment& segment) {
    const auto height = height_channel(segment);
    ForceSegment result{style(segment), in_slot(segment, height.name, height.slot),
                        base_values(segment, "vDeflection")};
    if (result.height.size() != result.reading.size())
        segment.fail(fmt::format("channels of different length: '{}' has {} values, 'vDeflection' {}", height.name,
                                 result.height.size(), result.reading.size()));
    if (const auto announced = segment.find("force-segment-header.num-points")) {
        const auto points = segment.number(*announced, "num-points");
        if (points != static_cast<double>(result.reading.size()))
            segment.fail(
                fmt::format("{} values in channel 'vDeflection', the header announces {}; the file is truncated",
                            result.reading.size(), points));
    }
    if (const auto duration = segment.find("force-segment-header.duration"))
        result.duration = segment.number(*duration, "duration");
    return result;
}

/// Sensitivity and spring constant from the conversions to "distance" and "force".
ForceCurveOptions constants_of(const Segment& segment) {
    ForceCurveOptions constants;
    const std::string channel = "vDeflection";
    if (defines(segment, channel, "distance")) constants.sensitivity = chain(segment, channel, "distance").multiplier;
    if (defines(segment, channel, "force") && constants.sensitivity)
        constants.spring_constant = chain(segment, channel, "force").multiplier / *constants.sensitivity;
    return constants;
}

void add_metadata(const Segment& segment, ForceCurveData& data) {
    const auto height = height_channel(segment);
    data.metadata.emplace("height_channel", fmt::format("{}, slot {}", height.name, height.slot));
    if (const auto stamp = segment.find("force-segment-header.time-stamp")) data.metadata.emplace("date", *stamp);
    for (const char* axis : {"x", "y"})
        if (const auto at = segment.find(fmt::format("force-segment-header.position.{}", axis)))
            data.metadata.emplace(fmt::format("position_{}", axis), *at + " m");
}

}  // namespace

bool is_jpk_force(const bytes::Source& source) {
    if (!bytes::is_zip(source.head(4))) return false;
    const bytes::Archive archive(source);
    if (!archive.has("header.properties") || segment_folders(archive).empty()) return false;
    const auto properties = parse_properties(archive.read("header.properties"));
    const auto kind = properties.find("jpk-data-file");
    return kind != properties.end() && kind->second == "spm-forcefile";
}

ForceCurveData read_jpk_force(const bytes::Source& source) {
    const bytes::Archive archive(source);
    const auto header = parse_properties(archive.read("header.properties"));
    Properties shared;
    if (archive.has("shared-data/header.properties"))
        shared = parse_properties(archive.read("shared-data/header.properties"));
    ForceCurveData data;
    data.reading = Reading::volts;
    data.travel_sign = -1.0;
    for (const auto& [key, value] : header)
        for (const char* wanted : {"instrument", "probe", "comment", "source-software"})
            if (key == fmt::format("force-scan-series.description.{}", wanted) && !value.empty())
                data.metadata.emplace(wanted, value);
    for (const auto& folder : segment_folders(archive)) {
        const Segment segment{archive, source, folder,
                              parse_properties(archive.read(folder + "segment-header.properties")), shared};
        data.segments.push_back(read_segment(segment));
        if (data.segments.size() == 1) data.constants = constants_of(segment);
        add_metadata(segment, data);
    }
    return data;
}

}  // namespace setae::tables
