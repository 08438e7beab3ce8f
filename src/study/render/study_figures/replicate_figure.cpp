// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/study_figures/forest_plot.hpp"

namespace setae::study_figures {

void replicates_of_pairs(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    if (result.replicates.empty()) {
        drawn.reason = "no loop names a lens, a spot or an exclusion";
        return;
    }
    figures::Figure figure{.columns = 1, .width_mm = wide(request) ? 140.0 : column_mm, .height_mm = 0.0};
    std::size_t loops = 0, excluded = 0;
    std::string why;
    std::vector<double> heights;
    for (const auto& replicates : result.replicates) {
        if (replicates.symbol != "W_app") continue;
        if (!replicates.model) {
            why = replicates.model.reason;
            continue;
        }
        auto plot = forest_plot(replicates.data, *replicates.model,
                                {.quantity = "work of adhesion *W*_app", .unit = "mJ/m2", .factor = 1e3});
        auto& panel = plot.panels.front();
        panel.title = replicates.elastomer;
        // files are in the data only
        heights.push_back(plot.height_mm + 4.0);
        figure.height_mm += heights.back();
        figure.panels.push_back(std::move(panel));
        loops += replicates.data.rows.size();
        excluded += replicates.data.exclusions.size();
    }
    if (figure.panels.empty()) {
        drawn.reason = why.empty() ? "no loop with replicates has a work of adhesion" : why;
        return;
    }
    double top = 0.0;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        figure.panels[p].place = figures::Place{.top = top / figure.height_mm, .height = heights[p] / figure.height_mm};
        top += heights[p];
    }
    drawn.figure = figure;
    drawn.caption = fmt::format(
        "Work of adhesion on approach of {}, by elastomer and surface. Points: fits, with the 95 % interval of their standard errors. Diamonds: means of surfaces from a linear mixed model, with "
        "their 95 % interval; variances are pooled over the surfaces of an elastomer. Thin lines: range of 95 % of further measurements with another lens.{}",
        counted(loops, "loop"),
        excluded > 0
            ? fmt::format(" Hollow points: {} excluded, with the reason; hollow diamonds: means that include them.",
                          counted(excluded, "loop"))
            : "");
}

}  // namespace setae::study_figures
