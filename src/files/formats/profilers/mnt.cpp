// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/expand.hpp"
#include "setae/bytes/expanded_source.hpp"
#include "setae/bytes/ole_file.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/tables/header.hpp"
#include "storage/point_mask.hpp"
#include "storage/raster.hpp"

// Digital Surf Mountains documents: a compound file whose stream "ScopedContents" is a tree of entries (tag of 2 bytes,
// size of 8, content). A measured surface (class 9012) has two lateral axes, an axis of heights and an array of
// integers in zlib blocks: height = count · step + origin. Computed layers store the processing steps, no heights.
namespace setae::formats {
namespace {

constexpr const char* mnt_name = "MNT";
constexpr const char* contents_stream = "ScopedContents";
constexpr std::uint16_t base = 0xffff;  ///< tag of the inherited part of an entry
enum Class : std::uint32_t {
    surface_object = 9012,
    surface_data = 9062,
    mask_object = 9056,
    mask_array = 9048,
    height_array = 9049
};
constexpr std::uint8_t mask_measured = 9;
constexpr std::uint64_t entry_header = 10;

/// Content of an entry in the stream.
struct MntEntry {
    std::uint64_t offset = 0, size = 0;
};

/// Reads the tree; a missing entry is empty, an entry that leaves its parent is refused.
class Tree {
public:
    explicit Tree(const bytes::Source& stream) : cursor_(stream, mnt_name) {}

    [[nodiscard]] const bytes::Source& stream() const { return cursor_.source(); }

    std::optional<MntEntry> child(const MntEntry& parent, std::uint16_t tag) {
        const auto end = parent.offset + parent.size;
        for (auto at = parent.offset; end - at >= entry_header;) {
            const auto [found, entry] = entry_at(at, end);
            if (found == tag) return entry;
            at = entry.offset + entry.size;
        }
        return std::nullopt;
    }
    std::optional<MntEntry> at(MntEntry entry, std::initializer_list<std::uint16_t> path) {
        for (const auto tag : path) {
            const auto next = child(entry, tag);
            if (!next) return std::nullopt;
            entry = *next;
        }
        return entry;
    }
    /// Objects of a document: the length of each entry is written twice before it.
    std::vector<MntEntry> objects(const MntEntry& list) {
        std::vector<MntEntry> entries;
        const auto end = list.offset + list.size;
        for (auto at = list.offset; end - at >= entry_header + 8;) {
            entries.push_back(entry_at(at + 8, end).second);
            at = entries.back().offset + entries.back().size;
        }
        return entries;
    }
    template <class T>
    std::optional<T> number(const MntEntry& entry, std::initializer_list<std::uint16_t> path) {
        const auto found = at(entry, path);
        if (!found || found->size != sizeof(T)) return std::nullopt;
        return cursor_.number_at<T>(found->offset);
    }
    /// UTF-16 after a byte 4.
    std::string text(const MntEntry& entry, std::initializer_list<std::uint16_t> path) {
        constexpr std::uint64_t longest = 4096;
        const auto found = at(entry, path);
        if (!found || found->size < 3 || found->size > longest) return {};
        cursor_.seek(found->offset);
        if (cursor_.number<std::uint8_t>() != 4) return {};
        auto characters = bytes::decoded(cursor_.bytes(found->size - 1), bytes::Encoding::utf16);
        characters.resize(std::min(characters.find('\0'), characters.size()));
        return std::string(trimmed(characters));
    }
    bool is(const MntEntry& entry, Class wanted) { return number<std::uint32_t>(entry, {1, 1}) == wanted; }

private:
    std::pair<std::uint16_t, MntEntry> entry_at(std::uint64_t at, std::uint64_t end) {
        cursor_.seek(at);
        const auto tag = cursor_.number<std::uint16_t>();
        const auto size = cursor_.number<std::uint64_t>();
        if (size > end - at - entry_header)
            cursor_.fail(
                fmt::format("entry {:#06x} has {} bytes, more than its parent; the file is damaged", tag, size));
        return {tag, {at + entry_header, size}};
    }

