// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/header_number.hpp"
#include "storage/raster.hpp"

// WSxM images: three lines that identify the file, sections "[Name]" with lines "Key: value" up to "[Header end]", then
// the image, little-endian, rotated by 180°. Floating-point data are in the unit of the Z amplitude; 16-bit data span
// the Z amplitude between Minimum and Maximum of the header, or between those of the data if the header does not state
// them as integers.
namespace setae::formats {
namespace {

constexpr std::string_view first_wsxm_line = "WSxM file copyright", image_line = "SxM Image file",
                           size_key = "Image header size:", last_wsxm_line = "[Header end]";
constexpr std::uint64_t usual_header = 1 << 16, longest_header = 1 << 20;

struct WsxmHeader {
    std::map<std::string, std::string> entries;  ///< "section/key" in lower case
    std::uint64_t data_offset = 0;

    [[nodiscard]] const std::string& text(const std::string& key) const {
        static const std::string nothing;
        const auto at = entries.find(key);
        return at == entries.end() ? nothing : at->second;
    }
};

[[noreturn]] void broken_wsxm(const bytes::Source& source, std::uint64_t offset, const std::string& what) {
    throw FormatError(source.name, {.offset = offset}, "WSxM: " + what);
}

/// Curves and films have the same first line as images; the second line distinguishes them.
void require_image(const std::vector<std::string_view>& lines, const bytes::Source& source) {
    const auto kind = lines.size() < 2 ? std::string_view{} : trimmed(lines[1]);
    if (kind == image_line) return;
    if (bytes::lowered(kind).starts_with("fz"))
        broken_wsxm(
            source, lines[0].size() + 1,
            fmt::format("'{:.40}': force-distance curves, not a map of heights; export them as columns of text, which "
                        "`setae jkr fit` reads",
                        kind));
    broken_wsxm(source, lines.size() < 2 ? source.size : lines[0].size() + 1,
                fmt::format("got '{:.40}', expected '{}'; curves, spectra and films are not read", kind, image_line));
}

/// The first bytes at least up to the end of the header; all possible bytes of a header without end.
std::string whole_header(const bytes::Source& source) {
    auto bytes = source.head(usual_header);
    return bytes.find(last_wsxm_line) == std::string::npos && bytes.size() < source.size ? source.head(longest_header)
                                                                                         : bytes;
}

WsxmHeader parse_header(const bytes::Source& source) {
    const auto bytes = whole_header(source);
    const auto lines = bytes::split_lines(bytes);
    const bool whole_lines = lines.size() > 2;
    if (whole_lines) require_image(lines, source);
    const auto end = bytes.find(last_wsxm_line);
    if (end == std::string::npos || !whole_lines)
        broken_wsxm(source, bytes.size(),
                    fmt::format("the header does not end with '{}'; the file is truncated or damaged", last_wsxm_line));
    WsxmHeader header;
    const auto line_end = bytes.find('\n', end);
    header.data_offset = line_end == std::string::npos ? bytes.size() : line_end + 1;
    const auto third = trimmed(lines[2]);
    if (const auto announced =
            third.starts_with(size_key) ? tables::count_in(third.substr(size_key.size())) : std::nullopt)
        header.data_offset = std::max(header.data_offset, static_cast<std::uint64_t>(*announced));
    const auto text = bytes::decoded(bytes.substr(0, end), bytes::Encoding::detect);
    std::string section;
    for (const auto raw : bytes::split_lines(text)) {
        const auto line = trimmed(raw);
        const auto colon = line.find(':');
        if (line.starts_with('[') && line.ends_with(']'))
            section = bytes::lowered(line.substr(1, line.size() - 2)) + '/';
        else if (!section.empty() && colon != std::string_view::npos)
            header.entries[section + bytes::lowered(trimmed(line.substr(0, colon)))] = trimmed(line.substr(colon + 1));
    }
    return header;
}

/// "18.8851 nm": a number and its unit, which may be missing.
struct Amplitude {
    double number = 0.0;
    std::string unit;
};

std::optional<Amplitude> amplitude(std::string_view text) {
    const auto blank = std::min(text.find_first_of(" \t"), text.size());
    const auto number = tables::finite_number(text.substr(0, blank));
    if (!number) return std::nullopt;
    return Amplitude{*number, std::string(trimmed(text.substr(blank)))};
}

std::vector<double> lateral_size(const WsxmHeader& header, const bytes::Source& source) {
    const auto x = amplitude(header.text("control/x amplitude"));
    const auto given_y = amplitude(header.text("control/y amplitude"));
    const auto& y = given_y ? given_y : x;  // old versions state one length for a square
    if (!x || x->unit.empty()) return {};
    return {std::abs(x->number) * length_unit(x->unit, source).factor,
            std::abs(y->number) * length_unit(y->unit.empty() ? x->unit : y->unit, source).factor};
}

struct DataType {
    Sample sample;
    bool scaled;  ///< integers that span the Z amplitude
};

DataType data_type(const WsxmHeader& header, const bytes::Source& source) {
    const auto name = bytes::lowered(header.text("general info/image data type"));
    if (name.empty() || name == "short" || name == "integer") return {Sample::int16, true};
    if (name == "float") return {Sample::float32, false};
    if (name == "double") return {Sample::float64, false};
    broken_wsxm(source, header.data_offset,
                fmt::format("image data type '{:.40}', expected short, integer, float or double", name));
}

Index dimension_of(const WsxmHeader& header, const std::string& key, const bytes::Source& source) {
    const auto& text = header.text("general info/" + key);
    const auto number = tables::count_in(text);
    if (!number)
        broken_wsxm(source, header.data_offset,
                    fmt::format("'{}' is '{:.40}', expected a positive integer", key, text));
    return *number;
}

topography::Metadata metadata_of(const WsxmHeader& header) {
    topography::Metadata metadata;
    metadata.acquisition_time = header.text("general info/acquisition time");
    metadata.instrument.type = bytes::lowered(header.text("general info/head type"));
    if (const auto& serial = header.text("miscellaneous/dulcinea serial number"); !serial.empty())
        metadata.instrument.name = "Dulcinea controller " + serial;
    for (const auto& [key, attribute] : {std::pair{"miscellaneous/saved with version", "software_version"},
                                         {"head settings/head name", "head"},
                                         {"general info/x scanning direction", "x_scanning_direction"},
                                         {"general info/y scanning direction", "y_scanning_direction"},
                                         {"control/z offset", "z_offset"},
                                         {"miscellaneous/comments", "comment"}})
        if (const auto& text = header.text(key); !text.empty()) metadata.attributes[attribute] = text;
    return metadata;
}

/// The range of raw integers that spans the Z amplitude, if the header states it as integers.
std::optional<double> stated_range(const WsxmHeader& header) {
    const auto least = tables::finite_number(header.text("miscellaneous/minimum")),
               greatest = tables::finite_number(header.text("miscellaneous/maximum"));
    const bool integers = least && greatest && *least == std::round(*least) && *greatest == std::round(*greatest);
    return integers && *greatest > *least ? std::optional(*greatest - *least) : std::nullopt;
}

/// Heights of `amplitude` times the raw integers, scaled to span the amplitude.
topography::Measurement spanning(topography::Measurement measurement, double amplitude) {
    const double range =
        std::visit([](const auto& one) { return one.heights.maxCoeff() - one.heights.minCoeff(); }, measurement);
    return topography::scaled(std::move(measurement), range > 0.0 ? amplitude / range : 0.0);
}

void warn_of_scale(ChannelInfo& info, const WsxmHeader& header, const bytes::Source& source) {
    const auto factor = tables::finite_number(header.text("miscellaneous/z scale factor"));
    if (factor && *factor != 1.0)
        info.alerts.push_back({"SCALE_NOT_APPLIED", source.name,
                               fmt::format("the header has a Z scale factor of {}, which was not applied", *factor),
                               "compare the range of heights with the Z amplitude of the header"});
}

std::vector<Channel> open_wsxm(const bytes::Source& source, const ReadOptions& options) {
    const auto header = parse_header(source);
    const auto type = data_type(header, source);
    const Raster raster{.offset = header.data_offset,
                        .nx = dimension_of(header, "number of columns", source),
                        .ny = dimension_of(header, "number of rows", source),
                        .sample = type.sample,
                        .bottom_up = true,
                        .right_to_left = true};
    ChannelInfo info;
    info.name = header.text("general info/acquisition channel");
    if (info.name.empty()) info.name = "image";
    info.format = "wsxm";
    info.metadata = metadata_of(header);
    info.size = lateral_size(header, source);
    info.orientation =
        "rows from the bottom and each from the right, turned by half a turn; not stated in the file, taken as Gwyddion shows it";
    const auto height = amplitude(header.text("general info/z amplitude"));
    if (type.scaled && !height)
        broken_wsxm(source, header.data_offset, "the header has no 'Z Amplitude', which gives the scale of integers");
    info.unit = height ? height->unit : "";
    const auto unit = tables::try_parse_unit(info.unit);
    if (!info.unit.empty() && info.unit != "A" && (!unit || unit->dimension != dimension::length)) {
        require_raster(raster, source, "wsxm");
        info.shape = {raster.nx, raster.ny};
        info.metadata.file = source.name;
        return {non_height_channel(std::move(info))};
    }
    warn_of_scale(info, header, source);
    const double metres = info.unit.empty() ? 1.0 : length_unit(info.unit, source).factor;
    if (!type.scaled) return {raster_channel(std::move(info), source, raster, {.factor = metres}, options)};
    const double span = std::abs(height->number) * metres;
    if (const auto range = stated_range(header))
        return {raster_channel(std::move(info), source, raster, {.factor = span / *range}, options)};
    if (info.unit.empty())
        broken_wsxm(source, header.data_offset,
                    "the header states neither the unit of 'Z Amplitude' nor the range of integers");
    auto channel = raster_channel(std::move(info), source, raster, {.factor = span}, options);
    read_as_a_whole(channel, [read = channel.read, span] { return spanning(read(), span); });
    return {std::move(channel)};
}

}  // namespace

Format wsxm_format() {
    return {
        .identifier = "wsxm",
        .name = "WSxM",
        .extensions = ".stp .top .tom",
        .description =
            "images of WSxM (Nanotec Electronica and others): text header and one image of 16-bit integers, floats or doubles",
        .heights =
            "floats and doubles in the unit of the Z amplitude; integers span it between the header's minimum and maximum; no point is undefined",
        .orientation =
            "rows stored from the bottom, each from the right, turned by half a turn as Gwyddion does; the file does not state it",
        .not_read = "curves, spectra and films (.cur, .gsi, .mpp) are refused",
        .reference = "wsxmfile module of Gwyddion, WSXM reader of SurfaceTopography 1.27",
        .tested_on_real_files = true,
        .carries_scale = true,
        .detect = [](std::string_view head,
                     const bytes::Source&) { return head.starts_with(first_wsxm_line) ? Match::yes : Match::no; },
        .open = open_wsxm};
}

}  // namespace setae::formats
