// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "jpk_archive.hpp"
#include "jpk_segment.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/tables/force_curve_formats.hpp"

// header.properties states the kind of the file; a curve is a folder "segments" with a folder for each of its segments,
// a map a folder "index" with such a curve in each of its numbered folders. Common properties of all segments may be in
// shared-data/header.properties.
namespace setae::tables {
namespace {

/// The first word of the keys of a file, "force-scan" or "quantitative-imaging", by the type in its header.
std::string family(const Properties& header) {
    const auto type = property(header, "type").value_or("");
    return type.starts_with("quantitative-imaging") ? "quantitative-imaging" : "force-scan";
}

std::optional<double> finite(const Properties& properties, const std::string& key) {
    const auto text = property(properties, key);
    const auto value = text ? spelled<double>(*text) : std::nullopt;
    return value && std::isfinite(*value) ? value : std::nullopt;
}

/// Adds user and instrument in the header of a file or a curve.
void add_description(const Properties& header, const std::string& series, ForceCurveData& data) {
    for (const char* wanted : {"instrument", "probe", "comment", "source-software"})
        if (const auto value = property(header, fmt::format("{}.description.{}", series, wanted));
            value && !value->empty())
            data.metadata.emplace(wanted, *value);
}

void add_place(const Properties& header, const std::string& series, const JpkSegment& first, ForceCurveData& data) {
    const auto place = [&](const char* axis) {
        const auto key = fmt::format("position.{}", axis);
        auto text = property(header, fmt::format("{}.header.{}", series, key));
        if (!text) text = first.find(key);
        if (!text) return undefined;
        data.metadata.emplace(fmt::format("position_{}", axis), *text + " m");
        return spelled<double>(*text).value_or(undefined);
    };
    data.x = place("x");
    data.y = place("y");
}

ForceCurveData read_curve(const JpkArchive& archive, const std::vector<std::string>& folders,
                          const Properties& header) {
    ForceCurveData data;
    data.reading = Reading::volts;
    data.travel_sign = -1.0;
    const auto series = family(archive.header()) + "-series";
    add_description(header, series, data);
    for (const auto& folder : folders) {
        const JpkSegment segment(archive, folder);
        data.segments.push_back(segment.read());
        data.metadata.emplace("height_channel", segment.height_channel());
        if (const auto stamp = segment.find("time-stamp")) data.metadata.emplace("date", *stamp);
        if (data.segments.size() > 1) continue;
        data.constants = segment.constants();
        add_place(header, series, segment, data);
    }
    return data;
}

/// The pattern of a map's positions; empty if it is no grid. @throws FormatError for one that is damaged.
std::optional<MapGrid> grid_of(const JpkArchive& archive) {
    const auto& header = archive.header();
    const auto pattern = family(header) + "-map.position-pattern.";
    if (property(header, pattern + "type") != "grid-position-pattern") return std::nullopt;
    const auto value = [&](const char* key) {
        const auto found = finite(header, pattern + "grid." + key);
        if (!found)
            throw FormatError(archive.source().name, {},
                              fmt::format("member 'header.properties' has no number '{}grid.{}'", pattern, key));
        return *found;
    };
    const double columns = value("ilength"), rows = value("jlength");
    const MapGrid grid{.columns = static_cast<Index>(std::min(columns, 1e9)),
                       .rows = static_cast<Index>(std::min(rows, 1e9)),
                       .width = value("ulength"),
                       .height = value("vlength"),
                       .x = value("xcenter"),
                       .y = value("ycenter"),
                       .angle = value("theta")};
    if (!(columns >= 1.0 && rows >= 1.0 && columns * rows <= static_cast<double>(max_map_points)) ||
        !(grid.width > 0.0 && grid.height > 0.0))
        throw FormatError(
            archive.source().name, {},
            fmt::format("member 'header.properties': a grid of {} × {} curves over {} m × {} m, expected at least one "
                        "and at most {} on a positive area; it is damaged",
                        columns, rows, grid.width, grid.height, max_map_points));
    return grid;
}

JpkKind jpk_kind(const bytes::Source& source) {
    return bytes::is_zip(source.head(4)) ? JpkArchive(source).kind() : JpkKind::other;
}

}  // namespace

bool is_jpk_force(const bytes::Source& source) { return jpk_kind(source) == JpkKind::curve; }

ForceCurveData read_jpk_force(const bytes::Source& source) {
    const JpkArchive archive(source);
    return read_curve(archive, archive.curves().begin()->second, archive.header());
}

bool is_jpk_map(const bytes::Source& source) { return jpk_kind(source) == JpkKind::map; }

ForceCurveFile open_jpk_map(const bytes::Source& source) {
    const auto archive = std::make_shared<const JpkArchive>(source);
    ForceCurveFile file{.grid = grid_of(*archive)};
    for (const auto& [number, folders] : archive->curves()) file.numbers.push_back(number);
    file.read = [archive](long number) {
        return read_curve(*archive, archive->curves().at(number),
                          archive->properties(fmt::format("index/{}/header.properties", number)));
    };
    return file;
}

}  // namespace setae::tables
