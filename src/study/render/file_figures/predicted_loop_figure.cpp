// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/file_figures/predicted_loop_figure.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "axes.hpp"
#include "setae/core/words.hpp"
#include "setae/hysteresis/loop_course.hpp"
#include "setae/study_figures/hysteresis_figures.hpp"

namespace setae::file_figures {
namespace {

using figures::Mark;
using figures::Panel;
using study::PairHysteresis;

/// Drawn data of a loop's curve.
struct Course {
    Array1D displacement, force, contact_radius;
    explicit Course(const Table& table)
        : displacement(table.at("displacement")),
          force(table.at("force")),
          contact_radius(table.at("contact_radius")) {}
};

/// Works of retraction one standard error above and below, those that are at least W_app.
std::vector<hysteresis::HystereticSphere> spheres_beside(const hysteresis::PredictedRetraction& loop) {
    std::vector<hysteresis::HystereticSphere> beside;
    for (const double sign : {-1.0, 1.0}) {
        auto sphere = loop.sphere;
        sphere.work_retraction =
            std::max(sphere.work_approach, sphere.work_retraction + sign * loop.work_retraction.standard_error());
        if (sphere.work_retraction != loop.sphere.work_retraction) beside.push_back(sphere);
    }
    return beside;
}

/// Both panels of a curve.
class LoopPanels {
public:
    LoopPanels(const Array1D& displacement, const Array1D& force, const Array1D& radius)
        : along_(axis_unit(displacement, "m")), force_(axis_unit(force, "N")), radius_(axis_unit(radius, "m")) {
        curve_ = {.title = "A",
                  .x = {.quantity = "displacement *δ*", .unit = along_.name},
                  .y = {.quantity = "force *F*", .unit = force_.name}};
        edge_ = {.title = "B",
                 .x = {.quantity = "force *F*", .unit = force_.name},
                 .y = {.quantity = "contact radius *a*", .unit = radius_.name},
                 .legend = false};
    }

    void add(const std::string& label, const Array1D& displacement, const Array1D& force, const Array1D& radius,
             const figures::Series& style) {
        auto series = style;
        series.label = label;
        series.x = displacement / along_.factor;
        series.y = force / force_.factor;
        curve_.series.push_back(series);
        if (radius.size() == 0) return;
        series.x = force / force_.factor;
        series.y = radius / radius_.factor;
        edge_.series.push_back(std::move(series));
    }

    [[nodiscard]] std::vector<Panel> panels() const { return {curve_, edge_}; }

private:
    DisplayUnit along_, force_, radius_;
    Panel curve_, edge_;
};

/// Where the energy of the predicted loop goes, and that of the measured one went.
Panel losses_of(const PairHysteresis& pair) {
    std::vector<study_figures::LossBar> bars{{"predicted", pair.loop->shares, std::nullopt}};
    if (pair.decomposition)
        bars.push_back({"measured", pair.decomposition->shares, pair.decomposition->measured.estimate()});
    auto panel = study_figures::losses_panel(bars);
    panel.title = "C";
    panel.y.to = static_cast<double>(bars.size()) + 0.9;  // space above the bars for the legend
    return panel;
}

}  // namespace

StudyFigure predicted_loop_figure(const PairHysteresis& pair, const study::StudyResult& result, const Look& look) {
    StudyFigure drawn{.identifier = fmt::format("loop:{} {}", pair.surface, pair.elastomer),
                      .name = fmt::format("loop {} {}", pair.surface, pair.elastomer),
                      .command = look.command};
    drawn.title = fmt::format("{} on {}: loop predicted from roughness", pair.elastomer, pair.surface);
    if (!pair.loop) {
        drawn.reason = pair.loop.reason;
        return drawn;
    }
    const auto& pressing = pair.loop->pressing;
    const Course course(hysteresis::loop_course(pair.loop->sphere, pressing, pair.loop->edge));
    LoopPanels panels(course.displacement, course.force, course.contact_radius);
    std::size_t records = 0;
    for (const auto& e : result.experiments) {
        if (!e.analysis || e.input.surface != pair.surface || e.input.elastomer != pair.elastomer) continue;
        const auto& record = e.analysis->corrected;
        panels.add(records == 0 ? "measured" : "", record.displacement, record.force, record.contact_radius,
                   {.mark = Mark::points, .colour = 1, .opacity = 0.4, .in_legend = records == 0});
        ++records;
    }
    bool first = true;
    for (const auto& sphere : spheres_beside(*pair.loop)) {
        const Course beside(hysteresis::loop_course(sphere, pressing, pair.loop->edge));
        panels.add("W_ret ± its standard error", beside.displacement, beside.force, beside.contact_radius,
                   {.mark = Mark::line, .colour = 0, .dash = 1, .line_width = 0.8, .opacity = 0.7, .in_legend = first});
        first = false;
    }
    panels.add(fmt::format("predicted, {}", pair.model.name()), course.displacement, course.force,
               course.contact_radius, {.mark = Mark::line, .colour = 0, .dash = 0});
    auto all = panels.panels();
    all.push_back(losses_of(pair));
    drawn.figure = {.panels = std::move(all),
                    .columns = look.wide() ? 2 : 1,
                    .width_mm = look.wide() ? page_mm : column_mm,
                    .height_mm = look.wide() ? 135.0 : 190.0};
    drawn.caption = fmt::format(
        "Loop predicted from roughness by {}: force against displacement, contact radius against force, and energy budget. Dashed: "
        "W_ret plus or minus one standard error.{}{}",
        pair.model.name(),
        records > 0 ? fmt::format(" Points: {} of the study.", counted(records, "record", "records")) : "",
        pair.decomposition ? " Lower bar: energy budget of the measured loop; symbol: measured energy loss." : "");
    return drawn;
}

}  // namespace setae::file_figures
