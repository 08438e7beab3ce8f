// SPDX-License-Identifier: GPL-3.0-or-later
#include "jpk_segment.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/tables/dialect.hpp"

namespace setae::tables {
namespace {

constexpr const char* deflection_channel = "vDeflection";

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

/// Empty for an unknown encoder.
std::optional<Encoder> encoder(std::string type) {
    if (type.ends_with("-limited")) type.resize(type.size() - 8);
    if (type == "signedshort") return Encoder{2, numbers<std::int16_t>};
    if (type == "unsignedshort") return Encoder{2, numbers<std::uint16_t>};
    if (type == "signedinteger") return Encoder{4, numbers<std::int32_t>};
    if (type == "unsignedinteger") return Encoder{4, numbers<std::uint32_t>};
    if (type == "signedlong") return Encoder{8, numbers<std::int64_t>};
    if (type == "unsignedlong") return Encoder{8, numbers<std::uint64_t>};
    if (type == "float" || type == "float-data") return Encoder{4, numbers<float>};
    if (type == "double" || type == "double-data") return Encoder{8, numbers<double>};
    return std::nullopt;
}

/// Value of KEY in a header, or by reference of NAME.N.KEY in the shared header, N at "HERE.NAME.*".
std::optional<std::string> referred(const Properties& own, const Properties& shared, const std::string& here,
                                    const char* name, const std::string& key) {
    const auto number = property(own, fmt::format("{}.{}.*", here, name));
    return number ? property(shared, fmt::format("{}.{}.{}", name, *number, key)) : std::nullopt;
}

}  // namespace

JpkSegment::JpkSegment(const JpkArchive& archive, std::string folder)
    : archive_(archive), folder_(std::move(folder)), own_(archive.properties(member())) {}

void JpkSegment::fail(const std::string& what) const {
    throw FormatError(archive_.source().name, {}, fmt::format("member '{}': {}", member(), what));
}

std::optional<std::string> JpkSegment::find(const std::string& key) const {
    constexpr const char* here = "force-segment-header";
    if (auto found = property(own_, fmt::format("{}.{}", here, key))) return found;
    return referred(own_, archive_.shared(), here, "force-segment-header-info", key);
}

std::optional<std::string> JpkSegment::of_channel(const std::string& channel, const std::string& key) const {
    const auto here = "channel." + channel;
    for (const char* place : {"", "data."})
        if (auto found = property(own_, fmt::format("{}.{}{}", here, place, key))) return found;
    return referred(own_, archive_.shared(), here, "lcd-info", key);
}

std::string JpkSegment::required(const std::string& channel, const std::string& key) const {
    auto found = of_channel(channel, key);
    if (!found) fail(fmt::format("channel '{}' has no '{}'", channel, key));
    return *found;
}

double JpkSegment::number(const std::string& text, const std::string& key) const {
    const auto value = spelled<double>(text);
    if (!value || !std::isfinite(*value)) fail(fmt::format("{} = '{:.40}' is not a number", key, text));
    return *value;
}

JpkSegment::Scaling JpkSegment::scaling(const std::string& channel, const std::string& prefix) const {
    const auto style = of_channel(channel, prefix + "scaling.style").value_or("offsetmultiplier");
    const auto type = of_channel(channel, prefix + "scaling.type").value_or("linear");
    if (style != "offsetmultiplier" || type != "linear")
        fail(fmt::format("channel '{}': scaling '{}' of style '{}' is not known, expected linear, offsetmultiplier",
                         channel, type, style));
    const auto value = [&](const char* name) {
        const auto key = prefix + "scaling." + name;
        return number(required(channel, key), key);
    };
    return {value("multiplier"), value("offset")};
}

/// Whether a channel is available in a slot, such as "force".
bool JpkSegment::defines(const std::string& channel, const std::string& slot) const {
    return of_channel(channel, fmt::format("conversion-set.conversion.{}.defined", slot)).value_or("false") == "true";
}

/// The conversions from the numbers of the file to a slot, in sequence.
JpkSegment::Scaling JpkSegment::chain(const std::string& channel, const std::string& slot) const {
    Scaling total;
    std::vector<std::string> seen;
    for (std::string at = slot; defines(channel, at);) {
        if (std::find(seen.begin(), seen.end(), at) != seen.end())
            fail(fmt::format("channel '{}': the conversions to '{}' form a loop", channel, slot));
        seen.push_back(at);
        const auto prefix = fmt::format("conversion-set.conversion.{}.", at);
        const auto step = scaling(channel, prefix);
        total = {total.multiplier * step.multiplier, total.multiplier * step.offset + total.offset};
        at = required(channel, prefix + "base-calibration-slot");
    }
    const auto base = of_channel(channel, "conversion-set.conversions.base").value_or("volts");
    if (seen.empty() && slot != base) fail(fmt::format("channel '{}' has no conversion '{}'", channel, slot));
    return total;
}

/// Numbers of a channel before conversions of its set: volts of the converter, or the stored floats.
Array1D JpkSegment::base_values(const std::string& channel) const {
    const auto type = of_channel(channel, "encoder.type").value_or(of_channel(channel, "type").value_or(""));
    const auto coder = encoder(type);
    if (!coder) fail(fmt::format("channel '{}' is encoded as '{}', which is not known", channel, type));
    const auto file = folder_ + required(channel, "file.name");
    const auto bytes = archive_.read(file);
    if (bytes.size() % coder->bytes != 0)
        throw FormatError(
            archive_.source().name, {},
            fmt::format("member '{}': {} bytes are not a whole number of values of {} bytes; it is truncated", file,
                        bytes.size(), coder->bytes));
    const auto values = coder->read(bytes);
    const Array1D raw = Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
    if (!of_channel(channel, "encoder.scaling.multiplier")) return raw;
    const auto step = scaling(channel, "encoder.");
    return raw * step.multiplier + step.offset;
}

Array1D JpkSegment::in_slot(const std::string& channel, const std::string& slot) const {
    const auto step = chain(channel, slot);
    return base_values(channel) * step.multiplier + step.offset;
}

/// The height measured by a sensor, otherwise the set value of the piezo, in the best calibrated slot.
JpkSegment::HeightChannel JpkSegment::found_height() const {
    const auto list = property(own_, "channels.list").value_or("");
    std::vector<std::string_view> there;
    split_cells(list, ' ', there);
    for (const char* name :
         {"strainGaugeHeight", "capacitiveSensorHeight", "measuredHeight", "height", "head-height"}) {
        if (std::find(there.begin(), there.end(), name) == there.end()) continue;
        const bool sensor = std::string_view(name) != "height" && std::string_view(name) != "head-height";
        for (const char* slot : {sensor ? "nominal" : "calibrated", sensor ? "calibrated" : "nominal", "absolute"})
            if (defines(name, slot)) return {name, slot};
    }
    fail(fmt::format("no channel of height in metres; the file has: {}", fmt::join(there, ", ")));
}

std::string JpkSegment::height_channel() const {
    const auto [name, slot] = found_height();
    return fmt::format("{}, slot {}", name, slot);
}

std::string JpkSegment::style() const {
    for (const char* key : {"settings.segment-settings.style", "settings.style"})
        if (const auto found = find(key)) return *found;
    return "segment";
}

ForceSegment JpkSegment::read() const {
    const auto [name, slot] = found_height();
    ForceSegment result{style(), in_slot(name, slot), base_values(deflection_channel)};
    if (result.height.size() != result.reading.size())
        fail(fmt::format("channels of different length: '{}' has {} values, '{}' {}", name, result.height.size(),
                         deflection_channel, result.reading.size()));
    if (const auto announced = property(own_, "force-segment-header.num-points")) {
        const auto points = number(*announced, "num-points");
        if (points != static_cast<double>(result.reading.size()))
            fail(fmt::format("{} values in channel '{}', but the header announces {}; the file is truncated",
                             result.reading.size(), deflection_channel, points));
    }
    if (const auto duration = find("duration")) result.duration = number(*duration, "duration");
    return result;
}

ForceCurveOptions JpkSegment::constants() const {
    ForceCurveOptions constants;
    if (defines(deflection_channel, "distance"))
        constants.sensitivity = chain(deflection_channel, "distance").multiplier;
    if (defines(deflection_channel, "force") && constants.sensitivity)
        constants.spring_constant = chain(deflection_channel, "force").multiplier / *constants.sensitivity;
    return constants;
}

}  // namespace setae::tables
