// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/sweep_figure.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "axes.hpp"

namespace setae::file_figures {
namespace {

/// Rows of one branch; the separation begins where the approach ended.
struct SweepBranch {
    Index first = 0, count = 0;
};
SweepBranch branch(const Table& table, bool approach) {
    const auto& approaching = table.at("approaching");
    const auto there = static_cast<Index>((approaching > 0.5).count());
    return approach ? SweepBranch{0, there}
                    : SweepBranch{std::max<Index>(0, there - 1), table.rows() - std::max<Index>(0, there - 1)};
}

figures::Panel sweep_panel(const Table& table, const char* title, const char* column, const DisplayUnit& gap_unit,
                           const DisplayUnit& unit, const char* quantity) {
    figures::Panel panel{.title = title,
                         .x = {.quantity = "mean gap *g*", .unit = gap_unit.name},
                         .y = {.quantity = quantity, .unit = unit.name}};
    for (const bool approach : {true, false}) {
        const auto rows = branch(table, approach);
        panel.series.push_back({.label = approach ? "approach" : "separation",
                                .x = table.at("mean_gap").segment(rows.first, rows.count) / gap_unit.factor,
                                .y = table.at(column).segment(rows.first, rows.count) / unit.factor,
                                .mark = figures::Mark::line,
                                .colour = approach ? 0 : 1,
                                .dash = approach ? 0 : 1});
    }
    return panel;
}

}  // namespace

StudyFigure sweep_figure(const Table& table, const std::string& file, const Look& look) {
    const auto gap = axis_unit(table.at("mean_gap"), "m"), tension = axis_unit(table.at("tension"), "Pa");
    StudyFigure drawn{.identifier = "sweep", .name = "Approach and separation", .command = look.command};
    drawn.title = fmt::format("{}: approach and separation", file_name(file));
    drawn.caption =
        "A: mean tension (negative under pressure); the area between the branches is the energy loss. B: area in contact over the "
        "nominal area.";
    const bool wide = look.wide();
    drawn.figure = {.panels = {sweep_panel(table, "A", "tension", gap, tension, "mean tension *T*"),
                               sweep_panel(table, "B", "area_fraction", gap, {.factor = 1.0, .name = "1"},
                                           "area in contact *A*/*A*_0")},
                    .columns = wide ? 2 : 1,
                    .width_mm = wide ? page_mm : column_mm,
                    .height_mm = wide ? 70.0 : 120.0};
    return drawn;
}

}  // namespace setae::file_figures
