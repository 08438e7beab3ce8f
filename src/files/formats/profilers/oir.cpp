// SPDX-License-Identifier: GPL-3.0-or-later
#include "oir.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/pieces.hpp"
#include "setae/bytes/xml_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "storage/raster.hpp"

// Olympus OIR: a header of 96 bytes and chunks, each with its size and kind: lists of metadata in XML, pictures, and
// points with the name of their image. The properties state which image contains heights. Height = raw · length z ·
// calibration z.
namespace setae::formats {
namespace {

constexpr const char* oir_name = "OIR";
constexpr std::string_view oir_signature = "OLYMPUSRAWFORMAT";
constexpr std::uint64_t oir_header_bytes = 96, list_header_bytes = 8 * 4;
enum Chunk : std::int32_t { metadata_list = 0, metadata = 1, picture = 2, points = 3, spacer = 5, no_more = -1 };
enum OirBlock : std::uint32_t { properties = 2, image_prefix = 6 };

/// Required content of the chunks.
struct OirContent {
    std::string properties, prefix;
    std::map<std::string, std::vector<bytes::Piece>, std::less<>>
        images;  ///< by name, without the number of the part at the end
};

/// Layout after the header of a block, one letter each: t a text after its length, i a number; after 'n', repeated by a
/// number.
std::string_view layout_of(std::uint32_t block) {
    static constexpr std::string_view layouts[] = {"",    "t",    "t",     "t",   "t",   "ntt", "nti", "nti",
                                                   "nti", "nitt", "ntitt", "ntt", "nti", "nti", "t"};
    return block < std::size(layouts) ? layouts[block] : "";
}

/// Reads the texts of a block and returns the first.
std::string first_text(bytes::Cursor& cursor, std::string_view layout) {
    constexpr std::uint64_t longest = 1 << 24;
    std::string first;
    std::uint32_t count = 1;
    if (layout.starts_with('n')) {
        count = cursor.number<std::uint32_t>();
        layout.remove_prefix(1);
    }
    for (std::uint32_t i = 0; i < count; ++i)
        for (const char kind : layout) {
            const auto number = cursor.number<std::uint32_t>();
            if (kind != 't') continue;
            if (i == 0 && first.empty() && number < longest) first = cursor.bytes(number);
            else cursor.skip(number);
        }
    first.resize(std::min(first.find('\0'), first.size()));
    return first;
}

void read_list(bytes::Cursor& cursor, std::uint64_t end, OirContent& content) {
    while (cursor.position() < end) {
        const auto block = cursor.number<std::uint32_t>();
        const auto layout = layout_of(block);
        if (layout.empty()) return cursor.seek(end);  // a block of another kind: the rest of the list is ignored
        cursor.skip(list_header_bytes);
        auto text = first_text(cursor, layout);
        if (block == properties) content.properties = std::move(text);
        else if (block == image_prefix) content.prefix = std::move(text);
    }
    if (cursor.position() != end)
        cursor.fail(
            fmt::format("a list of metadata extends to byte {}, but its chunk ends at byte {}; the file is damaged",
                        cursor.position(), end));
}

/// Points of an image: its name ends in "_0", longer images continue in parts "_1", "_2" …
void read_points(bytes::Cursor& cursor, std::uint64_t end, OirContent& content) {
    cursor.skip(4);
    const auto size = cursor.number<std::uint32_t>();
    auto image = cursor.bytes(cursor.number<std::uint32_t>());
    cursor.seek(end);
    if (cursor.number<std::uint32_t>() != size) cursor.fail("an image states two sizes; the file is damaged");
    cursor.skip(4);
    image.resize(std::min(image.find('\0'), image.size()));
    content.images[image.substr(0, image.rfind('_'))].push_back({cursor.position(), size});
    cursor.skip(size);
}

OirContent content_of(bytes::Cursor& cursor) {
    OirContent content;
    cursor.seek(oir_header_bytes);
    while (!cursor.at_end()) {
        const auto size = cursor.number<std::int32_t>();
        if (size == no_more) break;
        const auto kind = cursor.number<std::int32_t>();
        if (size < 0) cursor.fail(fmt::format("a chunk of {} bytes; the file is damaged", size));
        const auto end = cursor.position() + static_cast<std::uint64_t>(size);
        if (kind == metadata_list) read_list(cursor, end, content);
        else if (kind == points) read_points(cursor, end, content);
        else if (kind == metadata || kind == picture || kind == spacer) cursor.skip(static_cast<std::uint64_t>(size));
        else break;
    }
    return content;
}

std::string text_of(const pugi::xml_node& node, std::initializer_list<const char*> path) {
    auto at = node;
    for (const auto* step : path) at = at.child(step);
    return std::string(trimmed(at.child_value()));
}

/// Length of a step along an axis [m]: that of the channel times the calibration of the microscope.
struct Step {
    double length = 0.0;
    std::string unit;
};

Step step_of(const pugi::xml_node& channel, const pugi::xml_node& calibration, char axis, const bytes::Source& source) {
    const auto parameter = fmt::format("commonparam:{}", axis), unit_name = fmt::format("commonphase:{}", axis);
    auto unit = text_of(channel, {"commonphase:pixelUnit", unit_name.c_str()});
    if (unit == "MICRO_METER") unit = "µm";
    const double length =
        bytes::xml_number(channel.child("commonphase:length").child(parameter.c_str()), 0.0, source, oir_name);
    const double factor = bytes::xml_number(calibration.child(parameter.c_str()), 1.0, source, oir_name);
    if (unit.empty() || !(length > 0.0) || !(factor > 0.0))
        throw FormatError(source.name, {},
                          fmt::format("OIR: image without a positive length or unit along {}: {} '{}' × {}", axis,
                                      length, unit, factor));
    return {length * factor * length_unit(unit, source).factor, unit};
}

Sample sample_of(const pugi::xml_node& definition, const bytes::Source& source) {
    const double bits = bytes::xml_number(definition.child("commonphase:bitCounts"), 0.0, source, oir_name);
    const double bytes =
        bytes::xml_number(definition.child("commonphase:depth"), bits > 8.0 ? 2.0 : 1.0, source, oir_name);
    if (bytes != 1.0 && bytes != 2.0)
        throw FormatError(source.name, {}, fmt::format("OIR: heights of {} bytes, expected 1 or 2", bytes));
    return bytes == 1.0 ? Sample::uint8 : Sample::uint16;
}

Index points_along(const pugi::xml_node& image, const char* direction, const bytes::Source& source) {
    const double count = bytes::xml_number(image.child(direction), 0.0, source, oir_name);
    if (!(count >= 1.0) || count > 1e9)
        throw FormatError(source.name, {},
                          fmt::format("OIR: '{}' is {}, expected a number of points", direction, count));
    return static_cast<Index>(count);
}

Channel image_channel(const pugi::xml_node& channel, const pugi::xml_node& root, const OirContent& content,
                      const topography::Metadata& common, const bytes::Source& source, const ReadOptions& options) {
    const std::string identifier = channel.attribute("id").value();
    const auto definition = channel.child("commonphase:imageDefinition");
    const auto kind = text_of(definition, {"commonphase:imageType"});
    const auto image = root.child("commonimage:imageInfo");
    ChannelInfo info{.name = kind.empty() ? identifier : kind, .format = "oir", .metadata = common};
    info.metadata.attributes["channel"] = identifier;
    const Index nx = points_along(image, "commonimage:width", source),
                ny = points_along(image, "commonimage:height", source);
    info.shape = {nx, ny};
    if (kind != "HEIGHT") return non_height_channel(std::move(info));

    const auto calibration = root.child("commonimage:acquisition")
                                 .child("commonimage:microscopeConfiguration")
                                 .child("commonimage:pixelCalibration");
    const auto x = step_of(channel, calibration, 'x', source), y = step_of(channel, calibration, 'y', source),
               z = step_of(channel, calibration, 'z', source);
    info.name = "Height";
    info.size = {static_cast<double>(nx) * x.length, static_cast<double>(ny) * y.length};
    info.unit = z.unit;
    if (ny > 1) info.orientation = "rows from the top, as stored";
    const auto found = content.images.find(fmt::format("{}_{}", content.prefix, identifier));
    if (found == content.images.end())
        throw FormatError(
            source.name, {.offset = source.size},
            fmt::format("OIR: the file ends without the points of image '{}'; it is truncated or damaged", identifier));
    return raster_channel(std::move(info), bytes::joined(source, source.name, found->second),
                          {.nx = nx, .ny = ny, .sample = sample_of(definition, source)}, {.factor = z.length}, options);
}

Match detect_oir(std::string_view head, const bytes::Source&) {
    return head.starts_with(oir_signature) ? Match::yes : Match::no;
}

}  // namespace

std::vector<Channel> open_oir(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, oir_name);
    if (cursor.bytes(oir_signature.size()) != oir_signature)
        cursor.fail(fmt::format("the file does not begin with '{}'", oir_signature));
    if (const auto size = cursor.number_at<std::uint32_t>(32); size > source.size)
        throw FormatError(source.name, {.offset = source.size},
                          fmt::format("OIR: the file ends here, but it announces {} bytes; it is truncated", size));
    const auto content = content_of(cursor);
    if (content.properties.empty())
        throw FormatError(source.name, {.offset = source.size},
                          "OIR: no properties among the metadata; the file is damaged");
    const auto document = bytes::parsed_xml(content.properties, source, oir_name);
    topography::Metadata metadata;
    metadata.file = source.name;
    const auto root = document.child("lsmimage:imageProperties");
    if (!root) return {non_height_channel({.name = "camera picture", .format = "oir", .metadata = metadata})};
    metadata.acquisition_time = text_of(root, {"commonimage:general", "base:creationDateTime"});
    metadata.instrument.name = text_of(root, {"commonimage:microscope", "base:name"});
    metadata.instrument.type = "confocal";
    metadata.attributes["vendor"] = "Olympus";
    std::vector<Channel> channels;
    for (const auto& channel : root.child("commonimage:imageInfo")
                                   .child("commonimage:phase")
                                   .child("commonphase:group")
                                   .children("commonphase:channel"))
        channels.push_back(image_channel(channel, root, content, metadata, source, options));
    if (channels.empty()) throw FormatError(source.name, {}, "OIR: no image in the properties");
    return channels;
}

Format oir_format() {
    return {
        .identifier = "oir",
        .name = "Olympus OIR",
        .extensions = ".oir",
        .description = "images of Olympus' laser scanning microscopes: chunks of XML and points of one or two bytes",
        .heights =
            "raw times the length of a step along z times the microscope's calibration of z; no point is undefined",
        .orientation = "rows stored from the top",
        .not_read = "images of intensity and colour and camera pictures are listed",
        .reference = "the chunks as Gwyddion's oirfile.c and SurfaceTopography 1.27 describe them",
        .detect = detect_oir,
        .open = open_oir};
}

}  // namespace setae::formats
