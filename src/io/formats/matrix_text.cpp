// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <initializer_list>
#include <optional>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "format_list.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/io/table_file.hpp"
#include "text.hpp"

namespace setae::io {

namespace {

Match detect_matrix_text(std::string_view head, const Source&) {
    if (!looks_like_text(head)) return Match::no;
    const auto text = decoded(std::string(head.substr(0, 4096)), Encoding::detect);
    if (text.starts_with("# Channel:") || text.starts_with("# Kanal:") || text.starts_with("# Width:")) return Match::yes;
    return numeric_columns(head) > 3 ? Match::yes : Match::no;
}

/// Gwyddion's header of a text matrix, in English and German.
struct MatrixHeader {
    std::string name;
    std::optional<double> width, height;  ///< [m]
    std::optional<std::string> unit;      ///< of the values
};

std::optional<std::string> value_of(const std::string& line, std::initializer_list<const char*> keys) {
    auto body = trimmed(line);
    while (body.starts_with('#')) body = trimmed(body.substr(1));
    for (const std::string_view key : keys)
        if (body.starts_with(key) && body.substr(key.size()).starts_with(':'))
            return std::string(trimmed(body.substr(key.size() + 1)));
    return std::nullopt;
}

MatrixHeader parse_matrix_header(const std::vector<std::string>& lines, const Source& source) {
    MatrixHeader header;
    const auto length = [&](std::string text) {
        std::replace(text.begin(), text.end(), ',', '.');
        try {
            return parse_quantity(text, dimension::length);
        } catch (const InvalidArgument& error) {
            throw FormatError(source.name, {}, fmt::format("size in the header: {}", error.what()));
        }
    };
    for (const auto& line : lines) {
        if (const auto name = value_of(line, {"Channel", "Kanal"})) header.name = *name;
        if (const auto width = value_of(line, {"Width", "Breite"})) header.width = length(*width);
        if (const auto height = value_of(line, {"Height", "Höhe"})) header.height = length(*height);
        if (const auto unit = value_of(line, {"Value units", "Werteinheiten"})) header.unit = *unit;
    }
    return header;
}

std::vector<Channel> open_matrix_text(const Source& source, const ReadOptions& options) {
    const auto table = read_raw_table(source);
    const auto header = parse_matrix_header(table.header, source);
    if (!header.width && !options.size)
        throw InvalidArgument(fmt::format("{}: {} columns of numbers without the header of a map; give --size and --unit where it is one, "
                                          "force curves are read by `setae jkr fit`", source.name, table.columns.size()));
    topography::HeightMap map;
    map.metadata.file = source.name;
    map.metadata.format = "matrix";
    map.metadata.name = header.name;
    const auto unit = length_unit(header.unit ? *header.unit : required_unit(options, source), source);
    map.metadata.unit = unit.name;
    if (header.width && header.height) {
        map.size = {*header.width, *header.height};
    } else {
        const auto size = required_size(options, 2, source);
        map.size = {size[0], size[1]};
    }
    map.heights.resize(static_cast<Index>(table.columns.size()), table.columns.front().values.size());
    for (Index i = 0; i < map.heights.rows(); ++i) map.heights.row(i) = unit.factor * table.columns[static_cast<std::size_t>(i)].values.transpose();
    ChannelInfo info;
    info.name = header.name;
    info.format = "matrix";
    info.orientation = "rows from the top, as stored";
    info.unit = map.metadata.unit;
    return {loaded_channel(std::move(info), checked(std::move(map), source))};
}

}  // namespace

Format matrix_text_format() {
    return {.identifier = "matrix",
            .name = "text matrix",
            .extensions = ".txt .asc",
            .description = "numbers only, a row of the map a line, with Gwyddion's header (width, height, value units) or size and unit given",
            .heights = "values in the unit stated or given; nan and bad are undefined",
            .orientation = "first line at the top",
            .reference = "Gwyddion user guide, export as ASCII data matrix",
            .tested_on_real_files = true,
            .carries_scale = false,
            .detect = detect_matrix_text,
            .open = open_matrix_text};
}

}  // namespace setae::io