    bytes::Cursor cursor_;
};

[[noreturn]] void broken_mnt(const bytes::Source& stream, std::uint64_t offset, const std::string& what) {
    throw FormatError(stream.name, {.offset = offset}, fmt::format("{}: {}", mnt_name, what));
}

/// A zlib block of an array.
struct StoredBlock {
    std::uint64_t first = 0, count = 0;  ///< elements
    std::uint64_t offset = 0, size = 0;  ///< in the stream
};

std::vector<StoredBlock> blocks_of(const bytes::Source& stream, const MntEntry& data, std::uint64_t elements) {
    std::vector<StoredBlock> blocks;
    bytes::Cursor cursor(stream, mnt_name, data.offset + 8);
    const auto end = data.offset + data.size;
    while (cursor.position() < end) {
        StoredBlock block;
        block.first = cursor.number<std::uint64_t>();
        block.count = cursor.number<std::uint32_t>();
        block.size = cursor.number<std::uint32_t>();
        block.offset = cursor.position();
        cursor.skip(block.size);
        if (cursor.position() > end)
            broken_mnt(stream, block.offset, "a block of heights is longer than its array; the file is damaged");
        blocks.push_back(block);
    }
    std::sort(blocks.begin(), blocks.end(),
              [](const StoredBlock& left, const StoredBlock& right) { return left.first < right.first; });
    std::uint64_t next = 0;
    for (const auto& block : blocks) {
        if (block.first != next)
            broken_mnt(stream, block.offset,
                       fmt::format("a block begins at point {}, expected {}; the file is damaged", block.first, next));
        next += block.count;
    }
    if (next != elements)
        broken_mnt(stream, end, fmt::format("blocks of {} points, expected {}; the file is damaged", next, elements));
    return blocks;
}

std::string expanded_blocks(const bytes::Source& stream, const std::vector<StoredBlock>& blocks, std::uint64_t elements,
                            std::uint64_t element_bytes) {
    std::string array(elements * element_bytes, '\0');
    parallel::for_each_index(blocks.size(), {}, [&](std::size_t i) {
        const auto& block = blocks[i];
        const auto part = bytes::inflated(stream.bytes(block.offset, block.size), stream, block.offset, mnt_name);
        if (part.size() != block.count * element_bytes)
            broken_mnt(stream, block.offset,
                       fmt::format("a block of {} points has {} bytes, expected {}", block.count, part.size(),
                                   block.count * element_bytes));
        std::memcpy(array.data() + block.first * element_bytes, part.data(), part.size());
    });
    return array;
}

/// An array of numbers, expanded when it is read.
struct Array {
    std::uint64_t element_bytes = 0;
    bytes::Source content;
};

Array array_of(Tree& tree, const MntEntry& object, std::uint64_t elements) {
    const auto& stream = tree.stream();
    const auto count = tree.number<std::uint32_t>(object, {2, 1});
    const auto data = tree.at(object, {2, 2});
    if (!data || data->size < 8 || count != elements)
        broken_mnt(
            stream, object.offset,
            fmt::format("an array of {} elements, expected {}; the file is damaged", count.value_or(0), elements));
    const auto bytes = bytes::Cursor(stream, mnt_name).number_at<std::uint64_t>(data->offset);
    if (elements == 0 || bytes % elements != 0 || bytes > bytes::max_expanded(data->size))
        broken_mnt(stream, data->offset,
                   fmt::format("{} bytes announced for {} elements in {} compressed bytes; the file is damaged", bytes,
                               elements, data->size));
    const auto element_bytes = bytes / elements;
    return {element_bytes, bytes::expanded_source(stream.name, bytes, [stream, data = *data, elements, element_bytes] {
                return expanded_blocks(stream, blocks_of(stream, data, elements), elements, element_bytes);
            })};
}

/// Step and origin of an axis in their own units, as SI factors if they are lengths.
struct MntAxis {
    double step = 0.0, origin = 0.0;  ///< [m] where `is_length`
    bool is_length = false;
    std::string unit;
};

MntAxis axis_of(Tree& tree, const MntEntry& scale) {
    MntAxis axis;
    const auto step = tree.number<double>(scale, {1});
    const auto step_unit = tree.text(scale, {2});
    const auto shown_unit = tree.text(scale, {3});
    axis.unit = shown_unit.empty() ? step_unit : shown_unit;
    const auto step_factor = tables::try_parse_unit(step_unit), shown_factor = tables::try_parse_unit(axis.unit);
    if (!step || !std::isfinite(*step))
        broken_mnt(tree.stream(), scale.offset, "an axis without its step; the file is damaged");
    axis.is_length = !step_unit.empty() && step_factor && shown_factor && step_factor->dimension == dimension::length &&
                     shown_factor->dimension == dimension::length;
    if (!axis.is_length) return axis;
    axis.step = *step * step_factor->factor;
    axis.origin = tree.number<double>(scale, {5}).value_or(0.0) * shown_factor->factor;
    return axis;
}

topography::Metadata metadata_of(Tree& tree, const MntEntry& document, const bytes::Source& file) {
    topography::Metadata metadata;
    metadata.file = file.name;
    std::string version;
    for (std::uint16_t part = 1; part <= 4; ++part)
        if (const auto number = tree.number<std::uint32_t>(document, {0xc8, part}))
            version += fmt::format("{}{}", version.empty() ? "" : ".", *number);
    if (!version.empty()) metadata.attributes["software_version"] = version;
    return metadata;
}

/// The map of a surface object; empty for objects without a map.
std::optional<Channel> surface_channel(Tree& tree, const MntEntry& object, const topography::Metadata& common,
                                       const ReadOptions& options) {
    if (!tree.is(object, surface_object)) return std::nullopt;
    const auto data = tree.at(object, {2, 1});
    if (!data || !tree.is(*data, surface_data)) return std::nullopt;
    const auto measurement = tree.at(*data, {2, base});
    const auto grid = measurement ? tree.child(*measurement, base) : std::nullopt;
    const auto heights = measurement ? tree.child(*measurement, 1) : std::nullopt;
    const auto x = grid ? tree.at(*grid, {1, base}) : std::nullopt, y = grid ? tree.at(*grid, {2, base}) : std::nullopt;
    const auto x_scale = x ? tree.child(*x, base) : std::nullopt, y_scale = y ? tree.child(*y, base) : std::nullopt;
    const auto z_scale = measurement ? tree.at(*measurement, {2, base}) : std::nullopt;
    if (!x_scale || !y_scale || !z_scale || !heights || !tree.is(*heights, height_array)) return std::nullopt;

    const auto nx = tree.number<std::uint32_t>(*x, {1}).value_or(0),
               ny = tree.number<std::uint32_t>(*y, {1}).value_or(0);
    const auto x_axis = axis_of(tree, *x_scale), y_axis = axis_of(tree, *y_scale), z_axis = axis_of(tree, *z_scale);
    ChannelInfo info{
        .name = tree.text(*grid, {base, base, 1}), .format = "mnt", .unit = z_axis.unit, .metadata = common};
    const auto title = tree.text(object, {2, base, 4});
    if (info.name.empty()) info.name = title.empty() ? "surface" : title;
    if (!title.empty()) info.metadata.attributes["title"] = title;
    if (x_axis.is_length && y_axis.is_length) info.size = {nx * std::abs(x_axis.step), ny * std::abs(y_axis.step)};
    if (!z_axis.is_length) {
        info.shape = {nx, ny};
        return non_height_channel(std::move(info));
    }
    if (ny > 1) info.orientation = "rows from the top, as stored; not stated in the file, taken as Mountains shows it";
    const auto counts = array_of(tree, *heights, std::uint64_t{nx} * ny);
    if (counts.element_bytes != 2 && counts.element_bytes != 4)
        broken_mnt(tree.stream(), heights->offset,
                   fmt::format("heights of {} bytes each, expected 2 or 4", counts.element_bytes));
    const Raster raster{.nx = nx, .ny = ny, .sample = counts.element_bytes == 2 ? Sample::int16 : Sample::int32};
    auto channel = raster_channel(std::move(info), counts.content, raster,
                                  {.factor = z_axis.step, .offset = z_axis.origin}, options);
    const auto mask = tree.child(*grid, 3);
    if (!mask || !tree.is(*mask, mask_object) || ny == 1) return channel;
    const auto array = tree.at(*mask, {2, 5});
    if (!array || !tree.is(*array, mask_array))
        broken_mnt(tree.stream(), mask->offset, "a mask without its points; the file is damaged");
    const std::uint64_t row = std::uint64_t{nx} + 2;  // the mask has a border of one point
    return masked(std::move(channel), {.source = array_of(tree, *array, row * (std::uint64_t{ny} + 2)).content,
                                       .offset = row + 1,
                                       .row_distance = row,
                                       .defined = mask_measured});
}

Match detect_mnt(std::string_view head, const bytes::Source& source) {
    if (!bytes::is_ole(head)) return Match::no;
    try {
        return bytes::OleFile(source, mnt_name).has(contents_stream) ? Match::yes : Match::no;
    } catch (const FormatError&) {
        return Match::maybe;  // reports the problem of the file
    }
}

std::vector<Channel> open_mnt(const bytes::Source& source, const ReadOptions& options) {
    const bytes::OleFile file(source, mnt_name);
    for (const auto& stream : file.names())
        (void)file.stream(stream);  // a truncated file is refused for any truncated stream
    Tree tree(file.stream(contents_stream));
    const auto& stream = tree.stream();
    if (stream.size < 8) broken_mnt(source, 0, "its contents are empty");
    const auto document = tree.child({8, stream.size - 8}, 1);
    const auto list = document ? tree.at(*document, {0x2bd, 2, 1}) : std::nullopt;
    if (!list) broken_mnt(source, 0, "no list of objects; the file is damaged");
    const auto common = metadata_of(tree, *document, source);
    std::vector<Channel> channels;
    for (const auto& entry : tree.objects(*list))
        if (auto channel = surface_channel(tree, entry, common, options)) channels.push_back(std::move(*channel));
    if (channels.empty())
        throw FormatError(source.name, {.offset = 0},
                          "MNT: no measured surface in the document; export one as SUR from Mountains");
    return channels;
}

}  // namespace

Format mnt_format() {
    return {
        .identifier = "mnt",
        .name = "Digital Surf Mountains",
        .extensions = ".mnt",
        .description = "documents of MountainsMap: the surfaces as measured, each a channel",
        .heights =
            "count times step plus origin; points that the mask does not call measured are undefined, a count of 0 is a height",
        .orientation = "rows stored from the top",
        .not_read =
            "layers that Mountains computes from the measured surface (levelled, filtered …), profiles, views and results are left out",
        .reference =
            "[MS-CFB] for the container; its tree of entries as SurfaceTopography 1.27's MNT reader describes it",
        .tested_on_real_files = true,
        .detect = detect_mnt,
        .open = open_mnt};
}

}  // namespace setae::formats
