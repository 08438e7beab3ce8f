// SPDX-License-Identifier: GPL-3.0-or-later
#include "channel_building.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"

namespace setae::formats {

using topography::HeightMap;
using topography::LineScan;
using topography::Measurement;
using topography::Profile;

namespace {

std::vector<double> size_of(const HeightMap& map) { return {map.size[0], map.size[1]}; }
std::vector<double> size_of(const LineScan& scan) { return {scan.size}; }
std::vector<double> size_of(const Profile& profile) {
    return {std::abs(profile.positions[profile.positions.size() - 1] - profile.positions[0])};
}

const char* size_example(const ChannelInfo& info) { return info.shape.size() == 2 ? "\"1 mm x 1 mm\"" : "\"1 mm\""; }

void make_infinite_undefined(double* heights, Index count) {
    for (Index i = 0; i < count; ++i)
        if (!std::isfinite(heights[i])) heights[i] = undefined;
}

/// Between the size of a nucleus and a million kilometres: a step of 1e-300 in a header is a mistake of the header.
bool is_extent(double length) {
    constexpr double smallest = 1e-15, largest = 1e9;  // m
    return length >= smallest && length <= largest;
}

bool any_defined(const double* heights, Index count) {
    return std::any_of(heights, heights + count, [](double height) { return !std::isnan(height); });
}

}  // namespace

std::vector<double> extent(const Measurement& measurement) {
    return std::visit([](const auto& m) { return size_of(m); }, measurement);
}

std::vector<Index> channel_shape(const Measurement& measurement) {
    const auto [nx, ny] = topography::shape(measurement);
    if (std::holds_alternative<HeightMap>(measurement)) return {nx, ny};
    return {nx};
}

Channel loaded_channel(ChannelInfo info, Measurement measurement) {
    info.shape = channel_shape(measurement);
    info.size = extent(measurement);
    info.metadata = topography::metadata(measurement);
    const auto shared = std::make_shared<const Measurement>(std::move(measurement));
    return {std::move(info), [shared] { return *shared; }};
}

void read_as_a_whole(Channel& channel, std::function<topography::Measurement()> read) {
    channel.read = std::move(read);
    channel.lines = {};
}

Channel non_height_channel(ChannelInfo info, const std::string& reason) {
    info.is_height = false;
    info.not_heights = reason;
    auto message = fmt::format("{}: channel '{}' is not heights{}", info.metadata.file, info.name,
                               reason.empty() ? "" : ": " + reason);
    return {std::move(info), [message]() -> Measurement { throw InvalidArgument(message); }};
}

Channel doubtful_channel(Channel channel, const std::string& reason) {
    channel.info.is_height = false;
    channel.info.not_heights = reason;
    return channel;
}

Channel unreadable_member(const bytes::Source& source, const std::string& name, const std::string& reason) {
    ChannelInfo info;
    info.name = name;
    info.is_height = false;
    info.metadata.file = source.name;
    info.metadata.name = name;
    info.alerts.push_back(
        {"UNREADABLE_MEMBER", name, reason, "the other measurements are not affected; repair or replace this one"});
    return {std::move(info), [error = std::current_exception()]() -> Measurement { std::rethrow_exception(error); }};
}

void require_measurement(const Measurement& measurement, const bytes::Source& source) {
    const auto points = topography::shape(measurement);
    const bool is_map = std::holds_alternative<HeightMap>(measurement);
    if (points[0] < 2 || (is_map && points[1] < 2))
        throw FormatError(
            source.name, {},
            fmt::format("{} × {} points, expected at least 2 along each direction", points[0], points[1]));
    if (!std::visit([](const auto& m) { return any_defined(m.heights.data(), m.heights.size()); }, measurement))
        throw UndefinedDataError(fmt::format("{}: all {} heights are undefined", source.name, points[0] * points[1]));
    const bool is_profile = std::holds_alternative<Profile>(measurement);  // a traced curve may end where it began
    for (const double length : extent(measurement))
        if (!is_profile && (!(length > 0.0) || !std::isfinite(length)))
            throw FormatError(source.name, {},
                              fmt::format("the scan is {} m long, expected a positive length", length));
}

Measurement checked(Measurement measurement, const bytes::Source& source) {
    std::visit([](auto& m) { make_infinite_undefined(m.heights.data(), m.heights.size()); }, measurement);
    require_measurement(measurement, source);
    return measurement;
}

LengthUnit length_unit(const std::string& unit, const bytes::Source& source) {
    static constexpr std::pair<const char*, double> spellings[] = {
        {"m", 1.0},        {"cm", 1e-2},           {"mm", units::mm}, {"µm", units::um},
        {"nm", units::nm}, {"Å", units::angstrom}, {"pm", units::pm}};
    try {
        const double factor = unit_factor(unit, dimension::length);
        for (const auto& [name, known] : spellings)
            if (std::abs(factor / known - 1.0) < 1e-12) return {name, factor};
        return {unit, factor};
    } catch (const InvalidArgument& error) {
        throw FormatError(source.name, {}, fmt::format("unit of heights: {}", error.what()));
    }
}

Array1D standard_errors(const tables::RawTable::RawColumn& column, const bytes::Source& source) {
    if (column.unit.empty())
        throw FormatError(
            source.name, {},
            fmt::format("the column '{0}' has no unit; write it after the name, as '{0} [nm]'", column.name));
    for (Index i = 0; i < column.values.size(); ++i)
        if (!(column.values[i] >= 0.0) || !std::isfinite(column.values[i]))
            throw FormatError(
                source.name, {},
                fmt::format("standard error {} of point {}; expected a number >= 0", column.values[i], i + 1));
    return column.values * length_unit(column.unit, source).factor;
}

GivenUnits given_units(const ReadOptions& options) {
    const std::string_view text = options.unit ? std::string_view(*options.unit) : std::string_view{};
    const auto comma = text.find(',');
    if (comma == std::string_view::npos) return {std::string(text), std::string(text)};
    return {std::string(trimmed(text.substr(0, comma))), std::string(trimmed(text.substr(comma + 1)))};
}

double complete(ChannelInfo& info, const ReadOptions& options, const bytes::Source& source) {
    double factor = 1.0;
    if (info.unit.empty() && options.unit) {
        const auto unit = length_unit(given_units(options).heights, source);
        info.unit = unit.name;
        factor = unit.factor;
    } else if (!info.unit.empty()) {
        info.unit = length_unit(info.unit, source).name;
    }
    const bool stated = !info.size.empty();
    if (stated && std::any_of(info.size.begin(), info.size.end(), [](double size) { return !is_extent(size); })) {
        info.alerts.push_back(
            {"SIZE_NOT_STATED", source.name,
             fmt::format("the file states a size of {} m, which is not a possible extent", fmt::join(info.size, " × ")),
             fmt::format("give `size`, such as {}", size_example(info))});
        info.size.clear();
    }
    for (const double size : options.size.value_or(std::vector<double>()))
        if (!is_extent(size))
            throw InvalidArgument(fmt::format("{}: a size of {} m was given, expected a length above 0, such as {}",
                                              source.name, size, size_example(info)));
    if (info.size.empty() && options.size) {
        if (options.size->size() != info.shape.size())
            throw InvalidArgument(
                fmt::format("{}: {} sizes were given for data of {} dimensions; give `size`, such as {}", source.name,
                            options.size->size(), info.shape.size(), size_example(info)));
        info.size = *options.size;
    }
    for (const double size : info.size)
        if (!is_extent(size))
            throw FormatError(source.name, {}, fmt::format("the scan is {} m long, expected a positive length", size));
    info.metadata.name = info.metadata.name.empty() ? info.name : info.metadata.name;
    if (info.metadata.file.empty()) info.metadata.file = source.name;
    info.metadata.format = info.format;
    info.metadata.unit = info.unit;
    return factor;
}

Channel channel_without_unit(ChannelInfo info, const bytes::Source& source) {
    const auto message = fmt::format(
        "{}: the file states no unit; give `unit`, such as \"um\", or one of x and one of heights, such "
        "as \"mm, um\"",
        source.name);
    return {std::move(info), [message]() -> Measurement { throw InvalidArgument(message); }};
}

Channel incomplete_channel(ChannelInfo info, const bytes::Source& source) {
    const auto message =
        info.unit.empty() && info.size.empty()
            ? fmt::format(
                  "{}: the file states neither size nor unit; give `size`, such as {}, and `unit`, such as \"{}\"",
                  source.name, size_example(info), info.format == "npy" ? "m" : "um")
        : info.unit.empty()
            ? fmt::format("{}: the file states no unit; give `unit`, such as \"um\"", source.name)
            : fmt::format("{}: the file states no size; give `size`, such as {}", source.name, size_example(info));
    return {std::move(info), [message]() -> Measurement { throw InvalidArgument(message); }};
}

}  // namespace setae::formats
