// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "arrangement.hpp"
#include "drawing.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"
#include "setae/figures/notes.hpp"
#include "setae/output/budget.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;

/// The end of a long name is more specific than the beginning: "…E07.surface_energy".
std::string shortened_name(std::string_view name, FigureWidth width) {
    return last_words(name, width == FigureWidth::single_column ? 28 : 44);
}

/// A bar from 0 to `length` [%] at a height.
figures::Series bar(double length, double height) {
    constexpr double half = 0.3;
    return {.x = Array1D{{0.0, length, length, 0.0, 0.0}},
            .y = Array1D{{height - half, height - half, height + half, height + half, height - half}},
            .mark = Mark::area,
            .colour = 0,
            .opacity = 0.75,
            .in_legend = false};
}

}  // namespace

void budget_of_work(const FigureRequest& request, StudyFigure& drawn) {
    const auto budgets = output::budgets_of(request.result);
    const auto found = std::find_if(budgets.begin(), budgets.end(),
                                    [](const auto& budget) { return budget.quantity == "intrinsic_work_of_adhesion"; });
    if (found == budgets.end()) {
        drawn.reason = "no W_int with a standard error";
        return;
    }
    constexpr std::size_t most = 8;
    const auto& budget = *found;
    const auto count = std::min(most, budget.rows.size());
    const double largest = budget.rows.empty() ? 1.0 : budget.rows.front().share, end = 105.0 * std::max(0.01, largest);
    figures::Panel panel{.x = {.quantity = "share of variance", .unit = "%", .from = 0.0, .to = end},
                         .y = {.from = -0.6, .to = static_cast<double>(count) - 0.4},
                         .legend = false};
    panel.y.tick_labels.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const auto& row = budget.rows[i];
        const double height = static_cast<double>(count - 1 - i), length = 100.0 * row.share;
        panel.y.tick_labels[count - 1 - i] = shortened_name(row.input, request.options.width);
        panel.series.push_back(bar(length, height));
        panel.notes.push_back({.text = fmt::format("± {}", format_value(row.halved, budget.unit, 2)),
                               .x = length + 0.015 * end,
                               .y = height,
                               .side = figures::Note::Side::right});
    }
    drawn.figure.panels = {std::move(panel)};
    arrange(drawn.figure, request.options.width, 22.0 + 7.0 * static_cast<double>(count));
    figures::extend_for_notes(drawn.figure);
    drawn.caption = fmt::format(
        "Contributions of the inputs to the variance of W_int, whose ± is {}{}. The number beside each bar is the remaining ± "
        "if the ± of this input is halved.",
        format_value(budget.standard_error, budget.unit, 2),
        budget.rows.size() > count ? fmt::format("; the {} largest of {}", count, budget.rows.size()) : "");
}

}  // namespace setae::study_figures
