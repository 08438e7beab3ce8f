// SPDX-License-Identifier: GPL-3.0-or-later
#include <yaml-cpp/yaml.h>

#include <charconv>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>

#include <fmt/format.h>

#include "archive.hpp"
#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

// Containers of contact.engineering: a ZIP with index.json or, in older ones, meta.yml, and one or two members a
// measurement: the instrument's own file ("original") and a processed copy ("squeezed-netcdf").
namespace setae::io {
namespace {

using nlohmann::json;

constexpr const char* json_index = "index.json";
constexpr const char* yaml_index = "meta.yml";

// ---- the index ------------------------------------------------------------------------------------------------------

json scalar(const YAML::Node& node) {
    const auto& text = node.Scalar();
    if (node.Tag() == "!") return text;  // quoted
    if (text == "true" || text == "false") return text == "true";
    if (text == "null" || text == "~" || text.empty()) return nullptr;
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc{} && end == text.data() + text.size()) return number;
    return text;
}

/// YAML as JSON, tags ignored: `!!python/tuple` is a sequence, and nothing is ever executed. Aliases may repeat a node
/// often; `budget` bounds how many are visited.
json to_json(const YAML::Node& node, std::size_t& budget) {
    if (budget-- == 0) throw YAML::Exception(node.Mark(), "too many nodes");
    if (node.IsMap()) {
        auto object = json::object();
        for (const auto& entry : node) object[entry.first.Scalar()] = to_json(entry.second, budget);
        return object;
    }
    if (node.IsSequence()) {
        auto array = json::array();
        for (const auto& entry : node) array.push_back(to_json(entry, budget));
        return array;
    }
    return node.IsScalar() ? scalar(node) : json(nullptr);
}

json parse_yaml(const std::string& text, const std::string& name) {
    try {
        std::size_t budget = 10 + text.size();
        return to_json(YAML::Load(text), budget);
    } catch (const YAML::Exception& error) {
        throw FormatError(name, {.line = static_cast<std::uint64_t>(error.mark.line + 1)}, fmt::format("YAML: {}", error.msg));
    }
}

json parse_json(const std::string& text, const std::string& name) {
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        throw FormatError(name, {.offset = error.byte}, "JSON that does not parse; the index is damaged");
    }
}

json read_index(const Archive& archive, const Source& source) {
    const auto* name = archive.has(json_index) ? json_index : yaml_index;
    const auto label = fmt::format("{}: {}", source.name, name);
    auto index = name == json_index ? parse_json(archive.read(name), label) : parse_yaml(archive.read(name), label);
    if (!index.is_object() || !index.contains("surfaces") || !index["surfaces"].is_array())
        throw FormatError(label, {}, "no list of surfaces");
    return index;
}

// ---- one measurement ------------------------------------------------------------------------------------------------

const json& at(const json& object, const char* key) {
    static const json none;
    if (!object.is_object()) return none;
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
}

std::string text(const json& object, const char* key) {
    const auto& value = at(object, key);
    return value.is_string() ? value.get<std::string>() : std::string{};
}

