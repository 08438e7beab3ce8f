// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_channels.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "column_meaning.hpp"
#include "curve_channel.hpp"
#include "height_names.hpp"
#include "matrix_channels.hpp"
#include "point_grid.hpp"
#include "profile_table.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/formats/format.hpp"
#include "setae/formats/profile_file.hpp"
#include "setae/tables/commas.hpp"
#include "setae/tables/dialect.hpp"
#include "setae/tables/table_file.hpp"
#include "setae/topography/line_scans.hpp"
#include "text_start.hpp"

namespace setae::formats {
namespace {

constexpr std::uint64_t beyond_first_line = 64;

bool is_named(const tables::RawTable& table) {
    for (const auto& column : table.columns)
        if (column.name.empty() && column.unit.empty()) return false;
    return true;
}

/// Meaning of three columns, and whether only the numbers show it.
struct Choice {
    TextContent content = TextContent::none;
    bool ambiguous = false;
    PointGrid grid;                             ///< of points
    std::optional<std::size_t> positions = {};  ///< the column of x of several profiles
};

/// Whether a column is evenly spaced, as only positions are.
bool runs_evenly(const Array1D& values) {
    constexpr Index fewest = 8;
    return values.size() >= fewest && values.isFinite().all() &&
           topography::to_line_scan({values, values, {}}).has_value();
}

Choice choose(const tables::RawTable& table, const ReadOptions& options) {
    const auto& columns = table.columns;
    const auto last = bytes::lowered(columns[2].name);
    if (last == "valid" || last == "standard_error") return {TextContent::curve, false, {}};
    const bool named = is_named(table);
    const bool named_index = bytes::lowered(columns[0].name) == "index";
    const bool along_x = increases(columns[1].values) || increases(-columns[1].values);
    if (named_index && along_x) return {TextContent::curve, false, {}};
    const bool others_named = !columns[1].name.empty() && !columns[2].name.empty();
    if (!named && counts_rows(columns[0].values) && along_x)
        return {TextContent::curve, !options.layout && !others_named, {}};
    auto grid = grid_of(columns[0].values, columns[1].values, columns[2].values);
    const bool stated = named || table.metadata.contains("Lateral units");
    if (grid.found()) return {TextContent::points, !stated && !options.layout, std::move(grid)};
    if (const auto x = positions_of_profiles(table, options.layout == TextLayout::columns))
        return {TextContent::profiles, false, std::move(grid), x};
    if (stated || options.layout) return {TextContent::none, false, std::move(grid)};
    if (runs_evenly(columns[0].values)) return {TextContent::profiles, true, std::move(grid), 0};
    constexpr Index max_rows_of_strip = 16;  // a list of points is longer than a map of three columns
    if (columns[0].values.size() > max_rows_of_strip) return {TextContent::none, false, std::move(grid)};
    return {TextContent::matrix, true, std::move(grid)};
}

Alert ambiguous(TextContent content, const bytes::Source& source, const tables::RawTable& table) {
    const auto rows = table.columns.front().values.size();
    const auto taken =
        content == TextContent::points ? std::string("points x, y, z, because x and y lie on a regular grid")
        : content == TextContent::profiles
            ? std::string("x and the heights of two profiles, because the first column is evenly spaced")
        : content == TextContent::curve
            ? std::string("an index, x and height, because the first column counts rows and the second increases")
            : fmt::format("a map of 3 × {} points, because the first two columns form no regular grid", rows);
    return {"AMBIGUOUS_COLUMNS", source.name, "three columns of numbers without a header were taken as " + taken,
            content == TextContent::matrix ? "check the shape; set `layout` to columns to read them as points x, y, z"
                                           : "check the shape; set `layout` to matrix to read them as rows of a map"};
}

/// Reason why the second of two columns contains the positions.
enum class Exchange { no, by_name, by_steps };

Exchange exchange_of(const std::vector<tables::RawTable::RawColumn>& columns) {
    const auto &first = columns[0], &second = columns[1];
    if (is_position_name(first.name) || !other_quantity(first.name).empty() || !other_quantity(second.name).empty())
        return Exchange::no;
    const bool first_runs = run_along(first.values);
    const bool named = !first.name.empty() && is_position_name(second.name) && run_along(second.values);
    if (named && (is_height_name(first.name) || !first_runs)) return Exchange::by_name;
    return !first_runs && runs_evenly(second.values) ? Exchange::by_steps : Exchange::no;
}

Alert exchanged(const bytes::Source& source) {
    return {"AMBIGUOUS_COLUMNS", source.name,
            "the second column is evenly spaced and the first is not: the second was taken as x, the first "
            "as heights",
            "check the heights; set `layout` to columns if the first column is x"};
}

HeightCurve curve_of(const tables::RawTable& table) {
    const auto& columns = table.columns;
    if (columns.size() == 2) return {columns[0], columns[1]};
    const auto last = bytes::lowered(columns[2].name);
    if (last == "standard_error") return {columns[0], columns[1], columns[2]};
    if (last != "valid") return {columns[1], columns[2]};
    HeightCurve curve{columns[0], columns[1]};
    curve.heights.values = (columns[2].values != 0.0).select(columns[1].values, undefined);
    return curve;
}

/// Why two columns are no profile; empty if they may be one.
std::string reason_against_profile(const HeightCurve& curve) {
    if (const auto quantity = other_quantity(curve.x.name); !quantity.empty())
        return fmt::format("the first column is named {}, expected positions", quantity);
    return reason_against_heights(curve.heights);
}

std::vector<Channel> curve_of(const tables::RawTable& table, std::vector<Alert> alerts, const ReadOptions& options,
                              const bytes::Source& source) {
    auto curve = curve_of(table);
    const bool open = table.columns.size() == 2 && options.layout != TextLayout::columns;
    const auto exchange = open ? exchange_of(table.columns) : Exchange::no;
    if (exchange != Exchange::no) std::swap(curve.x, curve.heights);
    if (exchange == Exchange::by_steps) alerts.push_back(exchanged(source));
    ChannelInfo info;
    info.name = curve.heights.name;
    info.format = "xy";
    info.alerts = std::move(alerts);
    const auto reason = reason_against_profile(curve);
    auto channels = curve_channels(std::move(info), curve, options, source);
    if (!reason.empty() && options.layout != TextLayout::columns)
        for (auto& channel : channels) channel = doubtful_channel(std::move(channel), reason);
    return channels;
}

std::string entry(const tables::RawTable& table, const char* key) {
    const auto found = table.metadata.find(key);
    return found == table.metadata.end() ? std::string() : found->second;
}

Channel points_of(const tables::RawTable& table, PointGrid grid, std::vector<Alert> alerts, const ReadOptions& options,
                  const bytes::Source& source) {
    const auto& columns = table.columns;
    auto lateral = columns[0].unit.empty() ? entry(table, "Lateral units") : columns[0].unit;
    auto unit = columns[2].unit.empty() ? entry(table, "Value units") : columns[2].unit;
    ChannelInfo info;
    info.name = entry(table, "Channel").empty() ? columns[2].name : entry(table, "Channel");
    info.format = "xyz";
    info.orientation = "points on a grid, the smallest y at the top";
    info.shape = {grid.heights.rows(), grid.heights.cols()};
    info.alerts = std::move(alerts);
    info.metadata.file = source.name;
    if (!unit.empty() && !is_length_unit(unit)) {
        info.unit = unit;
        return non_height_channel(std::move(info));
    }
    const auto units = units_of_map(info, {lateral, unit}, options, source);
    if (units.heights.empty()) {
        return channel_without_unit(std::move(info), source);
    }
    const double step = length_unit(units.positions, source).factor;
    topography::HeightMap map{grid.heights * length_unit(units.heights, source).factor,
                              {grid.size[0] * step, grid.size[1] * step},
                              false,
                              {}};
    info.size = {map.size[0], map.size[1]};
    (void)complete(info, {}, source);
    map.metadata = info.metadata;
    return loaded_channel(std::move(info), checked(std::move(map), source));
}

/// The profile format of setae: a profile for any steps.
std::vector<Channel> own_profile(const bytes::Source& source) {
    auto profile = read_profile(source);
    for (Index i = 0; i < profile.positions.size(); ++i)
        if (!std::isfinite(profile.positions[i]))
            throw FormatError(source.name, {}, fmt::format("x of point {} is undefined", i + 1));
    if (profile.positions.size() < 2)
        throw FormatError(source.name, {}, fmt::format("{} point, expected at least 2", profile.positions.size()));
    ChannelInfo info;
    info.name = profile.metadata.name.empty() ? "h" : profile.metadata.name;
    info.format = "xy";
    info.unit = profile.metadata.unit;
    return {loaded_channel(std::move(info), checked(std::move(profile), source))};
}

[[noreturn]] void no_surface(const tables::RawTable& table, const bytes::Source& source, const std::string& problem) {
    throw FormatError(
        source.name, {.line = 1},
        fmt::format("not heights: {} columns of numbers{}, expected x and the heights of profiles, with a name or "
                    "unit of length for x, or points x, y, z on a regular grid{}; set `layout` to matrix and give "
                    "`size` for rows of a map, or set it to columns if the first column is x; force curves are read "
                    "by `setae jkr fit`",
                    table.columns.size(),
                    is_named(table) ? fmt::format(" named '{}', …", table.columns.front().name) : "",
                    problem.empty() ? "" : " (" + problem + ")"));
}

/// The numbers of the first bytes; empty if they are no table.
std::optional<tables::RawTable> head_table(std::string_view head, const bytes::Source& source) {
    const bool whole = head.size() >= source.size;
    try {
        return tables::read_raw_table(
            bytes::memory_source("head", std::string(whole ? head : head.substr(0, head.rfind('\n') + 1))));
    } catch (const FormatError&) {
        return std::nullopt;
    }
}

/// Whether a table of named columns is one of x and profiles, by its first rows.
bool is_profile_table(const bytes::Source& source) {
    const auto table = head_table(source.head(bytes::detection_bytes), source);
    return table && table->columns.size() > 2 && positions_of_profiles(*table, false).has_value();
}

/// Names above all columns of a table: not rows of a map.
bool is_table(const tables::TextStart& start) {
    if (start.header.empty()) return false;
    const auto names = tables::header_cells(start.header.back(), start.layout.dialect.separator, start.layout.columns,
                                            start.layout.columns);
    if (names.empty()) return false;
    double value = 0.0;
    for (const auto& name : names)
        if ((!name.empty() || names.size() == 1) && parse_cell(name, start.layout.dialect, value)) return false;
    return true;
}

/// Refuses maps whose commas may be decimal marks or thousands separators, or both. Gwyddion and similar programs do
/// not group thousands.
void require_clear_commas(const tables::TextStart& start, const MatrixHeader& header) {
    if (header.is_map || start.layout.dialect.decimal_point == '.') {
        const auto row =
            start.source.bytes(start.begin, std::min<std::uint64_t>(start.source.size - start.begin, 4096));
        tables::require_separating_commas(start.header, std::string_view(row).substr(0, row.find('\n')), start.line + 1,
                                          start.layout, start.source.name);
        return;
    }
    for (const auto part : {std::uint64_t{bytes::detection_bytes}, start.source.size}) {
        const auto text = bytes::decoded(
            start.source.bytes(start.begin, std::min(part, start.source.size - start.begin)), bytes::Encoding::detect);
        const auto doubtful = tables::undecided_commas(bytes::split_lines(text), start.layout);
        if (!doubtful) return;
        if (part >= start.source.size - start.begin)
            throw FormatError(
                start.source.name, {.line = start.line + doubtful->line},
                fmt::format("'{:.40}' is ambiguous, as is every number with a comma here: it may separate decimals or "
                            "thousands; export with decimal points",
                            doubtful->cell));
    }
}

}  // namespace

TextGuess guess_text(std::string_view head, const bytes::Source& source) {
    if (is_profile_file(head)) return {TextContent::curve, true};
    if (!bytes::looks_like_text(head)) return {};
    const auto start = find_start(source);
    if (!start) return {};
    try {
        if (parse_matrix_header(start->header, source).is_map) return {TextContent::matrix, true};
    } catch (const FormatError&) {
        return {TextContent::matrix, true};  // open reports the problem
    }
    const auto columns = start->layout.columns;
    if (columns > 3 && is_table(*start) && is_profile_table(source)) return {TextContent::curve, false};
    if (columns == 1 || columns > 3) return {TextContent::matrix, false};
    if (columns == 2) return {TextContent::curve, false};
    const auto table = head_table(head, source);
    if (!table || table->columns.size() != 3) return {TextContent::curve, false};
    const auto content = choose(*table, {}).content;
    const bool curves = content == TextContent::none || content == TextContent::profiles;
    return {curves ? TextContent::curve : content, false};
}

std::vector<Channel> open_text(const bytes::Source& source, const ReadOptions& options) {
    if (is_profile_file(source.head(beyond_first_line))) return own_profile(source);
    const auto start = find_start(source);
    if (!start)
        throw FormatError(source.name, {.line = 1},
                          source.size == 0
                              ? "the file is empty; expected rows of numbers"
                              : "the file has no row of numbers; expected columns x and height below a header");
    if (start->broken) throw FormatError(source.name, {.line = start->broken->line}, tables::described(*start->broken));
    const auto header = parse_matrix_header(start->header, source);
    const auto columns = start->layout.columns;
    const bool as_matrix = options.layout == TextLayout::matrix, as_columns = options.layout == TextLayout::columns;
    const bool named_profiles = columns > 3 && is_table(*start) && is_profile_table(source);
    const bool unnamed_map = columns > 3 && !as_columns && !named_profiles && (!is_table(*start) || options.size);
    if (as_matrix || (header.is_map && !as_columns) || columns == 1 || unnamed_map) {
        require_clear_commas(*start, header);
        return matrix_channels(*start, header, options, {});
    }
    auto table = tables::read_raw_table(source);
    if (!as_columns)
        if (auto points = named_points(table)) {
            table = std::move(*points);
            if (const auto& y = table.columns[1].values; (y == y[0]).all())  // one line of points
                table.columns.erase(table.columns.begin() + 1);
        }
    if (table.columns.size() > 3)
        if (const auto x = positions_of_profiles(table, as_columns))
            return profile_channels(table, *x, {}, options, source);
    if (table.columns.size() < 2 || table.columns.size() > 3) no_surface(table, source, {});
    if (table.columns.size() == 2) return curve_of(table, {}, options, source);
    auto choice = choose(table, options);
    std::vector<Alert> alerts;
    if (choice.ambiguous) alerts.push_back(ambiguous(choice.content, source, table));
    switch (choice.content) {
        case TextContent::matrix: return matrix_channels(*start, header, options, alerts);
        case TextContent::points: return {points_of(table, std::move(choice.grid), std::move(alerts), options, source)};
        case TextContent::curve: return curve_of(table, std::move(alerts), options, source);
        case TextContent::profiles: return profile_channels(table, *choice.positions, alerts, options, source);
        case TextContent::none: break;
    }
    no_surface(table, source, choice.grid.problem);
}

}  // namespace setae::formats
