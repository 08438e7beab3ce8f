// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/level_figure.hpp"

#include <algorithm>
#include <variant>

#include <fmt/format.h>

#include "axes.hpp"
#include "setae/study/height_preview.hpp"

namespace setae::file_figures {
namespace {

using figures::Mark;
using figures::Panel;

constexpr Index points_per_line = 1000, cells_per_side = 256;

/// Mean of the defined values; 0 where there is none.
template <class Values>
double mean_of(const Values& values) {
    const auto defined = values.isFinite();
    const auto n = defined.count();
    return n == 0 ? 0.0 : defined.select(values, 0.0).sum() / static_cast<double>(n);
}

/// "B after, 2.3 % undefined (white)".
std::string title_of(const char* when, const topography::Measurement& measurement) {
    const auto heights = topography::all_heights(measurement);
    const auto missing = heights.isNaN().count();
    if (missing == 0) return when;
    const bool map = std::holds_alternative<topography::HeightMap>(measurement);
    return fmt::format("{}, {:.2g} % undefined{}", when,
                       100.0 * static_cast<double>(missing) / static_cast<double>(heights.size()),
                       map ? " (white)" : "");
}

Panel map_panel(const char* when, const topography::Measurement& measurement) {
    const auto preview = study::height_preview(measurement, points_per_line, cells_per_side);
    const Array2D heights = preview.map - mean_of(preview.map);
    const auto across = axis_unit(Array1D{{preview.size[0], preview.size[1]}}, "m");
    const auto height = axis_unit(heights.reshaped(), "m");
    Panel panel{.title = title_of(when, measurement),
                .x = {.quantity = "*x*", .unit = across.name},
                .y = {.quantity = "*y*", .unit = across.name},
                .legend = false};
    panel.map = figures::HeatMap{.values = heights / height.factor,
                                 .width = preview.size[0] / across.factor,
                                 .height = preview.size[1] / across.factor,
                                 .values_axis = {.quantity = "height *h*", .unit = height.name}};
    return panel;
}

Panel line_panel(const char* when, const topography::Measurement& measurement) {
    const auto preview = study::height_preview(measurement, points_per_line, cells_per_side);
    const Array1D heights = preview.heights - mean_of(preview.heights), x = preview.positions - preview.positions[0];
    const auto across = axis_unit(x, "m"), height = axis_unit(heights, "m");
    Panel panel{.title = title_of(when, measurement),
                .x = {.quantity = "*x*", .unit = across.name},
                .y = {.quantity = "height *h*", .unit = height.name},
                .legend = false};
    panel.series.push_back({.label = when,
                            .x = x / across.factor,
                            .y = heights / height.factor,
                            .mark = Mark::line,
                            .colour = black,
                            .dash = 0,
                            .line_width = 0.8});
    return panel;
}

std::string steps_of(const processing::PipelineResult& after) {
    std::string text;
    for (const auto& record : after.records) text += (text.empty() ? "" : ", ") + record.step;
    return text;
}

}  // namespace

StudyFigure level_figure(const topography::Measurement& before, const processing::PipelineResult& after,
                         const Look& look) {
    const bool map = std::holds_alternative<topography::HeightMap>(after.measurement);
    const auto panel = map ? map_panel : line_panel;
    const auto& file = topography::metadata(after.measurement).file;
    StudyFigure drawn{.identifier = "level",
                      .name = stem(file) + "_levelled",
                      .title = "Heights of " + file_name(file) + " before and after processing",
                      .command = look.command};
    drawn.figure = {.panels = {panel("before", before), panel("after", after.measurement)},
                    .columns = look.wide() ? 2 : 1,
                    .width_mm = look.wide() ? page_mm : column_mm,
                    .height_mm = look.wide() ? (map ? 75.0 : 60.0) : (map ? 120.0 : 100.0)};
    drawn.caption = fmt::format("Heights relative to their mean, before and after {}.{}", steps_of(after),
                                map ? " White: undefined." : "");
    return drawn;
}

}  // namespace setae::file_figures
