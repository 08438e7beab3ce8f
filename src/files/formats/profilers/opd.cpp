// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "storage/raster.hpp"
#include "vca_tree.hpp"

// OPD files of Wyko Vision: two bytes, then a directory of 24-byte entries (name, type, length), then these blocks in
// sequence. Height = raw · Wavelength [nm] / Mult; columns are stored in sequence, each from the bottom.
namespace setae::formats {
namespace {

using namespace std::string_view_literals;
constexpr auto opd_signature =
    "\x01\0"
    "Directory"sv;
constexpr std::uint64_t directory_offset = 2, entry_bytes = 24, name_bytes = 16, array_header_bytes = 6;
constexpr std::uint64_t max_blocks = 65536;
constexpr int array_type = 3, text_type = 5, short_type = 6, float_type = 7, double_type = 8, long_type = 12,
              tagged_type = 15;
constexpr double greatest_integer = 32765.0, greatest_float = 9.9e37;

struct OpdBlock {
    std::string name;
    int type = 0;
    std::uint64_t offset = 0, length = 0;
};

struct OpdFile {
    std::vector<OpdBlock> blocks;

    [[nodiscard]] const OpdBlock* find(std::string_view name) const {
        const auto at =
            std::find_if(blocks.begin(), blocks.end(), [&](const OpdBlock& block) { return block.name == name; });
        return at == blocks.end() ? nullptr : &*at;
    }
};

OpdFile read_directory(bytes::Cursor& cursor) {
    cursor.seek(directory_offset + name_bytes);
    (void)cursor.number<std::uint16_t>();
    const auto length = static_cast<std::uint64_t>(std::max(cursor.number<std::int32_t>(), 0));
    if (length % entry_bytes != 0 || length < entry_bytes || length / entry_bytes > max_blocks)
        cursor.fail(
            fmt::format("a directory of {} bytes, expected a multiple of {} for at most {} blocks; the file is damaged",
                        length, entry_bytes, max_blocks));
    const auto count = length / entry_bytes - 1;
    auto offset = directory_offset + length;
    cursor.seek(directory_offset + entry_bytes);
    OpdFile file;
    for (std::uint64_t i = 0; i < count; ++i) {
        OpdBlock block{.name = cursor.text(name_bytes), .type = cursor.number<std::uint16_t>(), .offset = offset};
        block.length = static_cast<std::uint64_t>(
            std::max(cursor.number<std::int32_t>(), 0));  // negative: a block without content
        (void)cursor.number<std::uint16_t>();
        // Vision states 40 bytes for this number and writes 4
        if (block.name == "ImageModificat~0" && block.type == float_type)
            block.length = std::min<std::uint64_t>(block.length, sizeof(float));
        offset += block.length;
        if (offset > cursor.source().size)
            throw FormatError(
                cursor.source().name, {.offset = cursor.source().size},
                fmt::format("OPD: the file ends here, expected the end of block '{}' at byte {}; it is truncated",
                            block.name, offset));
        if (block.length > 0) file.blocks.push_back(std::move(block));
    }
    return file;
}

VcaItem tagged_value(const OpdBlock& block, bytes::Cursor& cursor) {
    cursor.seek(block.offset);
    return read_vca_value(cursor, block.name, block.offset + block.length);
}

std::optional<double> number(const OpdFile& file, std::string_view name, bytes::Cursor& cursor) {
    const auto* block = file.find(name);
    if (!block) return std::nullopt;
    cursor.seek(block->offset);
    if (block->type == short_type && block->length >= 2) return cursor.number<std::uint16_t>();
    if (block->type == float_type && block->length >= 4) return cursor.number<float>();
    if (block->type == double_type && block->length >= 8) return cursor.number<double>();
    if (block->type == long_type && block->length >= 4) return cursor.number<std::int32_t>();
    if (block->type == tagged_type) return tagged_value(*block, cursor).number;
    cursor.fail(
        fmt::format("block '{}' of type {} and {} bytes, expected a number", block->name, block->type, block->length));
}

std::string text(const OpdFile& file, std::string_view name, bytes::Cursor& cursor) {
    const auto* block = file.find(name);
    if (!block) return {};
    cursor.seek(block->offset);
    constexpr std::uint64_t longest_text = 1 << 16;
    if (block->type == text_type) return cursor.text(std::min(block->length, longest_text));
    return block->type == tagged_type ? tagged_value(*block, cursor).text : std::string();
}

/// Common properties of all channels of a file.
struct Common {
    ChannelInfo info;
    std::optional<double> pixel_size;  ///< [m]
    double aspect = 1.0;
    std::optional<double> scale;  ///< of heights [m]
    std::string primary;
};

Common common_of(const OpdFile& file, bytes::Cursor& cursor) {
    Common common;
    common.info.format = "opd";
    common.info.orientation = "columns from the left, each from the bottom; turned";
    auto& metadata = common.info.metadata;
    metadata.instrument.type = "interferometer";
    const auto date = text(file, "Date", cursor), time = text(file, "Time", cursor);
    metadata.acquisition_time = date.empty() || time.empty() ? date + time : date + " " + time;
    const std::pair<const char*, const char*> kept[] = {{"title", "Title"},
                                                        {"time_stamp", "TimeStamp"},
                                                        {"measurement_mode", "MeasMode"},
                                                        {"data_set", "DataSetName"},
                                                        {"comment", "Note"}};
    for (const auto& [key, name] : kept)
        if (auto value = text(file, name, cursor); !value.empty()) metadata.attributes[key] = std::move(value);
    if (const auto magnification = number(file, "Magnification", cursor))
        metadata.attributes["magnification"] = fmt::format("{}", *magnification);
    if (const auto size = number(file, "Pixel_size", cursor)) common.pixel_size = *size * units::mm;
    common.aspect = number(file, "Aspect", cursor).value_or(1.0);
    const auto multiplier = number(file, "Mult", cursor).value_or(1.0);
    if (const auto wavelength = number(file, "Wavelength", cursor)) common.scale = *wavelength * units::nm / multiplier;
    common.primary = text(file, "PrimaryData2D", cursor);
    return common;
}

bool holds_heights(const std::string& name, const Common& common) {
    static constexpr std::array names{"RAW DATA", "RAW_DATA", "OPD", "Raw", "SAMPLE_DATA"};
    return name == common.primary || std::find(names.begin(), names.end(), name) != names.end();
}

Channel array_channel(const OpdBlock& block, const Common& common, bytes::Cursor& cursor, const ReadOptions& options) {
    if (block.length < array_header_bytes) {
        cursor.seek(block.offset);
        cursor.fail(fmt::format("array '{}' of {} bytes has no space for its dimensions; the file is damaged",
                                block.name, block.length));
    }
    cursor.seek(block.offset);
    Raster raster{.offset = block.offset + array_header_bytes, .columns = true, .bottom_up = true};
    raster.nx = cursor.number<std::uint16_t>();
    raster.ny = cursor.number<std::uint16_t>();
    const auto bytes = cursor.number<std::uint16_t>();
    if (bytes != 1 && bytes != 2 && bytes != 4)
        cursor.fail(fmt::format("array '{}' has values of {} bytes, expected 1, 2 or 4", block.name, bytes));
    raster.sample = bytes == 1 ? Sample::uint8 : bytes == 2 ? Sample::int16 : Sample::float32;
    if (array_header_bytes + static_cast<std::uint64_t>(raster.nx) * static_cast<std::uint64_t>(raster.ny) * bytes >
        block.length)
        cursor.fail(
            fmt::format("array '{}' announces {} × {} values of {} bytes in a block of {} bytes; the file is damaged",
                        block.name, raster.nx, raster.ny, bytes, block.length));
    auto info = common.info;
    info.name = info.metadata.name = block.name;
    info.shape = {raster.nx, raster.ny};
    if (common.pixel_size)
        info.size = {static_cast<double>(raster.nx) * *common.pixel_size,
                     static_cast<double>(raster.ny) * *common.pixel_size * common.aspect};
    if (!holds_heights(block.name, common)) {
        require_raster(raster, cursor.source(), info.format);
        return non_height_channel(std::move(info));
    }
    if (!common.scale || !std::isfinite(*common.scale))
        cursor.fail(fmt::format(
            "heights '{}' without a usable scale, expected the blocks 'Wavelength' and, above 0, 'Mult'", block.name));
    info.unit = "nm";
    RawScale scale{.factor = *common.scale};
    if (bytes == 2) scale.greatest = greatest_integer;
    if (bytes == 4) scale.greatest = greatest_float;
    return raster_channel(std::move(info), cursor.source(), raster, scale, options);
}

Match detect_opd(std::string_view head, const bytes::Source&) {
    return head.starts_with(opd_signature) ? Match::yes : Match::no;
}

std::vector<Channel> open_opd(const bytes::Source& source, const ReadOptions& options) {
    constexpr std::size_t max_channels = 1000;
    bytes::Cursor cursor(source, "OPD");
    const auto file = read_directory(cursor);
    const auto common = common_of(file, cursor);
    std::vector<Channel> channels;
    for (const auto& block : file.blocks) {
        if (channels.size() == max_channels)
            cursor.fail(fmt::format("more than {} arrays, which is not possible; the file is damaged", max_channels));
        if (block.type == array_type) channels.push_back(array_channel(block, common, cursor, options));
        if (block.type != tagged_type) continue;
        const auto item = tagged_value(block, cursor);
        if (item.type == VcaType::map_data && item.find("Matrix"))
            channels.push_back(vca_map_channel(item, common.info, source, options));
    }
    if (channels.empty())
        throw FormatError(source.name, {.offset = source.size},
                          "OPD: no array among the blocks; the file contains no map");
    return channels;
}

}  // namespace

Format opd_format() {
    return {
        .identifier = "opd",
        .name = "OPD",
        .extensions = ".opd",
        .description =
            "Wyko Vision (Veeco, Bruker): a directory of blocks; every array of 1, 2 or 4 bytes a value is listed",
        .heights =
            "raw times Wavelength over Mult; 32766 and above (2 bytes) or 1e38 and above (4 bytes) are undefined, no value of 1 byte is",
        .orientation = "columns stored from the left, each from the bottom; turned",
        .not_read = "intensity, modulation and other arrays are listed without being read",
        .reference = "Gwyddion's module opdfile",
        .tested_on_real_files = true,
        .detect = detect_opd,
        .open = open_opd};
}

}  // namespace setae::formats
