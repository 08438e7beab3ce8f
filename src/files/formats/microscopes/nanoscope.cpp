// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "probe_channels.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/nanoscope_header.hpp"
#include "setae/tables/text_head.hpp"
#include "storage/raster.hpp"

// Nanoscope files from version 4.3: a latin-1 header of sections "\*Name" with lines "\Key: value", then one block of
// little-endian integers per image. Height = raw · hard value [V] · soft sensitivity [nm/V] / 2^bits; rows from bottom
// to top.
namespace setae::formats {
namespace {

constexpr std::string_view first_section_as_text = "?*File list";
constexpr std::size_t max_images = 1000;

using tables::find;
using tables::leading_value;
using tables::NanoscopeSection;

const std::string& required(const NanoscopeSection& section, std::string_view key, const bytes::Source& source) {
    if (const auto* value = find(section, key)) return *value;
    throw FormatError(source.name, {}, fmt::format("Nanoscope: image without '{}' in the header", key));
}

std::uint64_t integer(const NanoscopeSection& section, std::string_view key, const bytes::Source& source) {
    return tables::nanoscope_integer(section, key, source);
}

/// Value of one unit of raw data: in SI, and its unit in the file; the factor of an unknown unit is 0.
struct ValueScale {
    double factor = 0.0;
    std::string unit;
    std::string missing = {};  ///< name of a sensitivity that the header lacks
};

/// The name of the sensitivity is in [], the hard value after (). A sensitivity without a unit, as that of "359.9945
/// º", keeps the unit of the hard value.
ValueScale value_scale(const std::string& text, const std::vector<NanoscopeSection>& sections, std::size_t bytes) {
    const auto scale = tables::nanoscope_scale(text);
    const auto& hard = scale.range;
    if (!hard) return {};
    auto unit = plain_unit(hard->unit);
    const auto hard_unit = tables::try_parse_unit(unit);
    double factor = hard->number * (hard_unit ? hard_unit->factor : 0.0);
    if (!scale.sensitivity.empty()) {
        const auto soft = tables::soft_sensitivity(sections, scale.sensitivity);
        if (!soft) return {0.0, unit, scale.sensitivity};
        const auto slash = soft->unit.find('/');
        const auto soft_unit = tables::try_parse_unit(plain_unit(soft->unit.substr(0, slash))),
                   per =
                       slash == std::string::npos ? std::nullopt : tables::try_parse_unit(soft->unit.substr(slash + 1));
        if (slash != std::string::npos) unit = plain_unit(soft->unit.substr(0, slash));
        if (slash == std::string::npos) factor *= soft->number;
        else if (soft_unit && per && hard_unit && per->dimension == hard_unit->dimension)
            factor *= soft->number * soft_unit->factor / per->factor;
        else factor = 0.0;
    }
    return {std::isfinite(factor) ? std::ldexp(factor, -8 * static_cast<int>(bytes)) : 0.0, unit};
}

/// "4:1": ratio of width to height.
double aspect_ratio(const NanoscopeSection& image, const std::vector<NanoscopeSection>& sections,
                    const bytes::Source& source) {
    const auto* text = find(image, "aspect ratio");
    if (!text) text = find(sections, "aspect ratio");
    if (!text) return 1.0;
    const auto colon = text->find(':');
    const double wide = tables::header_number(std::string_view(*text).substr(0, colon), "aspect ratio", source,
                                              "Nanoscope"),
                 high = colon == std::string::npos ? 1.0
                                                   : tables::header_number(std::string_view(*text).substr(colon + 1),
                                                                           "aspect ratio", source, "Nanoscope");
    return wide / high;
}

/// "500 250 nm", or "500 nm" and the aspect ratio.
std::array<double, 2> scan_size(const NanoscopeSection& image, const std::vector<NanoscopeSection>& sections,
                                const bytes::Source& source) {
    const auto& text = required(image, "scan size", source);
    const auto first = leading_value(text);
    if (!first) throw FormatError(source.name, {}, fmt::format("Nanoscope: scan size '{:.40}' is not a length", text));
    const auto second = leading_value(first->unit);
    const auto factor = length_unit(plain_unit(second ? second->unit : first->unit), source).factor;
    const double y = second ? second->number : first->number / aspect_ratio(image, sections, source);
    return {first->number * factor, y * factor};
}

/// `S [Height] "Height"`: the displayed name, otherwise the internal one; with the direction of the scan.
std::string image_name(const std::string& data, const std::string* direction) {
    if (direction) return fmt::format("{} ({})", image_name(data, nullptr), bytes::lowered(*direction));
    const auto quote = data.find('"'), end = data.rfind('"');
    if (quote != std::string::npos && end > quote + 1) return data.substr(quote + 1, end - quote - 1);
    const auto open = data.find('['), close = data.find(']');
    return open != std::string::npos && close != std::string::npos && close > open
               ? data.substr(open + 1, close - open - 1)
               : data;
}

/// Place of the integers of an image.
struct NanoscopeBlock {
    std::uint64_t offset = 0;
    std::size_t bytes = 2;  ///< of one value
    Index nx = 0, ny = 0;
    double wider = 1.0, higher = 1.0;  ///< than the number of points of the image

