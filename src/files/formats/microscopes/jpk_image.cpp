// SPDX-License-Identifier: GPL-3.0-or-later
#include "jpk_image.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "probe_channels.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "storage/tiff_pixels.hpp"

// TIFF with private tags. The first page is a thumbnail and describes the scan; each further page is a channel. A
// channel has slots, conversions of its integers (volts, nominal height, calibrated height …): value = multiplier · raw
// + offset in the unit of the slot.
namespace setae::formats {
namespace {

enum JpkTag : std::uint16_t {
    program_version = 0x8000,
    start_date = 0x8003,
    sample_name = 0x8007,
    spring_constant = 0x8011,
    feedback_mode = 0x8030,
    grid_width = 0x8042,
    grid_height = 0x8043,
    grid_angle = 0x8044,
    grid_reflected = 0x8045,
    motion = 0x804b,
    channel_name = 0x8050,
    channel_retrace = 0x8051,
    channel_fancy_name = 0x8052,
    channel_properties = 0x8053,
    last_curve = 0x8062,
    curve_settings = 0x8065,
    slot_count = 0x8080,
    default_slot = 0x8081,
    first_slot = 0x8090
};
constexpr std::uint16_t slot_distance = 0x30;
constexpr std::size_t max_slots = 64, max_pages = 300;

/// One conversion of the integers of a channel.
struct Slot {
    std::string name, unit;
    double factor = 0.0, offset = 0.0;
};

/// The slots whose scale is linear; others (raw, or calibrated by a curve) give no heights.
std::vector<Slot> linear_slots(const bytes::TiffFile& file, const bytes::TiffPage& page) {
    std::vector<Slot> slots;
    const auto announced = std::clamp(file.number(page, slot_count).value_or(0.0), 0.0, static_cast<double>(max_slots));
    for (std::size_t k = 0; k < static_cast<std::size_t>(announced); ++k) {
        const auto tag = [&](std::uint16_t which) {
            return static_cast<std::uint16_t>(first_slot + k * slot_distance + which);
        };
        const auto factor = file.number(page, tag(0x14)), offset = file.number(page, tag(0x15));
        if (file.text(page, tag(0x13)) != "LinearScaling" || !factor || !std::isfinite(*factor) ||
            !std::isfinite(offset.value_or(0.0)))
            continue;
        slots.push_back({file.text(page, tag(0)), file.text(page, tag(0x12)), *factor, offset.value_or(0.0)});
    }
    return slots;
}

/// The slot to read: the calibrated one if it is a length, otherwise the default of the file, otherwise any other.
const Slot* chosen_slot(const std::vector<Slot>& slots, const std::string& preferred) {
    const auto named = [&](std::string_view name) {
        return std::find_if(slots.begin(), slots.end(), [&](const Slot& slot) { return slot.name == name; });
    };
    if (const auto found = named("calibrated"); found != slots.end() && holds_heights({}, found->unit)) return &*found;
    if (const auto found = named(preferred); found != slots.end()) return &*found;
    return slots.empty() ? nullptr : &slots.back();
}

/// A line "key : value" of the properties of a page.
std::string property(const std::string& properties, std::string_view key) {
    for (const auto line : bytes::split_lines(properties)) {
        const auto colon = line.find(" : ");
        if (colon != std::string_view::npos && line.substr(0, colon) == key)
            return std::string(trimmed(line.substr(colon + 3)));
    }
    return {};
}

/// "Height (measured, trace)"; images of force curves append the computed quantity if it is not the channel itself.
std::string name_of(const bytes::TiffFile& file, const bytes::TiffPage& page, const std::string& properties) {
    auto name = file.text(page, channel_fancy_name);
    if (name.empty()) name = file.text(page, channel_name);
    const auto algorithm = property(properties, "algorithm.object-name.fancy-name");
    std::string full = name;
    if (const auto retrace = file.number(page, channel_retrace)) {
        const char* direction = *retrace != 0.0 ? "retrace" : "trace";
        full = name.ends_with(')') ? fmt::format("{}, {})", name.substr(0, name.size() - 1), direction)
                                   : fmt::format("{} ({})", name, direction);
    }
    return algorithm.empty() || algorithm == name ? full : fmt::format("{}: {}", full, algorithm);
}

void keep(topography::Metadata& metadata, const char* key, const std::string& value) {
    if (!value.empty() && value != "<empty>") metadata.attributes[key] = value;
}

topography::Metadata metadata_of(const bytes::TiffFile& file) {
    const auto& first = file.pages.front();
    topography::Metadata metadata;
    metadata.instrument.type = "afm";
    const auto head = property(file.text(first, curve_settings), "metadata.jpkspm.head.fancyname");
    metadata.instrument.name = head.empty() ? "JPK" : "JPK " + head;
    metadata.acquisition_time = file.text(first, start_date);
    keep(metadata, "software_version", file.text(first, program_version));
    keep(metadata, "sample", file.text(first, sample_name));
    keep(metadata, "feedback_mode", file.text(first, feedback_mode));
    keep(metadata, "scan_direction", file.text(first, motion));
    if (const auto angle = file.number(first, grid_angle))
        metadata.attributes["scan_angle"] = fmt::format("{} rad", *angle + 0.0);
    if (const auto stiffness = file.number(first, spring_constant))
        metadata.attributes["spring_constant"] = fmt::format("{} N/m", *stiffness);
    return metadata;
}

Channel channel_of(const bytes::TiffFile& file, const bytes::TiffPage& page, ChannelInfo info,
                   const ReadOptions& options) {
    const auto properties = file.text(page, channel_properties);
    info.name = name_of(file, page, properties);
    info.metadata.name = info.name;
    if (const auto retrace = file.number(page, channel_retrace))
        info.metadata.attributes["line_direction"] = *retrace != 0.0 ? "retrace" : "trace";
    const auto slots = linear_slots(file, page);
    const auto* slot = chosen_slot(slots, file.text(page, default_slot));
    std::string names;
    for (const auto& each : slots) names += fmt::format("{}{} [{}]", names.empty() ? "" : ", ", each.name, each.unit);
    keep(info.metadata, "slots", names);
    if (slot) info.metadata.attributes["slot"] = slot->name;
    auto pixels = tiff_pixels(file, page);
    info.shape = {pixels.raster.nx, pixels.raster.ny};
    info.unit = slot ? slot->unit : "";
    if (!slot || !holds_heights(info.name, info.unit)) return non_height_channel(std::move(info));
    const auto& first = file.pages.front();
    const bool reflected =
        file.number(page, grid_reflected).value_or(file.number(first, grid_reflected).value_or(0.0)) != 0.0;
    pixels.raster.bottom_up = !reflected;
    info.orientation = reflected ? "rows from the top of a reflected grid, as stored" : "rows from the bottom, turned";
    const double metre = length_unit(slot->unit, file.source).factor;
    return raster_channel(std::move(info), pixels.source, pixels.raster,
                          {.factor = slot->factor * metre, .offset = slot->offset * metre}, options);
}

}  // namespace

Match detect_jpk_image(std::string_view head, const bytes::Source& source, JpkImage kind) {
    if (!bytes::is_tiff(head)) return Match::no;
    try {
        const auto file = bytes::open_tiff(source, "JPK", 1);
        const auto& first = file.pages.front();
        const bool image = first.find(grid_width) && first.find(grid_height) &&
                           (first.find(channel_name) || first.find(channel_fancy_name));
        return image && (first.find(last_curve) != nullptr) == (kind == JpkImage::force_curves) ? Match::yes
                                                                                                : Match::no;
    } catch (const FormatError&) {
        return Match::no;
    }
}

std::vector<Channel> open_jpk_image(const bytes::Source& source, const std::string& format,
                                    const ReadOptions& options) {
    const auto file = bytes::open_tiff(source, "JPK", max_pages + 1);
    const auto& first = file.pages.front();
    ChannelInfo common;
    common.format = format;
    common.metadata = metadata_of(file);
    common.metadata.file = source.name;
    common.metadata.format = format;
    // a grid may run backwards, shown by the sign
    const double width = std::abs(file.number(first, grid_width).value_or(0.0)),
                 height = std::abs(file.number(first, grid_height).value_or(0.0));
    common.size = {width, height};
    if (file.pages.size() > max_pages)
        throw FormatError(
            source.name, {.offset = file.pages.back().offset},
            fmt::format("JPK: {} pages, expected at most {}; it is damaged", file.pages.size(), max_pages));
    std::vector<Channel> channels;
    for (std::size_t k = 1; k < file.pages.size(); ++k)
        if (file.pages[k].find(channel_name) || file.pages[k].find(channel_fancy_name))
            channels.push_back(channel_of(file, file.pages[k], common, options));
    if (channels.empty())
        throw FormatError(source.name, {.offset = first.offset}, "JPK: the file contains a thumbnail and no channel");
    return channels;
}

}  // namespace setae::formats
