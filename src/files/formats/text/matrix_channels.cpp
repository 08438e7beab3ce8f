// SPDX-License-Identifier: GPL-3.0-or-later
#include "matrix_channels.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "channel_building.hpp"
#include "curve_channel.hpp"
#include "labels.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/tables/header.hpp"
#include "text_start.hpp"

namespace setae::formats {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Measurement;

/// Place of a map among lines of numbers.
struct Layer {
    Index nx = 0, ny = 0;
    tables::NumberPlaces places;
    bool void_map = false;  ///< followed by as many lines, with 1 at void points
    bool is_line = false;
    Labels labels = {};
};

Layer layer_of(const tables::NumberLines& lines, const MatrixHeader& header,
               const std::vector<std::string>& header_text, const ReadOptions& options) {
    const auto& name = lines.source.name;
    Layer layer;
    layer.void_map = header.void_map;
    if (header.void_map && lines.rows % 2 != 0)
        throw FormatError(
            name, {.line = lines.lines},
            fmt::format("SPIP: {} lines, expected those of the heights and as many that mark void points; the file is "
                        "truncated",
                        lines.rows));
    const Index rows = header.void_map ? lines.rows / 2 : lines.rows;
    layer.places.lines_are_columns = header.lines_are_columns;
    layer.nx = header.lines_are_columns ? rows : lines.columns;
    layer.ny = header.lines_are_columns ? lines.columns : rows;
    const bool other = (header.nx && *header.nx != layer.nx) || (header.ny && *header.ny != layer.ny);
    if (other)
        throw FormatError(
            name, {.line = lines.lines},
            fmt::format("the text ends here with {} × {} numbers, but its header announces {} × {}; it is truncated or "
                        "damaged",
                        layer.nx, layer.ny, header.nx.value_or(layer.nx), header.ny.value_or(layer.ny)));
    const bool size_of_map = options.size && options.size->size() == 2;
    if (lines.rows == 1 && lines.columns <= 3 && !header.is_map)
        throw FormatError(
            name, {.line = lines.lines},
            fmt::format("the text ends after one line of {} numbers, expected more points", lines.columns));
    const bool may_have_labels = !options.keep_values && !header.is_map && layer.nx > 1 && layer.ny > 1;
    if (may_have_labels)
        layer.labels = find_labels(lines, header_text, options.layout == TextLayout::matrix || size_of_map);
    if (layer.labels.any()) {
        layer.nx -= layer.labels.first_column ? 1 : 0;
        layer.ny -= layer.labels.rows_above;
        layer.places.first = layer.labels.rows_above;
    }
    layer.is_line = (layer.nx == 1 || layer.ny == 1) && !header.is_map && !size_of_map;
    return layer;
}

/// Extent along x and y [m], if the header contains both.
std::vector<double> size_of(const MatrixHeader& header, const Layer& layer) {
    std::vector<double> size;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto points = static_cast<double>(axis == 0 ? layer.nx : layer.ny);
        if (header.length[axis]) size.push_back(*header.length[axis]);
        else if (header.pixel[axis]) size.push_back(*header.pixel[axis] * points);
    }
    if (size.size() != 2) size.clear();
    return size;
}

Array2D heights_of(const tables::NumberLines& lines, const Layer& layer, double factor) {
    auto places = layer.places;
    places.factor = factor;
    if (layer.labels.any()) return factor * without_labels(tables::read_numbers(lines), layer.labels, lines);
    if (!layer.void_map) return tables::read_numbers(lines, places);
    places.count = lines.rows / 2;
    auto heights = tables::read_numbers(lines, places);
    places.first = places.count;
    places.factor = 1.0;
    const auto is_void = tables::read_numbers(lines, places);
    heights = (is_void == 0.0).select(heights, undefined);
    return heights;
}

Measurement measured(const tables::NumberLines& lines, const Layer& layer, double factor, const ChannelInfo& info) {
    auto heights = heights_of(lines, layer, factor);
    if (layer.is_line)
        return checked(
            LineScan{Eigen::Map<const Array1D>(heights.data(), heights.size()), info.size[0], false, info.metadata},
            lines.source);
    return checked(HeightMap{std::move(heights), {info.size[0], info.size[1]}, false, info.metadata}, lines.source);
}

