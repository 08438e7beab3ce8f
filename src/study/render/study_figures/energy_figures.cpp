// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/figures/typesetting.hpp"
#include "setae/study_figures/loop_figures.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;

constexpr Index points_per_curve = 400;

/// µm², or mm² where there are more than a hundredth of one.
DisplayUnit area_unit(double largest_area) {
    return largest_area > 1e-8 ? DisplayUnit{1e-6, "mm2"} : DisplayUnit{1e-12, "um2"};
}

figures::Series line(const std::string& label, const Array1D& x, const Array1D& y, int colour) {
    const auto shown = thinned(x, y, 0, x.size() - 1, points_per_curve);
    return {
        .label = label, .x = taken(x, shown), .y = taken(y, shown), .mark = Mark::line, .colour = colour, .dash = 0};
}

}  // namespace

StudyFigure course_figure(const DrawnLoop& loop, const loops::EnergyCourse& course, const std::string& command) {
    StudyFigure drawn{.identifier = "energy",
                      .name = loop.name + "_energy",
                      .title = fmt::format("{}: energy budget of the loop", loop.name),
                      .command = command};
    const auto& record = loop.analysis.corrected;
    const bool timed = record.time.size() > 0;
    const Index n = course.work.size();
    const Array1D samples =
        Array1D::LinSpaced(n, static_cast<double>(course.range.first), static_cast<double>(course.range.last));
    const Array1D clock = timed ? Array1D(record.time.segment(course.range.first, n)) : samples;
    const auto energy = display_unit(std::max(course.work.abs().maxCoeff(), course.elastic.abs().maxCoeff()), "J");
    Panel along{.title = "A",
                .shows = "along the loop",
                .x = {.quantity = timed ? "time *t*" : "sample", .unit = timed ? "s" : "1"},
                .y = {.quantity = "energy", .unit = energy.name}};
    along.series = {line("work ∫F dδ", clock, course.work / energy.factor, colour::black),
                    line("elastic", clock, course.elastic / energy.factor, colour::blue),
                    line("surface −WA", clock, course.surface / energy.factor, colour::green),
                    line("dissipated", clock, course.dissipated / energy.factor, colour::vermilion)};
    along.horizontal_lines = {0.0};
    const Array1D area = pi * course.contact_radius.square();
    const auto square = area_unit(area.maxCoeff());
    Panel against{.title = "B",
                  .shows = "against the contact",
                  .x = {.quantity = "contact area *πa*²", .unit = square.name},
                  .y = {.quantity = "dissipated energy", .unit = energy.name}};
    against.series = {line("dissipated", area / square.factor, course.dissipated / energy.factor, colour::vermilion)};
    against.legend = false;
    drawn.figure = {.panels = {along, against}, .columns = 2, .width_mm = page_mm, .height_mm = 70.0};
    drawn.caption = fmt::format(
        "{}: cumulative external work, stored elastic energy, surface energy (−W of loading times contact area), and the dissipated rest. The jumps and a contact edge that needs more "
        "than W on retraction dissipate energy. The contact radius is {}. Closed loop: {} {}. Ideal smooth sphere: {} {}.",
        loop.name, course.radius_measured ? "measured" : "calculated from force, displacement and E*",
        fmt::format("{:.4g}", course.work[n - 1] / energy.factor), energy.name,
        figures::number_text(loop.analysis.budget ? loop.analysis.budget->ideal_this_machine / energy.factor : 0.0, 3),
        energy.name);
    return drawn;
}

StudyFigure loss_figure(const std::vector<NamedLoss>& losses, const std::string& command) {
    StudyFigure drawn{
        .identifier = "losses", .name = "losses", .title = "Energy loss against true area", .command = command};
    if (losses.empty()) {
        drawn.reason = "no loop is closed";
        return drawn;
    }
    const auto n = static_cast<Index>(losses.size());
    Array1D area(n), loss(n), error(n), ideal(n);
    std::vector<std::string> names;
    for (Index i = 0; i < n; ++i) {
        const auto& l = losses[static_cast<std::size_t>(i)];
        area[i] = l.true_area;
        loss[i] = l.loss.value;
        error[i] = l.loss.standard_error;
        ideal[i] = l.ideal_loss;
        names.push_back(l.name);
    }
    const auto energy = display_unit(loss.abs().maxCoeff(), "J");
    const auto square = area_unit(area.maxCoeff());
    const double work = (area * loss).sum() / area.square().sum(),
                 beyond = (area * (loss - ideal)).sum() / area.square().sum();
    const Array1D ends = Array1D::LinSpaced(2, 0.0, 1.05 * area.maxCoeff());
    Panel panel{.title = "",
                .x = {.quantity = "true area *A*_true", .unit = square.name, .from = 0.0},
                .y = {.quantity = "*E*_loss", .unit = energy.name, .from = 0.0}};
    panel.series = {{.label = "loops",
                     .x = area / square.factor,
                     .y = loss / energy.factor,
                     .lower = (loss - error) / energy.factor,
                     .upper = (loss + error) / energy.factor,
                     .mark = Mark::points,
                     .colour = colour::blue,
                     .names = names},
                    {.label = "ideal smooth sphere",
                     .x = area / square.factor,
                     .y = ideal / energy.factor,
                     .mark = Mark::points,
                     .colour = colour::black,
                     .hollow = true,
                     .names = names},
                    {.label = "through the origin",
                     .x = ends / square.factor,
                     .y = ends * work / energy.factor,
                     .mark = Mark::line,
                     .colour = colour::blue,
                     .dash = 1}};
    drawn.figure = {.panels = {panel}, .width_mm = column_mm, .height_mm = 70.0};
    drawn.caption = fmt::format(
        "Energy loss of {} against the true contact area at the largest preload; bars are one standard error. Line through the origin by least squares: {:.4g} mJ/m²; after "
        "subtracting the loss of a smooth sphere in its jumps (hollow): {:.4g} mJ/m².",
        counted(losses.size(), "loop"), 1e3 * work, 1e3 * beyond);
    return drawn;
}

}  // namespace setae::study_figures
