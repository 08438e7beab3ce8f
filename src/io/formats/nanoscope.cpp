// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "header.hpp"
#include "raster.hpp"
#include "format_list.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "text.hpp"

// Nanoscope files from version 4.3: a latin-1 header of sections "\*Name" with lines "\Key: value", then one block of
// little-endian integers an image. Height = raw · hard value [V] · soft sensitivity [nm/V] / 2^bits; rows from bottom to top.
namespace setae::io {
namespace {

constexpr std::string_view first_section = "\\*File list", last_line = "\\*File list end";
constexpr std::uint64_t longest_header = 1 << 20;

using Entries = std::vector<std::pair<std::string, std::string>>;

/// A section with its entries; keys in lower case, without '@' and the group number of "@2:Z scale".
struct Section {
    std::string name;
    Entries entries;
};

std::string normalised_key(std::string_view key) {
    if (key.starts_with('@')) key.remove_prefix(1);
    if (key.size() > 2 && key[0] >= '0' && key[0] <= '9' && key[1] == ':') key.remove_prefix(2);
    return lowered(trimmed(key));
}

/// "@2:Z scale: V …" has its colon after the group number.
std::size_t colon_after_key(std::string_view line) {
    const bool grouped = line.size() > 2 && line[0] == '@' && line[2] == ':';
    return line.find(':', grouped ? 3 : 0);
}

std::vector<Section> parse_sections(const Source& source) {
    const auto bytes = source.head(longest_header);
    const auto end = bytes.find(last_line);
    if (end == std::string::npos)
        throw FormatError(source.name, {.offset = bytes.size()}, fmt::format("Nanoscope: header does not end with '{}'; the file is truncated", last_line));
    const auto text = decoded(bytes.substr(0, end), Encoding::latin1);
    std::vector<Section> sections;
    for (const auto raw : split_lines(text)) {
        auto line = trimmed(raw);
        if (line.starts_with("\\*")) {
            sections.push_back({lowered(line.substr(2)), {}});
        } else if (line.starts_with('\\') && !sections.empty()) {
            line.remove_prefix(1);
            const auto colon = colon_after_key(line);
            if (colon != std::string_view::npos)
                sections.back().entries.emplace_back(normalised_key(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
        }
    }
    return sections;
}

const std::string* find(const Section& section, std::string_view key) {
    for (const auto& [name, value] : section.entries)
        if (name == key) return &value;
    return nullptr;
}

/// First entry of that key outside the images.
const std::string* find(const std::vector<Section>& sections, std::string_view key) {
    for (const auto& section : sections) {
        if (section.name.ends_with("image list")) continue;
        if (const auto* value = find(section, key)) return value;
    }
    return nullptr;
}

const std::string& required(const Section& section, std::string_view key, const Source& source) {
    if (const auto* value = find(section, key)) return *value;
    throw FormatError(source.name, {}, fmt::format("Nanoscope: image without '{}' in the header", key));
}

std::uint64_t integer(const Section& section, std::string_view key, const Source& source) {
    const auto& text = required(section, key, source);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || value == 0 || value > (std::uint64_t{1} << 40))
        throw FormatError(source.name, {}, fmt::format("Nanoscope: '{}' is '{:.40}', expected a positive integer", key, text));
    return value;
}

/// A number and its unit at the start of a text; the unit may be missing.
struct Value {
    double number = 0.0;
    std::string unit;
};

std::optional<Value> leading_value(std::string_view text) {
    text = trimmed(text);
    Value value;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value.number);
    if (error != std::errc{}) return std::nullopt;
    value.unit = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    return value;
}

/// Length of one unit of raw data [m], and the unit it is written in; nothing for channels that are no heights.
struct HeightScale {
    double factor = 0.0;
    std::string unit;
};

/// "V [Sens. Zsens] (0.005035400 V/LSB) 2.910461 V": the sensitivity's name in [], the hard value after ().
std::optional<HeightScale> height_scale(const std::string& scale, const std::vector<Section>& sections, std::size_t bytes) {
    const auto close = scale.rfind(')');
    const auto hard = leading_value(close == std::string::npos ? std::string_view{} : std::string_view(scale).substr(close + 1));
    if (!hard) return std::nullopt;
    const auto hard_unit = try_parse_unit(hard->unit);
    if (!hard_unit) return std::nullopt;
    double factor = hard->number * hard_unit->factor;
    auto dimension = hard_unit->dimension;
    auto unit = hard->unit;
    const auto open = scale.find('['), shut = scale.find(']');
    if (open != std::string::npos && shut != std::string::npos && shut > open + 1) {
        const auto* entry = find(sections, lowered(std::string_view(scale).substr(open + 1, shut - open - 1)));
        const auto soft = entry && entry->starts_with("V ") ? leading_value(std::string_view(*entry).substr(2)) : std::nullopt;
        const auto soft_unit = soft ? try_parse_unit(soft->unit) : std::nullopt;
        if (!soft_unit) return std::nullopt;
        factor *= soft->number * soft_unit->factor;
        dimension = dimension * soft_unit->dimension;
        unit = soft->unit.substr(0, soft->unit.find('/'));
    }
    if (dimension != dimension::length || !std::isfinite(factor)) return std::nullopt;
    return HeightScale{std::ldexp(factor, -8 * static_cast<int>(bytes)), unit};
}

/// "500 500 nm" or "500 nm".
std::array<double, 2> scan_size(const Section& image, const Source& source) {
    const auto& text = required(image, "scan size", source);
    const auto first = leading_value(text);
    const auto second = first ? leading_value(first->unit) : std::nullopt;
    if (!first) throw FormatError(source.name, {}, fmt::format("Nanoscope: scan size '{:.40}' is no length", text));
    const auto factor = length_unit(second ? second->unit : first->unit, source).factor;
    const double y = second ? second->number : first->number;
    if (!(first->number > 0.0) || !(y > 0.0))
        throw FormatError(source.name, {}, fmt::format("Nanoscope: scan size '{:.40}', expected positive lengths", text));
    return {first->number * factor, y * factor};
}

/// `S [Height] "Height"`: the name shown, else the internal one.
std::string image_name(const std::string& data) {
    const auto quote = data.find('"'), end = data.rfind('"');
    if (quote != std::string::npos && end > quote + 1) return data.substr(quote + 1, end - quote - 1);
    const auto open = data.find('['), close = data.find(']');
    return open != std::string::npos && close != std::string::npos && close > open ? data.substr(open + 1, close - open - 1) : data;
}

/// Where an image's integers stand.
struct Block {
    std::uint64_t offset = 0;
    std::size_t bytes = 2;  ///< of one value
    Index nx = 0, ny = 0;