/// Units and, if labels are positions along both axes, the size they give. Only the unit of such a map can be missing.
void apply_labels(const Labels& labels, MatrixHeader& header, ChannelInfo& info, const ReadOptions& options,
                  const bytes::Source& source) {
    info.metadata.alerts.push_back({"LABELS_NOT_HEIGHTS", source.name,
                                    fmt::format("{}, which are not heights", labels.described()),
                                    "if they are heights, set `keep_values`"});
    info.orientation = "smallest x at the left, smallest y at the top";
    if (!labels.x || labels.x->counts || !labels.y || labels.y->counts) return;
    const auto units = units_of_map(info, {labels.unit, header.unit}, options, source);
    header.unit = units.heights;
    if (units.positions.empty()) return;
    const double unit = length_unit(units.positions, source).factor;
    info.size = {static_cast<double>(labels.x->count) * std::abs(labels.x->step) * unit,
                 static_cast<double>(labels.y->count) * std::abs(labels.y->step) * unit};
}

/// Header of the numbers of a text, and its lines.
struct SectionHeader {
    MatrixHeader header;
    std::vector<std::string> text;
};

/// Metadata from the table of a confocal microscope.
void take_microscope(topography::Metadata& metadata) {
    const auto model = metadata.attributes.find("model"), date = metadata.attributes.find("date and time");
    if (date != metadata.attributes.end()) metadata.acquisition_time = date->second;
    if (model == metadata.attributes.end()) return;
    metadata.instrument.name = model->second;
    metadata.instrument.type = "optical";
}

/// Whether the first numbers increase by one, as in an index.
bool count_on(const tables::NumberLines& lines) {
    constexpr Index enough = 64, fewest = 32;
    if (lines.rows * lines.columns < fewest) return false;
    const auto numbers = tables::read_numbers(lines, {.count = std::min(lines.rows, enough / lines.columns + 1)});
    for (Index j = 0; j < numbers.cols(); ++j)
        for (Index i = 0; i < numbers.rows(); ++i)
            if (numbers(i, j) != numbers(0, 0) + static_cast<double>(j * numbers.rows() + i)) return false;
    return numbers(0, 0) != numbers(numbers.rows() - 1, numbers.cols() - 1);  // a step of 1 is below the rounding of
                                                                              // 1e30
}

/// Why unnamed numbers are no map; empty if they may be one.
std::string reason_against_map(const tables::NumberLines& lines, const Layer& layer, const ReadOptions& options) {
    constexpr Index max_columns = 6, tallest = 200;
    if (options.keep_values || options.layout == TextLayout::matrix) return {};
    const bool sized = options.size && options.size->size() == 2;
    if (!sized && layer.nx > 1 && layer.nx <= max_columns && layer.ny >= tallest)
        return fmt::format("{} rows of {} numbers: a table of {} columns; set `layout` to matrix to read it as a map",
                           layer.ny, layer.nx, layer.nx);
    return count_on(lines) ? "whole numbers that increase by one from value to value" : std::string();
}