    [[nodiscard]] std::uint64_t length() const {
        return bytes * static_cast<std::uint64_t>(nx) * static_cast<std::uint64_t>(ny);
    }
};

/// From version 9.2 on, data are 4 bytes wide although "Bytes/pixel" may still be 2: the length of the block decides.
/// If the number of points of an image does not fill its block and that of the scan does, as in version 5.30, that of
/// the scan is used.
NanoscopeBlock find_block(const NanoscopeSection& image, const NanoscopeSection* scan, const std::string& name,
                          const bytes::Source& source) {
    const auto own_nx = integer(image, "samps/line", source), own_ny = integer(image, "number of lines", source);
    const auto length = integer(image, "data length", source);
    auto bytes = integer(image, "bytes/pixel", source);
    auto nx = own_nx, ny = own_ny;
    const auto fills = [&](std::uint64_t width, std::uint64_t height) {
        return width < (1u << 24) && height < (1u << 24) &&
               (length == 2 * width * height || length == 4 * width * height);
    };
    if (!fills(nx, ny) && scan && find(*scan, "samps/line") && find(*scan, "lines") &&
        fills(integer(*scan, "samps/line", source), integer(*scan, "lines", source))) {
        nx = integer(*scan, "samps/line", source);
        ny = integer(*scan, "lines", source);
    }
    const bool plausible = nx < (1u << 24) && ny < (1u << 24);
    if (plausible && length == 4 * nx * ny) bytes = 4;
    if (!plausible || (bytes != 2 && bytes != 4) || length < bytes * nx * ny)
        throw FormatError(source.name, {},
                          fmt::format("Nanoscope: image '{}' has {} × {} values of {} bytes in {} bytes", name, nx, ny,
                                      bytes, length));
    const NanoscopeBlock block{integer(image, "data offset", source),
                               static_cast<std::size_t>(bytes),
                               static_cast<Index>(nx),
                               static_cast<Index>(ny),
                               static_cast<double>(nx) / static_cast<double>(own_nx),
                               static_cast<double>(ny) / static_cast<double>(own_ny)};
    if (block.offset + block.length() > source.size)
        throw FormatError(
            source.name, {.offset = source.size},
            fmt::format("Nanoscope: the file ends here, expected the end of image '{}' at byte {}; it is truncated",
                        name, block.offset + block.length()));
    return block;
}

topography::Metadata file_metadata(const std::vector<NanoscopeSection>& sections, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "di";
    metadata.instrument.type = "afm";
    for (const auto* key : {"microscope", "description"})
        if (const auto* value = find(sections, key); value && metadata.instrument.name.empty())
            metadata.instrument.name = *value;
    if (const auto* date = find(sections, "date")) metadata.acquisition_time = *date;
    for (const auto& [key, attribute] : {std::pair{"version", "software_version"},
                                         {"scanner file", "scanner_file"},
                                         {"rotate ang.", "scan_angle"},
                                         {"scan rate", "scan_rate"},
                                         {"operating mode", "mode"}})
        if (const auto* value = find(sections, key); value && !value->empty()) metadata.attributes[attribute] = *value;
    return metadata;
}

Channel image_channel(const NanoscopeSection& image, const std::vector<NanoscopeSection>& sections,
                      const ChannelInfo& common, const bytes::Source& source, const ReadOptions& options) {
    ChannelInfo info = common;
    const auto* direction = find(image, "line direction");
    info.name = info.metadata.name = image_name(required(image, "image data", source), direction);
    if (direction) info.metadata.attributes["line_direction"] = bytes::lowered(*direction);
    if (const auto* frame = find(image, "frame direction"))
        info.metadata.attributes["scan_direction"] = bytes::lowered(*frame);
    const auto scan = std::find_if(sections.begin(), sections.end(), [](const NanoscopeSection& section) {
        return section.name == "ciao scan list" || section.name == "afm list" || section.name == "nc afm list";
    });
    const auto block = find_block(image, scan == sections.end() ? nullptr : &*scan, info.name, source);
    const auto size = scan_size(image, sections, source);
    info.shape = {block.nx, block.ny};
    info.size = {size[0] * block.wider, size[1] * block.higher};
    const auto scale = value_scale(required(image, "z scale", source), sections, block.bytes);
    info.unit = scale.unit;
    if (!scale.missing.empty())
        info.alerts.push_back(
            {"SENSITIVITY_MISSING", source.name,
             fmt::format("the header has no '{}', which converts '{}' from {}", scale.missing, info.name, scale.unit),
             "save the file again with the program of the instrument"});
    if (!holds_heights(info.name, info.unit) || scale.factor == 0.0) return non_height_channel(std::move(info));
    info.orientation = "rows from the bottom, turned";
    const Raster raster{.offset = block.offset,
                        .nx = block.nx,
                        .ny = block.ny,
                        .sample = block.bytes == 2 ? Sample::int16 : Sample::int32,
                        .bottom_up = true};
    return raster_channel(std::move(info), source, raster, {.factor = scale.factor}, options);
}

bool is_image(const NanoscopeSection& section) {
    return section.name == "ciao image list" || section.name == "afm image list" || section.name == "stm image list" ||
           section.name == "ncafm image list";
}

bool holds_curves(const std::vector<NanoscopeSection>& sections) {
    return std::any_of(sections.begin(), sections.end(),
                       [](const NanoscopeSection& section) { return section.name == "ciao force image list"; });
}

Match detect_nanoscope(std::string_view head, const bytes::Source&) {
    return tables::is_nanoscope(head) || head.starts_with(first_section_as_text) ? Match::yes : Match::no;
}

std::vector<Channel> open_nanoscope(const bytes::Source& source, const ReadOptions& options) {
    const auto refuse = [&](const std::string& what) {
        throw FormatError(source.name, {.offset = 0}, "Nanoscope: " + what);
    };
    if (source.head(first_section_as_text.size()) == first_section_as_text)
        refuse(
            "an image exported as text with its header, whose numbers have no unit; open the original file "
            "of the instrument");
    const auto sections = tables::nanoscope_sections(source);
    ChannelInfo common;
    common.format = "di";
    common.metadata = file_metadata(sections, source);
    if (holds_curves(sections))
        common.alerts.push_back({"FORCE_CURVES_NOT_READ", source.name,
                                 "this is a force volume; its images are read here, its force curves are not",
                                 "`setae jkr fit` reads and fits the curves"});
    std::vector<Channel> channels;
    for (const auto& section : sections) {
        if (!is_image(section)) continue;
        // values of older versions do not begin with their kind, "V"
        const auto* scale = find(section, "z scale");
        if (!scale || !scale->starts_with("V ") || !find(section, "image data"))
            refuse(
                "an image without '@2:Z scale' and '@2:Image Data', written by a version before 4.3; save it again with a newer one");
        if (channels.size() == max_images) refuse(fmt::format("more than {} images; it is damaged", max_images));
        channels.push_back(image_channel(section, sections, common, source, options));
    }
    if (channels.empty())
        refuse(holds_curves(sections) ? "force curves, no image; `setae jkr fit` reads them"
                                      : "no image in the header that begins here");
    return channels;
}

}  // namespace

Format nanoscope_format() {
    return {
        .identifier = "di",
        .name = "Nanoscope",
        .extensions = ".spm .001 .002 .003 .di .txt",
        .description =
            "Digital Instruments, Veeco, Bruker from version 4.3: text header and an integer image a channel",
        .heights = "raw times hard scale times soft sensitivity over 2^16 or 2^32; no point is undefined",
        .orientation = "rows stored from the bottom, turned",
        .not_read =
            "channels that are no heights are listed; force curves are read by `setae jkr fit`; images of versions before 4.3 are refused",
        .reference = "Nanoscope 5 to 9 file headers, as described by Gwyddion's user guide",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_nanoscope,
        .open = open_nanoscope};
}

}  // namespace setae::formats