std::optional<double> number(const json& object, const char* key) {
    const auto& value = at(object, key);
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

/// {value, unit} as a length [m].
std::optional<double> length(const json& object, const char* key) {
    const auto value = number(at(object, key), "value");
    const auto unit = text(at(object, key), "unit");
    if (!value || unit.empty()) return std::nullopt;
    return *value * unit_factor(unit, dimension::length);
}

/// What the index says of a measurement.
struct Entry {
    std::string name, surface, member;
    bool squeezed = false;  ///< processed: scaled, filled and detrended already
    std::size_t channel = 0;
    double height_scale = 1.0;
    ReadOptions options;
    bool periodic = false;
    std::optional<topography::Trend> trend;
    topography::Instrument instrument;
    std::map<std::string, std::string> attributes;
};

std::optional<topography::Trend> parse_trend(const std::string& mode) {
    if (mode == "height") return topography::Trend::tilt;
    if (mode == "curvature") return topography::Trend::parabola;
    if (mode == "center") return topography::Trend::mean;
    return std::nullopt;
}

std::vector<double> parse_size(const json& size, double factor) {
    std::vector<double> lengths;
    for (const auto& value : size.is_array() ? size : json::array({size})) {
        if (!value.is_number()) throw InvalidArgument("size in the index is no number");
        lengths.push_back(value.get<double>() * factor);
    }
    return lengths;
}

void parse_member(const json& item, const Archive& archive, Entry& entry) {
    const auto original = text(at(item, "datafile"), "original"), squeezed = text(at(item, "datafile"), "squeezed-netcdf");
    entry.squeezed = original.empty() || (!archive.has(original) && !squeezed.empty());
    entry.member = entry.squeezed ? squeezed : original;
    if (entry.member.empty()) throw InvalidArgument("the index names no data file");
}

Entry parse_entry(const json& item, const std::string& surface, const Archive& archive) {
    Entry entry;
    entry.name = text(item, "name");
    entry.surface = surface;
    parse_member(item, archive, entry);
    const auto channel = number(item, "data_source").value_or(0.0);
    if (!(channel >= 0.0 && channel < 1e6)) throw InvalidArgument(fmt::format("data_source {} in the index", channel));
    entry.channel = entry.squeezed ? 0 : static_cast<std::size_t>(channel);
    entry.height_scale = number(item, "height_scale").value_or(1.0);
    if (const auto unit = text(item, "unit"); !unit.empty()) {
        entry.options.unit = unit;
        if (!at(item, "size").is_null()) entry.options.size = parse_size(at(item, "size"), unit_factor(unit, dimension::length));
    }
    entry.periodic = at(item, "is_periodic") == true;
    entry.trend = parse_trend(text(item, "detrend_mode"));
    const auto& instrument = at(item, "instrument");
    const auto& parameters = at(instrument, "parameters");
    entry.instrument.name = text(instrument, "name");
    entry.instrument.tip_radius = length(parameters, "tip_radius");
    entry.instrument.resolution = length(parameters, "resolution");
    if (const auto type = text(instrument, "type"); !type.empty()) entry.attributes["instrument_type"] = type;
    for (const char* key : {"description", "measurement_date", "detrend_mode", "fill_undefined_data_mode"})
        if (const auto value = text(item, key); !value.empty()) entry.attributes[key] = value;
    entry.attributes["surface"] = surface;
    entry.attributes["member"] = entry.member;
    return entry;
}

void merge(const Entry& entry, const std::string& container, topography::Metadata& metadata) {
    metadata.file = container;
    metadata.name = entry.name;
    if (!entry.instrument.name.empty()) metadata.instrument.name = entry.instrument.name;
    if (entry.instrument.tip_radius) metadata.instrument.tip_radius = entry.instrument.tip_radius;
    if (entry.instrument.resolution) metadata.instrument.resolution = entry.instrument.resolution;
    for (const auto& [key, value] : entry.attributes) metadata.attributes[key] = value;
    if (metadata.acquisition_time.empty())
        if (const auto date = entry.attributes.find("measurement_date"); date != entry.attributes.end()) metadata.acquisition_time = date->second;
}

/// A member's channel with the scale the index adds: only where the member's own format defines none.
struct ScaledChannel {
    Channel channel;
    double factor = 1.0;
};

ScaledChannel open_member(const Archive& archive, const Entry& entry) {
    const auto member = archive.member(entry.member);
    const auto& format = detect_format(member);
    auto channels = open(member, entry.options);
    if (entry.channel >= channels.size())
        throw FormatError(member.name, {}, fmt::format("no channel {}, the file has {}", entry.channel, channels.size()));
    return {std::move(channels[entry.channel]), format.carries_scale ? 1.0 : entry.height_scale};
}

topography::Measurement read_member(const Source& source, const Entry& entry) {
    const Archive archive(source);
    const auto [channel, factor] = open_member(archive, entry);
    auto measurement = topography::scaled(channel.read(), factor);
    merge(entry, source.name, topography::metadata(measurement));
    std::visit([&](auto& m) {
        if constexpr (requires { m.periodic; }) m.periodic = m.periodic || entry.periodic;
    }, measurement);
    return measurement;
}

Channel member_channel(const Source& source, const Archive& archive, const Entry& entry) {
    auto info = open_member(archive, entry).channel.info;
    info.name = entry.name;
    merge(entry, source.name, info.metadata);
    info.recommended_trend = entry.trend;
    return {std::move(info), [source, entry] { return read_member(source, entry); }};
}

/// Called while an error is handled: the channel keeps it and throws it when read.
Channel unreadable_channel(const Source& source, const std::string& name, const std::string& reason) {
    ChannelInfo info;
    info.name = name;
    info.is_height = false;
    info.metadata.file = source.name;
    info.metadata.name = name;
    info.alerts.push_back({"UNREADABLE_MEMBER", name, reason, "the other measurements are not affected; repair or replace this one"});
    return {std::move(info), [error = std::current_exception()]() -> topography::Measurement { std::rethrow_exception(error); }};
}

Channel entry_channel(const Source& source, const Archive& archive, const json& item, const std::string& surface) {
    try {
        return member_channel(source, archive, parse_entry(item, surface, archive));
    } catch (const Error& error) {
        return unreadable_channel(source, text(item, "name"), error.what());
    }
}

Match detect_container(std::string_view head, const Source& source) {
    if (!is_zip(head)) return Match::no;
    const Archive archive(source);
    return archive.has(json_index) || archive.has(yaml_index) ? Match::yes : Match::no;
}

std::vector<Channel> open_container(const Source& source, const ReadOptions&) {
    const Archive archive(source);
    const auto index = read_index(archive, source);
    std::vector<Channel> channels;
    for (const auto& surface : index["surfaces"])
        for (const auto& item : at(surface, "topographies"))
            channels.push_back(entry_channel(source, archive, item, text(surface, "name")));
    if (channels.empty()) throw FormatError(source.name, {}, "container without measurements");
    return channels;
}

}  // namespace

Format container_format() {
    return {.identifier = "ce-container",
            .name = "contact.engineering container",
            .extensions = ".zip",
            .description = "ZIP with index.json or meta.yml and one measurement or more; the original file is preferred to its processed copy",
            .heights = "as the original file says; the index's scale is applied only where that file carries none",
            .orientation = "as the original file says",
            .reference = "https://contact.engineering",
            .tested_on_real_files = true,
            .carries_scale = true,
            .detect = detect_container,
            .open = open_container};
}

}  // namespace setae::io
