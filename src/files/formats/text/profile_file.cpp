// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/formats/profile_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::formats {
namespace {

using topography::Profile;
using topography::TraceResponse;

constexpr std::string_view format_line = "# format: setae profile", version = "1";

const ProfileKey* known_key(std::string_view name) {
    for (const auto& key : profile_keys())
        if (key.name == name) return &key;
    return nullptr;
}

/// Known, but kept as attributes.
bool is_attribute(std::string_view key) {
    return key == "foil_thickness" || key == "rotation" || key == "reentrant_share" || !known_key(key);
}

/// SI value of a known quantity. @throws InvalidArgument.
double quantity(const ProfileKey& key, const std::string& value) {
    double number = 0.0;
    try {
        number = parse_quantity(value, *key.dimension);
    } catch (const InvalidArgument& error) {
        throw InvalidArgument(fmt::format("{}: {}", key.name, error.what()));
    }
    const bool may_be_negative = key.name == "rotation",
               must_be_positive = key.name == "step" || key.name == "tip_radius" || key.name == "resolution";
    if (!std::isfinite(number) || (number < 0.0 && !may_be_negative) || (number == 0.0 && must_be_positive))
        throw InvalidArgument(fmt::format("{}: '{}'; expected {}", key.name, value,
                                          may_be_negative    ? "a finite number"
                                          : must_be_positive ? "a number > 0"
                                                             : "a number >= 0"));
    return number;
}

void require_entry(std::string_view key, const std::string& value) {
    if (key.empty() || trimmed(key) != key || key.find_first_of(":\r\n") != std::string_view::npos)
        throw InvalidArgument(fmt::format(
            "'{}' is not a key of a profile file: it is empty or has a colon, line breaks or outer blanks", key));
    if (value.find_first_of("\r\n") != std::string::npos || trimmed(value) != value)
        throw InvalidArgument(
            fmt::format("the value of '{}' has line breaks or outer blanks; write it on one line", key));
    const auto* known = known_key(key);
    if (known && known->dimension) (void)quantity(*known, value);
}

/// Content of the head of a file.
struct ProfileHead {
    std::map<std::string, std::string> entries;
    std::map<std::string, std::size_t> line;  ///< of each key, from 1

    [[nodiscard]] std::optional<std::string> text(const std::string& key) const {
        const auto entry = entries.find(key);
        return entry == entries.end() ? std::nullopt : std::optional(entry->second);
    }
    [[nodiscard]] std::optional<double> number(const std::string& key) const {
        const auto value = text(key);
        return value ? std::optional(quantity(*known_key(key), *value)) : std::nullopt;
    }
};

ProfileHead read_head(const std::string& text, const std::string& name) {
    ProfileHead head;
    std::size_t number = 0;
    for (const auto raw : bytes::split_lines(text)) {
        ++number;
        const auto line = trimmed(raw);
        if (line.empty()) continue;
        if (!line.starts_with('#')) break;
        const auto fail = [&](const std::string& what) { throw FormatError(name, {.line = number}, what); };
        const auto entry = trimmed(line.substr(1));
        const auto colon = entry.find(':');
        if (colon == std::string_view::npos || colon == 0)
            fail(fmt::format("'{:.60}' is not 'key: value'; correct or remove the line", entry));
        const std::string key(trimmed(entry.substr(0, colon))), value(trimmed(entry.substr(colon + 1)));
        if (!head.entries.emplace(key, value).second) fail(fmt::format("key '{}' is given twice; keep one", key));
        head.line.emplace(key, number);
        try {
            require_entry(key, value);
        } catch (const InvalidArgument& error) {
            fail(error.what());
        }
        if (key == "version" && value != version)
            fail(fmt::format("version '{}' of the profile format is unknown; expected {}", value, version));
    }
    if (!head.text("version"))
        throw FormatError(name, {.line = 1}, fmt::format("the head has no line '# version: {}'", version));
    return head;
}

constexpr std::array<const char*, 4> response_keys{"blur", "smoothing_length", "step", "noise_density"};

std::optional<TraceResponse> response_of(const ProfileHead& head, const std::string& name) {
    const char *given = nullptr, *missing = nullptr;
    for (const auto* key : response_keys) (head.text(key) ? given : missing) = key;
    if (!given) return std::nullopt;
    if (missing)
        throw FormatError(
            name, {.line = head.line.at(given)},
            fmt::format("'{}' is given without '{}': the response of a trace needs blur, smoothing_length, step and "
                        "noise_density",
                        given, missing));
    return TraceResponse{*head.number("blur"), *head.number("smoothing_length"), *head.number("step"),
                         *head.number("noise_density")};
}

topography::Metadata metadata_of(const ProfileHead& head, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.name = head.text("name").value_or("");
    metadata.file = source.name;
    metadata.format = "xy";
    metadata.acquisition_time = head.text("acquisition_time").value_or("");
    metadata.instrument = {head.text("instrument_name").value_or(""), head.text("instrument").value_or(""),
                           head.number("tip_radius"), head.number("tip_radius_standard_error"),
                           head.number("resolution")};
    for (const auto& [key, value] : head.entries)
        if (is_attribute(key)) metadata.attributes.emplace(key, value);
    return metadata;
}

}  // namespace