Channel channel_of(const tables::NumberLines& lines, const SectionHeader& section, const ReadOptions& options,
                   const std::vector<Alert>& alerts) {
    auto header = section.header;
    tables::require_whole_last_line(lines);
    const auto layer = layer_of(lines, header, section.text, options);
    ChannelInfo info;
    info.name = info.metadata.name = header.name;
    info.format = "matrix";
    info.metadata.file = lines.source.name;
    info.metadata.attributes = header.attributes;
    take_microscope(info.metadata);
    info.alerts = alerts;
    info.shape =
        layer.is_line ? std::vector<Index>{std::max(layer.nx, layer.ny)} : std::vector<Index>{layer.nx, layer.ny};
    if (!layer.is_line)
        info.orientation = header.lines_are_columns ? "columns from the left, each from the bottom, turned"
                                                    : "rows from the top, as stored";
    if (!layer.is_line) info.size = size_of(header, layer);
    if (layer.labels.any()) apply_labels(layer.labels, header, info, options, lines.source);
    info.unit = header.unit;
    const auto unit = tables::try_parse_unit(header.unit);
    const bool other_quantity = !header.unit.empty() && (!unit || unit->dimension != dimension::length);
    if (other_quantity || !header.heights) return non_height_channel(std::move(info));
    const double stated = header.factor * (unit ? unit->factor : 1.0);
    compare_unit(info, options, lines.source);
    const double factor = stated * complete(info, options, lines.source);
    const bool unit_is_all = layer.labels.x && layer.labels.y && !layer.labels.x->counts && !layer.labels.y->counts;
    if (unit_is_all && info.unit.empty()) return channel_without_unit(std::move(info), lines.source);
    const bool loose = section.header.unit.empty() && !header.is_map;
    const auto why = loose ? reason_against_map(lines, layer, options) : std::string();
    if (info.size.empty() || info.unit.empty()) {
        auto channel = incomplete_channel(std::move(info), lines.source);
        return why.empty() ? channel : doubtful_channel(std::move(channel), why);
    }
    auto read = [lines, layer, factor, info] { return measured(lines, layer, factor, info); };
    Channel channel{std::move(info), std::move(read)};
    return why.empty() ? channel : doubtful_channel(std::move(channel), why);
}

/// Text from one byte to another as the lines of a header.
std::vector<std::string> header_lines(const bytes::Source& source, std::uint64_t begin, std::uint64_t end) {
    constexpr std::uint64_t longest = 1 << 16;
    std::vector<std::string> lines;
    const auto text = bytes::decoded(source.bytes(begin, std::min(end - begin, longest)), bytes::Encoding::detect);
    for (const auto line : bytes::split_lines(text)) lines.emplace_back(trimmed(line));
    return lines;
}

/// Start of a header between numbers, and of the numbers below it.
struct Section {
    std::uint64_t begin = 0, numbers = 0, line = 0;
};

/// Headers of further maps among the breaks of the lines of numbers.
std::vector<Section> sections_of(const tables::NumberLines& lines, const MatrixHeader& header) {
    std::vector<Section> sections;
    for (std::size_t i = 0; i < lines.breaks.size(); ++i) {
        const auto& found = lines.breaks[i];
        const auto text =
            header_lines(lines.source, found.offset,
                         std::min(found.offset + 4096, lines.blocks.back().offset + lines.blocks.back().size));
        if (text.empty() || !begins_numbers(text.front(), header)) continue;
        Section section{found.offset, found.offset, found.line};
        std::size_t last = i;
        for (; last + 1 < lines.breaks.size() && lines.breaks[last + 1].line <= lines.breaks[last].line + 1; ++last) {
        }
        i = last;
        section.numbers = lines.breaks[last].offset;
        section.line = lines.breaks[last].line;
        sections.push_back(section);
    }
    return sections;
}

}  // namespace

std::vector<Channel> matrix_channels(const tables::TextStart& start, const MatrixHeader& header,
                                     const ReadOptions& options, const std::vector<Alert>& alerts) {
    const auto end = start.source.size;
    auto lines = tables::find_number_lines(start, start.begin, end);
    const auto sections = sections_of(lines, header);
    if (sections.empty()) return {channel_of(lines, {header, start.header}, options, alerts)};
    std::vector<Channel> channels;
    SectionHeader current{header, start.header};
    auto part = start;
    for (std::size_t i = 0; i <= sections.size(); ++i) {
        const auto part_end = i < sections.size() ? sections[i].begin : end;
        channels.push_back(channel_of(tables::find_number_lines(part, part.begin, part_end), current, options, alerts));
        if (i == sections.size()) break;
        const auto next_end = i + 1 < sections.size() ? sections[i + 1].begin : end;
        auto below = bytes::part_of(start.source, start.source.name, sections[i].begin, next_end - sections[i].begin);
        const auto next = find_start(below);
        if (!next)
            throw FormatError(start.source.name, {.line = sections[i].line + 1},
                              "a header without numbers below it; the file may be truncated here");
        current = {parse_matrix_header(next->header, start.source, current.header), next->header};
        part.layout = next->layout;
        part.begin = sections[i].begin + next->begin;
        part.line = sections[i].line + next->line;
    }
    return channels;
}

}  // namespace setae::formats
