// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "probe_channels.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/nanosurf_header.hpp"
#include "setae/tables/text_head.hpp"
#include "storage/raster.hpp"

// Dim0 and Dim1 are the axes of a channel; the full range of its integers is Dim2Min to Dim2Min + Dim2Range.
namespace setae::formats {
namespace {

using tables::text_entry;

topography::Metadata metadata_of(const tables::TextSections& sections, const bytes::Source& source) {
    topography::Metadata metadata;
    metadata.file = source.name;
    metadata.format = "nanosurf";
    metadata.instrument.type = "afm";
    metadata.instrument.name = "Nanosurf";
    const auto found = sections.find("DataSet-Info");
    if (found == sections.end()) return metadata;
    const auto& about = found->second;
    if (const auto head = text_entry(about, "Head type"); !head.empty()) metadata.instrument.name += " " + head;
    metadata.acquisition_time = std::string(trimmed(text_entry(about, "Date") + " " + text_entry(about, "Time")));
    for (const auto& [key, attribute] : {std::pair{"Op. mode", "mode"},
                                         {"Cantilever", "cantilever"},
                                         {"Cantilever type", "cantilever"},
                                         {"Scan direction", "scan_direction"},
                                         {"Rotation", "scan_angle"},
                                         {"SW.Version", "software_version"},
                                         {"Software ver.", "software_version"}})
        if (const auto value = text_entry(about, key); !value.empty()) metadata.attributes[attribute] = value;
    return metadata;
}

/// Integers of a channel and the values they mean.
struct Values {
    Raster raster;
    double factor = 0.0, offset = 0.0;  ///< to Dim2Unit
};

Values values_of(const tables::TextSection& section, std::uint64_t at, const bytes::Source& source) {
    const auto stored = tables::nanosurf_integers(section, source);
    const auto sample = [&](Sample with_sign, Sample without) { return stored.is_signed ? with_sign : without; };
    Values values{.raster = {.offset = at,
                             .nx = static_cast<Index>(stored.points),
                             .ny = static_cast<Index>(stored.lines),
                             .sample = stored.bits == 8    ? sample(Sample::int8, Sample::uint8)
                                       : stored.bits == 16 ? sample(Sample::int16, Sample::uint16)
                                                           : sample(Sample::int32, Sample::uint32),
                             .order = stored.big_endian ? std::endian::big : std::endian::little,
                             .bottom_up = true},
                  .factor = stored.factor,
                  .offset = stored.offset};
    require_raster(values.raster, source, "Nanosurf");
    return values;
}

/// Extent [m] along each axis; empty if one is no length.
std::vector<double> size_of(const tables::TextSection& section, std::size_t dimensions, const bytes::Source& source) {
    std::vector<double> size;
    for (std::size_t k = 0; k < dimensions; ++k) {
        const auto unit = plain_unit(text_entry(section, fmt::format("Dim{}Unit", k)));
        const auto key = fmt::format("Dim{}Range", k);
        if (!holds_heights({}, unit)) return {};
        size.push_back(std::abs(tables::header_number(text_entry(section, key), key, source, "Nanosurf")) *
                       length_unit(unit, source).factor);
    }
    return size;
}

Channel channel_of(const tables::TextSection& section, const Values& values, ChannelInfo info,
                   const bytes::Source& source, const ReadOptions& options) {
    const auto frame = text_entry(section, "Frame");
    info.name = info.metadata.name = frame.empty() ? text_entry(section, "Dim2Name")
                                                   : fmt::format("{} ({})", text_entry(section, "Dim2Name"), frame);
    if (frame == "Scan forward" || frame == "Scan backward")
        info.metadata.attributes["line_direction"] = frame.substr(5);
    info.unit = plain_unit(text_entry(section, "Dim2Unit"));
    const bool line = values.raster.ny == 1;
    info.shape = line ? std::vector{values.raster.nx} : std::vector{values.raster.nx, values.raster.ny};
    info.size = size_of(section, info.shape.size(), source);
    const bool spectrum = frame.starts_with("Spec");
    if (spectrum || info.size.empty() || !holds_heights(info.name, info.unit))
        return non_height_channel(std::move(info));
    if (!line) info.orientation = "rows from the bottom, turned";
    const double metre = length_unit(info.unit, source).factor;
    return raster_channel(std::move(info), source, values.raster,
                          {.factor = metre * values.factor, .offset = metre * values.offset}, options);
}

std::vector<Channel> open_nanosurf(const bytes::Source& source, const ReadOptions& options) {
    const auto head = tables::nanosurf_head(source);
    const auto sections = tables::nanosurf_sections(head);
    ChannelInfo common;
    common.format = "nanosurf";
    common.metadata = metadata_of(sections, source);
    std::uint64_t at = head.size() + tables::last_nanosurf_line.size();
    std::vector<Channel> channels;
    for (const auto& place : tables::nanosurf_channels(sections, source)) {
        const auto found = sections.find(place.section);
        if (found == sections.end()) continue;
        const auto values = values_of(found->second, at, source);
        channels.push_back(channel_of(found->second, values, common, source, options));
        at += static_cast<std::uint64_t>(values.raster.ny) * values.raster.row_distance();
    }
    if (channels.empty())
        throw FormatError(source.name, {.offset = 0}, "Nanosurf: the header that begins here names no channel");
    return channels;
}

Match detect_nanosurf(std::string_view head, const bytes::Source&) {
    return tables::is_nanosurf(head) ? Match::yes : Match::no;
}

}  // namespace

Format nanosurf_format() {
    return {
        .identifier = "nanosurf",
        .name = "Nanosurf",
        .extensions = ".ezd .nid",
        .description =
            "Nanosurf easyScan and later: sections of text, then integers of 8, 16 or 32 bits, signed or not, in either byte order, a channel after the other",
        .heights =
            "Dim2Min plus raw, from its least possible value on, times Dim2Range over 2^bits; no point is undefined",
        .orientation = "rows stored from the bottom, turned",
        .not_read = "channels that are no heights are listed; force curves (`setae jkr fit` reads them)",
        .reference = "Gwyddion's module ezdfile",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = detect_nanosurf,
        .open = open_nanosurf};
}

}  // namespace setae::formats