    [[nodiscard]] std::uint64_t length() const { return bytes * static_cast<std::uint64_t>(nx) * static_cast<std::uint64_t>(ny); }
};

/// From version 9.2 on, data are 4 bytes wide while "Bytes/pixel" may still say 2: the length of the block decides.
Block find_block(const Section& image, const std::string& name, const Source& source) {
    const auto nx = integer(image, "samps/line", source), ny = integer(image, "number of lines", source);
    const auto length = integer(image, "data length", source);
    auto bytes = integer(image, "bytes/pixel", source);
    const bool plausible = nx < (1u << 24) && ny < (1u << 24);
    if (plausible && length == 4 * nx * ny) bytes = 4;
    if (!plausible || (bytes != 2 && bytes != 4) || length < bytes * nx * ny)
        throw FormatError(source.name, {}, fmt::format("Nanoscope: image '{}' has {} × {} values of {} bytes in {} bytes", name, nx, ny, bytes, length));
    const Block block{integer(image, "data offset", source), static_cast<std::size_t>(bytes), static_cast<Index>(nx), static_cast<Index>(ny)};
    if (block.offset + block.length() > source.size)
        throw FormatError(source.name, {.offset = source.size},
                          fmt::format("Nanoscope: the file ends here, image '{}' should end at byte {}; it is truncated", name, block.offset + block.length()));
    return block;
}

topography::Metadata file_metadata(const std::vector<Section>& sections, const Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "di";
    metadata.instrument.type = "afm";
    for (const auto* key : {"microscope", "description"})
        if (const auto* value = find(sections, key); value && metadata.instrument.name.empty()) metadata.instrument.name = *value;
    if (const auto* date = find(sections, "date")) metadata.acquisition_time = *date;
    if (const auto* version = find(sections, "version")) metadata.attributes["software_version"] = *version;
    if (const auto* scanner = find(sections, "scanner file")) metadata.attributes["scanner_file"] = *scanner;
    return metadata;
}

Channel image_channel(const Section& image, const std::vector<Section>& sections, const topography::Metadata& common, const Source& source) {
    ChannelInfo info;
    info.name = image_name(required(image, "image data", source));
    info.format = "di";
    info.metadata = common;
    info.metadata.name = info.name;
    if (const auto* direction = find(image, "line direction")) info.metadata.attributes["line_direction"] = *direction;
    const auto block = find_block(image, info.name, source);
    const auto size = scan_size(image, source);
    info.shape = {block.nx, block.ny};
    info.size = {size[0], size[1]};
    const auto scale = height_scale(required(image, "z scale", source), sections, block.bytes);
    if (!scale) return non_height_channel(std::move(info));
    info.unit = scale->unit;
    info.orientation = "rows from the bottom, turned";
    const Raster raster{.offset = block.offset, .nx = block.nx, .ny = block.ny, .sample = block.bytes == 2 ? Sample::int16 : Sample::int32, .bottom_up = true};
    return raster_channel(std::move(info), source, raster, {.factor = scale->factor});
}

Match detect_nanoscope(std::string_view head, const Source&) { return head.starts_with(first_section) ? Match::yes : Match::no; }

std::vector<Channel> open_nanoscope(const Source& source, const ReadOptions&) {
    const auto sections = parse_sections(source);
    const auto common = file_metadata(sections, source);
    std::vector<Channel> channels;
    for (const auto& section : sections)
        if (section.name == "ciao image list" || section.name == "afm image list" || section.name == "stm image list")
            channels.push_back(image_channel(section, sections, common, source));
    if (channels.empty()) throw FormatError(source.name, {}, "Nanoscope: no image in the header; force curves and older versions are not read");
    return channels;
}

}  // namespace

Format nanoscope_format() {
    return {.identifier = "di",
            .name = "Nanoscope",
            .extensions = ".spm .001 .002 .003 .di .txt",
            .description = "Digital Instruments, Veeco, Bruker from version 4.3: text header and an integer image a channel",
            .heights = "raw times hard scale times soft sensitivity over 2^16 or 2^32; no point is undefined",
            .orientation = "rows stored from the bottom, turned",
            .reference = "Nanoscope 5 to 9 file headers, as described by Gwyddion's user guide",
            .tested_on_real_files = true,
            .carries_scale = true,
            .detect = detect_nanoscope,
            .open = open_nanoscope};
}

}  // namespace setae::io
