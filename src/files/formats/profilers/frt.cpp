// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/bytes/unix_time.hpp"
#include "setae/core/errors.hpp"
#include "storage/raster.hpp"

// FRT files of MicroProf: a signature with its version, then tagged blocks; their lengths take 4 bytes in version 1.00
// and 8 in 1.01. One block is a single map; newer files repeat it in a block of several images.
namespace setae::formats {
namespace {

constexpr std::string_view frt_signature = "FRTM_GLIDERV";
constexpr std::uint64_t version_bytes = 4;
constexpr double undefined_raw = 1.0;

enum FrtTag : std::uint16_t {
    single_map = 0x0b,
    description = 0x65,
    grid = 0x66,
    extent = 0x67,
    sensor = 0x6c,
    times = 0x72,
    parameter_set = 0x77,
    images = 0x7d,
    serial_number = 0x8e
};

struct FrtBlock {
    std::uint64_t offset = 0, length = 0;
};

struct FrtFile {
    std::map<std::uint16_t, FrtBlock> blocks;

    [[nodiscard]] const FrtBlock* find(std::uint16_t tag, std::uint64_t min_bytes = 0) const {
        const auto at = blocks.find(tag);
        return at == blocks.end() || at->second.length < min_bytes ? nullptr : &at->second;
    }
};

/// Type of an image, as flags, and place of its values.
struct FrtImage {
    std::uint32_t type = 0;
    std::uint32_t bits = 0;
    Raster raster;
};

constexpr std::uint32_t type_mask = 0xffdf, topography = 0x0004, thickness = 0x0080, sample_thickness = 0x0800,
                        afm = 0x1000, bottom_sensor = 0x10000000, filtered = 0x20, fit = 0x4000;

std::string type_name(std::uint32_t type) {
    static constexpr std::array<std::pair<std::uint32_t, const char*>, 12> names{
        {{0x0001, "Piezo"},
         {0x0002, "Intensity"},
         {topography, "Topography"},
         {0x0008, "Real part"},
         {0x0010, "Imaginary part"},
         {0x0040, "Camera"},
         {thickness, "Thickness"},
         {0x0200, "Absolute value"},
         {0x0400, "Phase"},
         {sample_thickness, "Sample thickness"},
         {afm, "AFM"},
         {0x2000, "Quality"}}};
    for (const auto& [value, name] : names)
        if ((type & type_mask) == value) return name;
    return fmt::format("Type {:#x}", type & type_mask);
}

bool is_height(std::uint32_t type) {
    const auto kind = type & type_mask;
    return kind == topography || kind == thickness || kind == sample_thickness || kind == afm;
}

FrtFile read_blocks(bytes::Cursor& cursor) {
    cursor.seek(frt_signature.size());
    const auto version = cursor.text(version_bytes);
    if (version != "1.00" && version != "1.01")
        cursor.fail(fmt::format("version '{}', expected 1.00 or 1.01", version));
    const auto count = cursor.number<std::uint16_t>();
    FrtFile file;
    for (std::uint16_t i = 0; i < count; ++i) {
        const auto tag = cursor.number<std::uint16_t>();
        const auto length = version == "1.00" ? cursor.number<std::uint32_t>() : cursor.number<std::uint64_t>();
        file.blocks.emplace(tag, FrtBlock{cursor.position(), length});
        cursor.skip(length);
    }
    return file;
}

FrtImage image_of(bytes::Cursor& cursor, std::uint32_t type) {
    FrtImage image{.type = type, .raster = {.bottom_up = true}};
    image.raster.nx = cursor.number<std::uint32_t>();
    image.raster.ny = cursor.number<std::uint32_t>();
    image.bits = cursor.number<std::uint32_t>();
    if (image.bits != 16 && image.bits != 32)
        cursor.fail(fmt::format("values of {} bits, expected 16 or 32", image.bits));
    image.raster.sample = image.bits == 16 ? Sample::uint16 : Sample::int32;
    return image;
}

/// Images of the block of several images.
std::vector<FrtImage> images_of(const FrtBlock& block, bytes::Cursor& cursor) {
    constexpr std::uint64_t identifiers_bytes = 8, header_bytes = 16;
    constexpr std::size_t max_images = 256;
    std::vector<FrtImage> found;
    const auto end = block.offset + block.length;
    cursor.seek(block.offset);
    cursor.skip(std::min(identifiers_bytes, block.length));
    while (cursor.position() + header_bytes <= end) {
        if (found.size() == max_images)
            cursor.fail(fmt::format("more than {} images; the file is damaged", max_images));
        auto image = image_of(cursor, cursor.number<std::uint32_t>());
        image.raster.offset = cursor.position();
        require_raster(image.raster, cursor.source(), "FRT");
        const auto bytes = static_cast<std::uint64_t>(image.raster.nx) * static_cast<std::uint64_t>(image.raster.ny) *
                           bytes_of(image.raster.sample);
        if (bytes > end - image.raster.offset)
            cursor.fail(fmt::format("an image of {} × {} values extends beyond its block; the file is damaged",
                                    image.raster.nx, image.raster.ny));
        cursor.skip(bytes);
        found.push_back(image);
    }
    return found;
}

/// Heights first. The single map is used if none of several images is one: otherwise it is a duplicate.
std::vector<FrtImage> all_images(const FrtFile& file, bytes::Cursor& cursor) {
    std::vector<FrtImage> found;
    if (const auto* block = file.find(FrtTag::images)) found = images_of(*block, cursor);
    std::stable_partition(found.begin(), found.end(), [](const FrtImage& image) { return is_height(image.type); });
    if (!found.empty() && is_height(found.front().type)) return found;
    const auto* map = file.find(FrtTag::single_map);
    const auto* points = file.find(FrtTag::grid, 12);
    if (!map || !points) return found;
    cursor.seek(points->offset);
    auto image = image_of(cursor, topography);
    image.raster.offset = map->offset;
    require_raster(image.raster, cursor.source(), "FRT");
    if (static_cast<std::uint64_t>(image.raster.nx) * static_cast<std::uint64_t>(image.raster.ny) *
            bytes_of(image.raster.sample) >
        map->length)
        cursor.fail(fmt::format("a map of {} × {} values of {} bits in a block of {} bytes; the file is damaged",
                                image.raster.nx, image.raster.ny, image.bits, map->length));
    found.insert(found.begin(), image);
    return found;
}

std::string counted_text(const FrtBlock& block, bytes::Cursor& cursor) {
    cursor.seek(block.offset);
    const auto length = cursor.number<std::uint32_t>();
    return length <= block.length - sizeof(std::uint32_t) ? cursor.text(length) : std::string();
}

topography::Metadata metadata_of(const FrtFile& file, bytes::Cursor& cursor) {
    topography::Metadata metadata;
    metadata.instrument = {.name = "FRT MicroProf", .type = "optical"};
    constexpr std::uint64_t longest_text = 1 << 16;
    for (const auto& [key, tag] :
         {std::pair{"description", FrtTag::description}, {"parameter_set", FrtTag::parameter_set}}) {
        const auto* block = file.find(tag);
        if (!block) continue;
        cursor.seek(block->offset);
        if (auto text = cursor.text(std::min(block->length, longest_text)); !text.empty())
            metadata.attributes[key] = std::move(text);
    }
    if (const auto* block = file.find(FrtTag::serial_number, sizeof(std::uint32_t)))
        if (auto text = counted_text(*block, cursor); !text.empty())
            metadata.attributes["serial_number"] = std::move(text);
    if (const auto* block = file.find(FrtTag::times, sizeof(std::uint32_t))) {
        constexpr std::uint32_t unset = 0xffffffff;
        const auto started = cursor.number_at<std::uint32_t>(block->offset);
        if (started != 0 && started != unset) metadata.acquisition_time = bytes::utc_text(started);
    }
    return metadata;
}

Match detect_frt(std::string_view head, const bytes::Source&) {
    return head.starts_with(frt_signature) ? Match::yes : Match::no;
}

std::vector<Channel> open_frt(const bytes::Source& source, const ReadOptions& options) {
    bytes::Cursor cursor(source, "FRT");
    const auto file = read_blocks(cursor);
    ChannelInfo common;
    common.format = "frt";
    common.orientation = "rows from the bottom, turned; not stated in the file, as Gwyddion shows it";
    common.metadata = metadata_of(file, cursor);
    if (const auto* block = file.find(FrtTag::extent, 16)) {
        const double width = std::abs(cursor.number_at<double>(block->offset)),
                     height = std::abs(cursor.number_at<double>(block->offset + 8));
        if (width > 0.0 && height > 0.0) common.size = {width, height};
    }
    std::optional<double> step;
    if (const auto* block = file.find(FrtTag::sensor, 12)) step = cursor.number_at<double>(block->offset + 4);
    std::vector<Channel> channels;
    for (const auto& image : all_images(file, cursor)) {
        auto info = common;
        info.name = type_name(image.type);
        if (image.type & bottom_sensor) info.name += " (bottom sensor)";
        if (image.type & filtered && (image.type & type_mask) < fit) info.name += " (filtered)";
        info.metadata.name = info.name;
        info.shape = {image.raster.nx, image.raster.ny};
        if (!is_height(image.type)) {
            channels.push_back(non_height_channel(std::move(info)));
            continue;
        }
        if (step) info.unit = "m";
        channels.push_back(raster_channel(std::move(info), source, image.raster,
                                          {.factor = step.value_or(1.0), .undefined = {undefined_raw}}, options));
    }
    if (channels.empty()) throw FormatError(source.name, {.offset = source.size}, "FRT: no map among the blocks");
    return channels;
}

}  // namespace

Format frt_format() {
    return {.identifier = "frt",
            .name = "FRT",
            .extensions = ".frt",
            .description =
                "FRT MicroProf, versions 1.00 and 1.01: tagged blocks with one map or several images of 16 or 32 bits",
            .heights = "raw times the sensor's step in m; raw 1 is undefined",
            .orientation = "rows stored from the bottom, turned; not stated in the file, as Gwyddion shows it",
            .not_read = "intensity, camera and other images are listed without being read",
            .reference = "Gwyddion's module microprof",
            .tested_on_real_files = true,
            .detect = detect_frt,
            .open = open_frt};
}

}  // namespace setae::formats
