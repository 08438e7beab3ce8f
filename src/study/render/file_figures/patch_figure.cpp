// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/patch_figure.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "axes.hpp"

namespace setae::file_figures {
namespace {

using patches::PatchMean;
using patches::SurveyRow;

/// Rows of patches that differ in nothing but the share of energy, by rising share.
struct Kind {
    std::vector<const SurveyRow*> rows;

    [[nodiscard]] std::string label() const {
        return fmt::format("band {:.3g}, {} points, μ² {:.2g}", rows.front()->design.band(),
                           rows.front()->design.points, rows.front()->design.squared_ratio);
    }
};

std::vector<Kind> kinds_of(const std::vector<SurveyRow>& rows) {
    std::vector<Kind> kinds;
    for (const auto& row : rows) {
        auto found =
            std::ranges::find_if(kinds, [&](const Kind& kind) { return kind.rows.front()->design.like(row.design); });
        if (found == kinds.end()) kinds.push_back({{&row}});
        else found->rows.push_back(&row);
    }
    for (auto& kind : kinds)
        std::ranges::stable_sort(kind.rows, {}, [](const SurveyRow* row) { return row->design.energy_share; });
    return kinds;
}

figures::Series points_of(const Kind& kind, PatchMean SurveyRow::*what, int colour, bool hollow, bool in_legend) {
    const auto n = static_cast<Index>(kind.rows.size());
    const auto of = [&](auto value) {
        return Array1D(
            Array1D::NullaryExpr(n, [&](Index i) { return value(*kind.rows[static_cast<std::size_t>(i)]); }));
    };
    return {.label = kind.label(),
            .x = of([](const SurveyRow& row) { return row.design.energy_share; }),
            .y = of([&](const SurveyRow& row) { return (row.*what).value; }),
            .lower = of([&](const SurveyRow& row) { return (row.*what).value - (row.*what).standard_error; }),
            .upper = of([&](const SurveyRow& row) { return (row.*what).value + (row.*what).standard_error; }),
            .mark = figures::Mark::both,
            .colour = colour,
            .symbol = colour,
            .hollow = hollow,
            .dash = hollow ? 1 : 0,
            .in_legend = in_legend};
}

}  // namespace

StudyFigure patch_figure(const std::vector<SurveyRow>& rows, const Look& look) {
    StudyFigure drawn{.identifier = "conform", .name = "conform", .command = look.command};
    drawn.title = "Energy gain and contact area against stored energy";
    const figures::Axis share{.quantity = "stored energy *U*_el/*AW*", .unit = "1", .from = 0.0};
    figures::Panel gain{.title = "A", .x = share, .y = {.quantity = "energy gain/*W*", .unit = "1"}},
        area{.title = "B", .x = share, .y = {.quantity = "area in contact", .unit = "1", .from = 0.0, .to = 1.05}};
    double largest = 1.0;
    for (const auto& row : rows) largest = std::max(largest, row.design.energy_share);
    gain.series.push_back({.label = "(7)",
                           .x = Array1D{{0.0, 1.0, largest}},
                           .y = Array1D{{1.0, 0.0, 0.0}},
                           .mark = figures::Mark::line,
                           .colour = black,
                           .dash = 0});
    int colour = 0;
    for (const auto& kind : kinds_of(rows)) {
        gain.series.push_back(points_of(kind, &SurveyRow::gain_from_far, colour, false, true));
        area.series.push_back(points_of(kind, &SurveyRow::area_from_far, colour, false, false));
        area.series.push_back(points_of(kind, &SurveyRow::area_after_preload, colour, true, false));
        ++colour;
    }
    area.legend = false;
    drawn.figure = {.panels = {gain, area},
                    .columns = look.wide() ? 2 : 1,
                    .width_mm = look.wide() ? page_mm : column_mm,
                    .height_mm = look.wide() ? 75.0 : 130.0};
    drawn.caption = fmt::format(
        "Patches without load, {} each; bars are one standard error. A: energy gain on approach from a large distance, over W; line: full-contact balance (Eq. 7), "
        "at least 0. B: area in contact after approach from a large distance (filled) and after a pressure of h'E* (hollow).",
        rows.empty() ? 0 : rows.front().patches);
    return drawn;
}

}  // namespace setae::file_figures
