// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/bytes/text.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header.hpp"
#include "setae/tables/text_head.hpp"
#include "storage/raster.hpp"
#include "writing.hpp"

// Gwyddion Simple Field 1.0: a line with the name of the format, lines "key = value", one to four NULs up to a multiple
// of four bytes, then XRes × YRes little-endian float32, rows from the top.
namespace setae::formats {
namespace {

constexpr const char* gsf_identifier = "gsf";
constexpr const char* gsf_name = "GSF";
constexpr std::string_view gsf_signature = "Gwyddion Simple Field 1.0\n";

/// The keys of a header in lower case, and where the numbers begin.
struct GsfHeader {
    std::map<std::string, std::string> entries;
    std::uint64_t data = 0;

    [[nodiscard]] const std::string* find(const std::string& key) const {
        const auto entry = entries.find(key);
        return entry == entries.end() ? nullptr : &entry->second;
    }
};

GsfHeader gsf_header(const bytes::Source& source) {
    const auto head = source.head(tables::longest_text_head);
    const auto end = head.find('\0');
    if (end == std::string::npos)
        throw FormatError(source.name, {.offset = head.size()},
                          "GSF: the NUL that ends the header is missing; the file is truncated or damaged");
    GsfHeader header{.data = end + 4 - end % 4};
    const auto text = bytes::decoded(head.substr(0, end), bytes::Encoding::detect);
    for (const auto line : bytes::split_lines(text)) {
        const auto equals = line.find('=');
        if (equals == std::string_view::npos) continue;
        header.entries.emplace(bytes::lowered(trimmed(line.substr(0, equals))), trimmed(line.substr(equals + 1)));
    }
    return header;
}

Index gsf_count(const GsfHeader& header, const std::string& key, const bytes::Source& source) {
    const auto* text = header.find(key);
    if (!text)
        throw FormatError(source.name, {.offset = 0},
                          fmt::format("GSF: the header that begins here has no '{}'; the file is damaged", key));
    return static_cast<Index>(tables::header_count(*text, key, source, gsf_name));
}

/// An extent [m]; 0 if the file states none, or none of length.
double gsf_length(const GsfHeader& header, const std::string& key, double metre, const bytes::Source& source) {
    const auto* text = header.find(key);
    return text ? std::abs(tables::header_number(*text, key, source, gsf_name)) * metre : 0.0;
}

double metres_of_unit(const std::string& unit) {
    const auto parsed = tables::try_parse_unit(unit);
    return parsed && parsed->dimension == dimension::length ? parsed->factor : 0.0;
}

std::string text_entry(const GsfHeader& header, const std::string& key) {
    const auto* text = header.find(key);
    return text ? *text : std::string();
}

std::vector<Channel> open_gsf(const bytes::Source& source, const ReadOptions& options) {
    const auto header = gsf_header(source);
    const Raster raster{.offset = header.data,
                        .nx = gsf_count(header, "xres", source),
                        .ny = gsf_count(header, "yres", source),
                        .sample = Sample::float32};
    ChannelInfo info{.name = text_entry(header, "title"), .format = gsf_identifier};
    if (raster.ny > 1) info.orientation = "rows from the top, as stored";
    const double lateral = metres_of_unit(text_entry(header, "xyunits"));
    const double width = gsf_length(header, "xreal", lateral, source),
                 height = gsf_length(header, "yreal", lateral, source);
    if (width > 0.0 && height > 0.0) info.size = {width, height};
    info.unit = text_entry(header, "zunits");
    static const std::map<std::string, bool> known{{"xres", true},  {"yres", true},    {"xreal", true},
                                                   {"yreal", true}, {"xyunits", true}, {"zunits", true},
                                                   {"title", true}};
    for (const auto& [key, value] : header.entries)
        if (!known.contains(key) && !value.empty()) info.metadata.attributes[key] = value;
    const double metre = metres_of_unit(info.unit);
    if (!info.unit.empty() && metre == 0.0) {
        info.shape = {raster.nx, raster.ny};
        info.metadata.file = source.name;
        return {non_height_channel(std::move(info))};
    }
    return {raster_channel(std::move(info), source, raster, {.factor = metre == 0.0 ? 1.0 : metre}, options)};
}

Match detect_gsf(std::string_view head, const bytes::Source&) {
    return head.starts_with(gsf_signature) || head.starts_with("Gwyddion Simple Field 1.0\r\n") ? Match::yes
                                                                                                : Match::no;
}

void write_gsf(const std::string& path, const topography::Measurement& measurement) {
    refuse_trace(measurement, path);
    const auto& map = required_map(measurement, path, gsf_name);
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    auto header = fmt::format("{}XRes = {}\nYRes = {}\nXReal = {}\nYReal = {}\nXYUnits = m\nZUnits = m\n",
                              gsf_signature, nx, ny, map.size[0], map.size[1]);
    if (const auto title = one_line(map.metadata.name); !title.empty()) header += fmt::format("Title = {}\n", title);
    header.append(4 - header.size() % 4, '\0');
    std::string numbers(static_cast<std::size_t>(nx * ny) * sizeof(float), '\0');
    for (Index j = 0; j < ny; ++j)
        for (Index i = 0; i < nx; ++i) {
            constexpr float none = std::numeric_limits<float>::quiet_NaN(), most = std::numeric_limits<float>::max();
            const bool fits = std::abs(map.heights(i, j)) <= most;
            const auto height = fits ? static_cast<float>(map.heights(i, j)) : none;
            std::memcpy(numbers.data() + static_cast<std::size_t>(j * nx + i) * sizeof(float), &height, sizeof(float));
        }
    bytes::write_whole_file(path, {header, numbers});
}

}  // namespace

Format gsf_format() {
    return {
        .identifier = gsf_identifier,
        .name = "Gwyddion Simple Field",
        .extensions = ".gsf",
        .description =
            "one map with its size, units and title, which Gwyddion, WSxM and programs for near-field microscopes exchange",
        .heights =
            "float32 in the unit ZUnits; NaN and infinities are undefined; a field whose unit is no length is listed",
        .orientation = "rows from the top",
        .not_read = "a size without a unit, or of 0, is given; other keys are kept as attributes",
        .reference = "Gwyddion user guide, Gwyddion Simple Field",
        .tested_on_real_files = false,
        .carries_scale = true,
        .read_elsewhere = false,
        .detect = detect_gsf,
        .open = open_gsf,
        .write = write_gsf};
}

}  // namespace setae::formats
