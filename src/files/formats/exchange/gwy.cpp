// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "gwy_writer.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/tables/header.hpp"
#include "storage/raster.hpp"

// Files of Gwyddion: "GWYP", then one object: name, 0, size (32 bits), components; a component: name, 0, type, value.
// Types: b c i q d s o, in capitals their arrays after a count of 32 bits. All little-endian. "/N/data" of the
// container is the N-th map.
namespace setae::formats {
namespace {

constexpr std::size_t longest_text_of_gwy = 1 << 14;  ///< characters kept of a text; the rest is skipped
constexpr std::size_t max_components = 200'000;       ///< of one file
constexpr std::size_t max_attributes = 200;           ///< number kept of the metadata of a channel

/// A part of the file: the content of an object, or the items of an array.
struct Part {
    std::string object;  ///< its class; empty for arrays
    std::uint64_t begin = 0, end = 0, count = 0;
};

struct Component {
    std::string name;
    char type = '\0';
    double number = 0.0;
    std::string text;
    Part part;
};

std::string terminated(bytes::Cursor& cursor) {
    std::string text;
    for (char c = cursor.number<char>(); c != '\0'; c = cursor.number<char>())
        if (text.size() < longest_text_of_gwy) text += c;
    return text;
}

Part object_part(bytes::Cursor& cursor) {
    Part part;
    part.object = terminated(cursor);
    const std::uint64_t size = cursor.number<std::uint32_t>();
    part.begin = cursor.position();
    cursor.skip(size);
    part.end = cursor.position();
    return part;
}

Part array_part(bytes::Cursor& cursor, std::uint64_t item) {
    Part part;
    part.count = cursor.number<std::uint32_t>();
    part.begin = cursor.position();
    cursor.skip(part.count * item);
    part.end = cursor.position();
    return part;
}

Component read_component(bytes::Cursor& cursor) {
    Component component;
    component.name = terminated(cursor);
    component.type = cursor.number<char>();
    switch (component.type) {
        case 'b':
        case 'c': component.number = cursor.number<std::uint8_t>(); break;
        case 'i': component.number = cursor.number<std::int32_t>(); break;
        case 'q': component.number = static_cast<double>(cursor.number<std::int64_t>()); break;
        case 'd': component.number = cursor.number<double>(); break;
        case 's': component.text = terminated(cursor); break;
        case 'o': component.part = object_part(cursor); break;
        case 'C': component.part = array_part(cursor, 1); break;
        case 'I': component.part = array_part(cursor, 4); break;
        case 'Q':
        case 'D': component.part = array_part(cursor, 8); break;
        case 'S':
            for (auto left = cursor.number<std::uint32_t>(); left > 0; --left) (void)terminated(cursor);
            break;
        case 'O':
            for (auto left = cursor.number<std::uint32_t>(); left > 0; --left) (void)object_part(cursor);
            break;
        default:
            cursor.fail(fmt::format("component '{:.40}' has the type '\\x{:02x}', expected one of bciqdsoCIQDSO",
                                    component.name, static_cast<unsigned char>(component.type)));
    }
    return component;
}

/// Calls `visit` for the components of an object, in sequence.
template <class Visit>
void for_each_component(const bytes::Source& source, const Part& part, Visit visit) {
    bytes::Cursor cursor(source, "GWY", part.begin);
    for (std::size_t seen = 0; cursor.position() < part.end; ++seen) {
        const auto component = read_component(cursor);
        if (cursor.position() > part.end)
            cursor.fail(
                fmt::format("component '{:.40}' is longer than its object, which ends at byte {}; it is damaged",
                            component.name, part.end));
        if (seen == max_components) cursor.fail(fmt::format("more than {} components; it is damaged", max_components));
        visit(component);
    }
}

// ---- content of a container by channel
// -------------------------------------------------------------------------------

struct GwyParts {
    std::optional<Part> data, mask, metadata;
    std::string title;
};

/// "/12/data/title" is {12, "data/title"}; empty for other keys.
struct Key {
    std::uint32_t channel = 0;
    std::string_view rest;
};

std::optional<Key> parsed_key(std::string_view name) {
    if (!name.starts_with('/')) return std::nullopt;
    name.remove_prefix(1);
    const auto channel = leading<std::uint32_t>(name);
    if (!channel || !name.starts_with('/')) return std::nullopt;
    return Key{*channel, name.substr(1)};
}

std::map<std::uint32_t, GwyParts> channel_parts(const bytes::Source& source, const Part& container) {
    std::map<std::uint32_t, GwyParts> channels;
    for_each_component(source, container, [&](const Component& component) {
        const auto key = parsed_key(component.name);
        if (!key) return;
        const bool field = component.type == 'o' && component.part.object == "GwyDataField";
        if (key->rest == "data" && field) channels[key->channel].data = component.part;
        else if (key->rest == "mask" && field) channels[key->channel].mask = component.part;
        else if (key->rest == "meta" && component.type == 'o') channels[key->channel].metadata = component.part;
        else if (key->rest == "data/title" && component.type == 's') channels[key->channel].title = component.text;
    });
    return channels;
}

// ---- fields
// -------------------------------------------------------------------------------------------------------------

struct Field {
    Index nx = 0, ny = 0;
    double x_real = 0.0, y_real = 0.0;
    std::string unit_xy, unit_z;
    Part data;
};

/// "m", "V", or empty for a number without a unit.
std::string unit_of(const bytes::Source& source, const Part& unit) {
    std::string text;
    for_each_component(source, unit, [&](const Component& component) {
        if (component.name == "unitstr" && component.type == 's') text = component.text;
    });
    return text;
}

Field read_field(const bytes::Source& source, const Part& part, const std::string& label) {
    Field field;
    for_each_component(source, part, [&](const Component& component) {
        const auto& name = component.name;
        if (name == "xres" && component.type == 'i') field.nx = static_cast<Index>(component.number);
        else if (name == "yres" && component.type == 'i') field.ny = static_cast<Index>(component.number);
        else if (name == "xreal" && component.type == 'd') field.x_real = std::abs(component.number);
        else if (name == "yreal" && component.type == 'd') field.y_real = std::abs(component.number);
        else if (name == "si_unit_xy" && component.type == 'o') field.unit_xy = unit_of(source, component.part);
        else if (name == "si_unit_z" && component.type == 'o') field.unit_z = unit_of(source, component.part);
        else if (name == "data" && component.type == 'D') field.data = component.part;
    });
    const bool fits = field.nx > 0 && field.ny > 0 &&
                      field.data.count == static_cast<std::uint64_t>(field.nx) * static_cast<std::uint64_t>(field.ny);
    if (!fits)
        throw FormatError(source.name, {.offset = part.begin},
                          fmt::format("GWY: {} has {} values for {} × {} points; it is damaged", label,
                                      field.data.count, field.nx, field.ny));
    return field;
}

Raster raster_of(const Field& field) {
    return {.offset = field.data.begin, .nx = field.nx, .ny = field.ny, .sample = Sample::float64};
}

/// The factor of a unit of length to metres; empty for other units and without a unit.
std::optional<double> metres(const std::string& unit) {
    const auto parsed = tables::try_parse_unit(unit);
    return parsed && parsed->dimension == dimension::length ? std::optional(parsed->factor) : std::nullopt;
}

// ---- metadata
// -------------------------------------------------------------------------------------------------------------

void read_metadata(const bytes::Source& source, const Part& part, topography::Metadata& metadata) {
    for_each_component(source, part, [&](const Component& component) {
        if (component.type != 's' || component.text.empty()) return;
        const auto key = bytes::lowered(component.name);
        if (key == "date" || key == "acquisition time" || key == "date and time")
            metadata.acquisition_time = component.text;
        else if (key == "instrument" || key == "instrument name" || key == "microscope")
            metadata.instrument.name = component.text;
        else if (key == gwy_instrument_type) metadata.instrument.type = component.text;
        else if (metadata.attributes.size() < max_attributes) metadata.attributes[component.name] = component.text;
    });
}

/// Heights with the points undefined that the writer of setae marked: the format allows no NaN.
Channel with_undefined_points(Channel channel, const bytes::Source& source, const Part& mask) {
    const auto field = read_field(source, mask, "the mask");
    const auto raster = raster_of(field);
    require_raster(raster, source, "GWY");
    read_as_a_whole(channel, [read = channel.read, source, raster] {
        auto measurement = read();
        const auto marked = read_raster(source, raster, {});
        std::visit(
            [&](auto& m) {
                for (Index k = 0; k < std::min(m.heights.size(), marked.size()); ++k)
                    if (marked.data()[k] > 0.5) m.heights.data()[k] = undefined;
            },
            measurement);
        return checked(std::move(measurement), source);
    });
    return channel;
}

Channel field_channel(const bytes::Source& source, std::uint32_t number, const GwyParts& parts,
                      const ReadOptions& options) {
    const auto field = read_field(source, *parts.data, fmt::format("channel {}", number));
    ChannelInfo info{.name = parts.title, .format = "gwy"};
    info.metadata.file = source.name;
    if (parts.metadata) read_metadata(source, *parts.metadata, info.metadata);
    const bool own_mask = parts.mask && info.metadata.attributes.erase(gwy_undefined_key) > 0;
    if (field.ny > 1) info.orientation = "rows from the top, as stored";
    const auto factor_xy = metres(field.unit_xy), factor_z = metres(field.unit_z);
    if (factor_xy && field.x_real > 0.0 && field.y_real > 0.0)
        info.size = {*factor_xy * field.x_real, *factor_xy * field.y_real};
    info.unit = field.unit_z;
    if (!field.unit_z.empty() && !factor_z) {
        info.shape = {field.nx, field.ny};
        return non_height_channel(std::move(info));
    }
    if (factor_z && *factor_z != 1.0)
        info.alerts.push_back(
            {"UNIT_PREFIX", source.name,
             fmt::format("heights of '{}' are in {}, which Gwyddion reads as m", info.name, field.unit_z),
             "check that the program that wrote the file meant this prefix"});
    if (parts.mask && !own_mask) {
        info.metadata.attributes["mask"] = "there, not applied";
        info.alerts.push_back(
            {"MASK_NOT_APPLIED", source.name,
             fmt::format(
                 "'{}' has a mask, which was not applied; a mask is a selection, and its points are heights like "
                 "all others",
                 info.name),
             "if the mask marks bad points, remove them in Gwyddion first"});
    }
    auto channel =
        raster_channel(std::move(info), source, raster_of(field), {.factor = factor_z.value_or(1.0)}, options);
    return own_mask && !channel.info.size.empty() ? with_undefined_points(std::move(channel), source, *parts.mask)
                                                  : channel;
}

Match detect_gwy(std::string_view head, const bytes::Source&) {
    return head.size() > 4 && head.starts_with("GWY") && (head[3] == 'P' || head[3] == 'O' || head[3] == 'Q')
               ? Match::yes
               : Match::no;
}

std::vector<Channel> open_gwy(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "GWY", 3);
    if (const char version = cursor.number<char>(); version != 'P')
        cursor.fail(
            fmt::format("begins with 'GWY{}', which is {}, expected 'GWYP'; open it in Gwyddion 2 and save it again",
                        version, version == 'O' ? "of Gwyddion 1" : "of a newer Gwyddion"));
    const auto container = object_part(cursor);
    if (container.object != "GwyContainer")
        throw FormatError(source.name, {.offset = 4},
                          fmt::format("GWY: contains '{:.40}', expected 'GwyContainer'", container.object));
    std::vector<Channel> channels;
    for (const auto& [number, parts] : channel_parts(source, container))
        if (parts.data) channels.push_back(field_channel(source, number, parts, options));
    if (channels.empty())
        throw FormatError(source.name, {.offset = container.begin},
                          "GWY: no map; graphs, spectra and volumes are not read");
    return channels;
}

}  // namespace

Format gwy_format() {
    return {
        .identifier = "gwy",
        .name = "Gwyddion",
        .extensions = ".gwy",
        .description = "native files of Gwyddion 2: every map of the file, with its title and metadata",
        .heights =
            "float64 in the field's unit; fields whose unit is no length are listed, those without any need the user's; a mask is not applied, but for undefined points that setae wrote",
        .orientation = "rows from the top",
        .not_read =
            "graphs, spectra, volumes, presentations and selections are not read; files of Gwyddion 1 "
            "(GWYO) and of 64-bit sizes (GWYQ) are refused",
        .reference = "Gwyddion user guide, Format of Gwyddion Files",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_gwy,
        .open = open_gwy,
        .write = write_gwy};
}

}  // namespace setae::formats