const std::vector<ProfileKey>& profile_keys() {
    static const std::vector<ProfileKey> keys{
        {"format", "setae profile", {}},
        {"version", "1", {}},
        {"name", "name of the measurement", {}},
        {"instrument", "kind of instrument: tem, stylus, afm, optical", {}},
        {"instrument_name", "name of the instrument", {}},
        {"tip_radius", "radius of the tip that measured the profile", dimension::length},
        {"tip_radius_standard_error", "standard error of tip_radius", dimension::length},
        {"resolution", "shortest wavelength resolved", dimension::length},
        {"acquisition_time", "time in the notation of the instrument", {}},
        {"blur", "standard deviation of the Gaussian blur of the picture, along x", dimension::length},
        {"smoothing_length", "length of the smoothing spline of the trace, along x", dimension::length},
        {"step", "distance between the points of the trace, along x", dimension::length},
        {"noise_density", "C1D of the noise of the trace before smoothing", dimension::power_spectrum_1d},
        {"foil_thickness", "thickness of the sample along the beam", dimension::length},
        {"rotation", "angle by which the traced curve was rotated, counterclockwise", dimension::none},
        {"reentrant_share", "share of the length of the curve on overhangs", dimension::none}};
    return keys;
}

std::string as_profile_file(const Profile& profile) {
    topography::validate(profile);
    const auto& metadata = profile.metadata;
    std::string text = fmt::format("{}\n# version: {}\n", format_line, version);
    const auto put = [&](std::string_view key, const std::string& value) {
        require_entry(key, value);
        text += fmt::format("# {}:{}{}\n", key, value.empty() ? "" : " ", value);
    };
    const auto put_text = [&](const char* key, const std::string& value) {
        if (!value.empty()) put(key, value);
    };
    const auto put_number = [&](const char* key, std::optional<double> value) {
        if (value) put(key, fmt::format("{} {}", *value, si_unit(*known_key(key)->dimension)));
    };
    put_text("name", metadata.name);
    put_text("instrument", metadata.instrument.type);
    put_text("instrument_name", metadata.instrument.name);
    put_number("tip_radius", metadata.instrument.tip_radius);
    put_number("tip_radius_standard_error", metadata.instrument.tip_radius_standard_error);
    put_number("resolution", metadata.instrument.resolution);
    put_text("acquisition_time", metadata.acquisition_time);
    if (const auto& response = profile.response) {
        put_number("blur", response->blur);
        put_number("smoothing_length", response->smoothing_length);
        put_number("step", response->step);
        put_number("noise_density", response->noise_density);
    }
    for (const auto& [key, value] : metadata.attributes) {
        if (!is_attribute(key))
            throw InvalidArgument(fmt::format("attribute '{}' has the name of a key of profile files; rename it", key));
        put(key, value);
    }
    Table table{{{"x", "m", profile.positions}, {"h", "m", profile.heights}}, {}};
    if (profile.standard_error.size() > 0) table.columns.push_back({"standard_error", "m", profile.standard_error});
    return text + tables::as_csv(table);
}

void write_profile(const std::string& path, const Profile& profile) {
    bytes::write_whole_file(path, as_profile_file(profile));
}

bool is_profile_file(std::string_view head) { return trimmed(head.substr(0, head.find('\n'))) == format_line; }

Profile read_profile(const bytes::Source& source) {
    const auto text = bytes::decoded(source.all(), bytes::Encoding::utf8);
    if (!is_profile_file(text))
        throw FormatError(source.name, {.line = 1},
                          fmt::format("not a profile file of setae: it does not begin with '{}'", format_line));
    const auto head = read_head(text, source.name);
    const auto table =
        tables::read_raw_table(source, {.encoding = bytes::Encoding::utf8, .separator = ',', .decimal_point = '.'});
    const auto& columns = table.columns;
    const bool two = columns.size() >= 2 && columns[0].name == "x" && columns[1].name == "h";
    if (!(two && (columns.size() == 2 || (columns.size() == 3 && columns[2].name == "standard_error"))))
        throw FormatError(
            source.name, {},
            fmt::format("{} columns; expected 'x [m],h [m]' and optionally 'standard_error [m]'", columns.size()));
    const auto in_metres = [&](const tables::RawTable::RawColumn& column) -> Array1D {
        return column.values * length_unit(column.unit, source).factor;
    };
    Profile profile{in_metres(columns[0]), in_metres(columns[1]), metadata_of(head, source)};
    profile.metadata.unit = length_unit(columns[1].unit, source).name;
    profile.response = response_of(head, source.name);
    if (profile.response) profile.response->jumps = head.number("reentrant_share").value_or(0.0) > 0.0;
    if (columns.size() == 3) profile.standard_error = standard_errors(columns[2], source);
    return profile;
}

}  // namespace setae::formats
