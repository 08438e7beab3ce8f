// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/loop_figures.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/core/errors.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using loops::BranchAnalysis;
using loops::IndexRange;
using loops::JkrFit;
using loops::LoopAnalysis;

constexpr Index symbols_per_branch = 60, points_per_loop = 500, points_per_fit = 160;

/// Units in which all panels of a loop show the same quantity.
struct Units {
    DisplayUnit force, displacement, radius, release_rate;
};

double largest(const Array1D& values) {
    double most = 0.0;
    for (const double value : values)
        if (std::isfinite(value)) most = std::max(most, std::abs(value));
    return most;
}

/// As axes spell units: mJ/m2.
DisplayUnit typeset(DisplayUnit unit) {
    constexpr std::string_view square = "²";
    if (unit.name.ends_with(square)) unit.name.replace(unit.name.size() - square.size(), square.size(), "2");
    return unit;
}

Units units_of(const DrawnLoop& loop) {
    const auto& record = loop.analysis.corrected;
    const auto range =
        record.displacement.size() > 0 ? record.displacement.maxCoeff() - record.displacement.minCoeff() : 0.0;
    return {display_unit(largest(record.force), "N"), display_unit(range, "m"),
            display_unit(loop.analysis.context.largest_contact_radius, "m"),
            typeset(display_unit(largest(loop.analysis.loading.energy_release_rate.energy_release_rate), "J/m2"))};
}

figures::Axis axis(const char* quantity, const DisplayUnit& unit) { return {.quantity = quantity, .unit = unit.name}; }

/// δ at first contact, from the fit of depth where there is one.
double first_touch(const LoopAnalysis& analysis) {
    if (analysis.loading.force_displacement) return analysis.loading.force_displacement->contact_point.value;
    const auto& record = analysis.corrected;
    return record.displacement.size() > 0 ? record.displacement[analysis.segments.contacts.front().loading.first] : 0.0;
}

/// JKR's curve of a fit from its pull-off to the largest force.
struct FittedCurve {
    Array1D force, displacement, contact_radius;
};
FittedCurve fitted_curve(const JkrFit& fit, double radius, double largest_force) {
    const contact::jkr::Contact contact{radius, fit.contact_modulus.value, std::max(fit.work_of_adhesion.value, 0.0)};
    const double least = contact::jkr::pull_off_at_fixed_load(contact).force;
    if (!(largest_force > least)) return {};
    // even steps of the square root, because a(F) is vertical at pull-off
    const Array1D root = Array1D::LinSpaced(points_per_fit, 0.0, std::sqrt(largest_force - least));
    FittedCurve curve{.force = (least + root.square()).max(least)};
    curve.contact_radius = contact::jkr::contact_radius_at_force(curve.force, contact);
    curve.displacement =
        curve.contact_radius.unaryExpr([&](double a) { return contact::jkr::displacement(a, contact); });
    return curve;
}

struct BranchLook {
    const BranchAnalysis* branch;
    IndexRange range;  ///< range of the record
    std::string name;
    int colour;
    bool hollow;
};

std::vector<BranchLook> branches_of(const LoopAnalysis& analysis) {
    const auto& contact = analysis.segments.contacts.front();
    std::vector<BranchLook> branches{{&analysis.loading, contact.loading, "loading", colour::blue, true}};
    if (analysis.unloading && contact.unloading)
        branches.push_back({&*analysis.unloading.value, *contact.unloading, "unloading", colour::vermilion, false});
    return branches;
}

Panel force_panel(const DrawnLoop& loop, const Units& units) {
    const auto& record = loop.analysis.corrected;
    Panel panel{.title = "A",
                .shows = "force",
                .x = axis("displacement *δ*", units.displacement),
                .y = axis("force *F*", units.force)};
    const double origin = first_touch(loop.analysis);
    const Array1D x = (record.displacement - origin) / units.displacement.factor, y = record.force / units.force.factor;
    const auto& extent = loop.analysis.segments.contacts.front().extent;
    const auto samples = thinned(x, y, extent.first, extent.last, points_per_loop);
    if (loop.analysis.loop)
        panel.series.push_back({.label = "closed loop",
                                .x = taken(x, samples),
                                .y = taken(y, samples),
                                .mark = Mark::area,
                                .colour = colour::sky,
                                .opacity = 0.3});
    panel.series.push_back({.label = "record",
                            .x = taken(x, samples),
                            .y = taken(y, samples),
                            .mark = Mark::line,
                            .colour = colour::black,
                            .dash = 0,
                            .line_width = 0.8});
    for (const auto& branch : branches_of(loop.analysis)) {
        const auto& fit = branch.branch->force_displacement;
        if (!fit) continue;
        const auto curve = fitted_curve(*fit, loop.bodies.radius, record.force.maxCoeff());
        panel.series.push_back(
            {.label = "JKR, " + branch.name,
             .x = (curve.displacement + fit->contact_point.value - origin) / units.displacement.factor,
             .y = curve.force / units.force.factor,
             .mark = Mark::line,
             .colour = branch.colour,
             .dash = 1});
    }
    panel.horizontal_lines = {0.0};
    return panel;
}

Panel radius_panel(const DrawnLoop& loop, const Units& units) {
    Panel panel{.title = "B",
                .shows = "contact radius",
                .x = axis("force *F*", units.force),
                .y = axis("contact radius *a*", units.radius)};
    const auto& record = loop.analysis.corrected;
    for (const auto& branch : branches_of(loop.analysis)) {
        const auto curve = fitted_curve(branch.branch->primary(), loop.bodies.radius, record.force.maxCoeff());
        panel.series.push_back({.label = "JKR, " + branch.name,
                                .x = curve.force / units.force.factor,
                                .y = curve.contact_radius / units.radius.factor,
                                .mark = Mark::line,
                                .colour = branch.colour,
                                .dash = 1});
        if (record.contact_radius.size() == 0) continue;
        std::vector<Index> frames;
        for (Index i = branch.range.first; i <= branch.range.last; ++i)
            if (record.contact_radius[i] > 0.0) frames.push_back(i);
        const Array1D force = taken(record.force, frames) / units.force.factor,
                      radius = taken(record.contact_radius, frames) / units.radius.factor;
        const auto shown = thinned(force, radius, 0, force.size() - 1, symbols_per_branch);
        panel.series.push_back({.label = branch.name,
                                .x = taken(force, shown),
                                .y = taken(radius, shown),
                                .mark = Mark::points,
                                .colour = branch.colour,
                                .hollow = branch.hollow});
    }
    return panel;
}

Panel release_rate_panel(const DrawnLoop& loop, const Units& units) {
    Panel panel{.title = "C",
                .shows = "energy release rate",
                .x = axis("contact radius *a*", units.radius),
                .y = axis("energy release rate *G*", units.release_rate)};
    panel.y.from = 0.0;
    for (const auto& branch : branches_of(loop.analysis)) {
        const auto& rates = branch.branch->energy_release_rate;
        const Array1D radius = rates.contact_radius / units.radius.factor,
                      rate = rates.energy_release_rate / units.release_rate.factor;
        if (radius.size() == 0) continue;
        const auto shown = thinned(radius, rate, 0, radius.size() - 1, symbols_per_branch);
        panel.series.push_back({.label = branch.name,
                                .x = taken(radius, shown),
                                .y = taken(rate, shown),
                                .mark = Mark::points,
                                .colour = branch.colour,
                                .hollow = branch.hollow});
        const double work = branch.branch->primary().work_of_adhesion.value / units.release_rate.factor;
        panel.series.push_back({.label = "W of " + branch.name,
                                .x = array_of({radius.minCoeff(), radius.maxCoeff()}),
                                .y = array_of({work, work}),
                                .mark = Mark::line,
                                .colour = branch.colour,
                                .dash = 1,
                                .in_legend = false});
    }
    return panel;
}

/// A fit's residuals over their root mean square, against the contact radius.
Panel residual_panel(const BranchLook& branch, const char* title, const Units& units) {
    Panel panel{.title = title,
                .shows = branch.name,
                .x = axis("contact radius *a*", units.radius),
                .y = {.quantity = "residual / rms", .unit = "1"}};
    const Array1D radius =
        branch.branch->energy_release_rate.contact_radius / units.radius.factor;  // of the fitted samples
    int colour = 0;
    const auto add = [&](const loops::Outcome<JkrFit>& fit, const char* name) {
        const int own = colour++;
        if (!fit || fit->residuals.size() != radius.size()) return;
        const Array1D residual = fit->residuals / fit->rms_residual;
        const auto shown = thinned(radius, residual, 0, radius.size() - 1, points_per_loop);
        panel.series.push_back({.label = name,
                                .x = taken(radius, shown),
                                .y = taken(residual, shown),
                                .mark = Mark::line,
                                .colour = own,
                                .dash = 0,
                                .line_width = 0.8});
    };
    for (const auto& route : loops::fit_routes) add((*branch.branch).*route.fit, route.title);
    panel.horizontal_lines = {0.0};
    return panel;
}

std::string works_of(const LoopAnalysis& analysis) {
    std::string text;
    for (const auto& branch : branches_of(analysis)) {
        const auto& fit = branch.branch->primary();
        text += fmt::format("{}{}: E* {}, W {}, correlation {:.3f}", text.empty() ? "" : "; ", branch.name,
                            with_error(fit.contact_modulus, 1e-6, "MPa"),
                            with_error(fit.work_of_adhesion, 1e3, "mJ/m2"), fit.correlation);
    }
    return text;
}

std::string closed_loop(const loops::LoopEnergy& loop) {
    const auto unit = display_unit(loop.energy, "J");
    return fmt::format(" Shaded: the closed loop, {}.", with_error(loop.estimate(), 1.0 / unit.factor, unit.name));
}

/// One legend for all panels, in the first panel.
void explain(std::vector<Panel>& panels) {
    auto& first = panels.front();
    for (std::size_t p = 1; p < panels.size(); ++p)
        for (const auto& series : panels[p].series) {
            if (!series.in_legend || std::any_of(first.series.begin(), first.series.end(),
                                                 [&](const auto& other) { return other.label == series.label; }))
                continue;
            first.series.push_back({.label = series.label,
                                    .mark = series.mark,
                                    .colour = series.colour,
                                    .symbol = series.symbol,
                                    .hollow = series.hollow,
                                    .dash = series.dash,
                                    .legend_only = true});
        }
}

/// Fills figure and caption.
void draw_loop(const DrawnLoop& loop, const Units& units, FigureWidth width, StudyFigure& drawn) {
    if (loop.analysis.corrected.displacement.size() > 0) drawn.figure.panels.push_back(force_panel(loop, units));
    drawn.figure.panels.push_back(radius_panel(loop, units));
    drawn.figure.panels.push_back(release_rate_panel(loop, units));
    explain(drawn.figure.panels);
    line_up(drawn.figure, width, drawn.figure.panels.size() == 3 ? 62.0 : 75.0);
    drawn.caption = fmt::format(
        "{}. {}The contact radius is {}. Dashed: JKR.{} ± is one standard error.", loop.name,
        loop.analysis.corrected.displacement.size() > 0 ? "Force against displacement from the fitted first contact. "
                                                        : "",
        loop.analysis.context.radius_measured ? "measured" : "calculated from force, displacement and E*",
        " " + works_of(loop.analysis) + ".");
    if (loop.analysis.loop) drawn.caption += closed_loop(*loop.analysis.loop);
}

}  // namespace

void loop_of(const study::ExperimentResult& experiment, FigureWidth width, StudyFigure& drawn) {
    const DrawnLoop loop{.name = std::filesystem::path(experiment.input.file).stem().string(),
                         .analysis = *experiment.analysis,
                         .bodies = experiment.bodies,
                         .options = experiment.input.options};
    draw_loop(loop, units_of(loop), width, drawn);
}

void ranges_of_loops(const FigureRequest& request, StudyFigure& drawn) {
    constexpr std::size_t most = 7;  // colours that can be distinguished
    const auto& experiments = request.result.experiments;
    if (static_cast<std::size_t>(std::count_if(experiments.begin(), experiments.end(),
                                               [](const auto& e) { return e.analysis.has_value(); })) > most) {
        drawn.reason =
            fmt::format("the study has more than {} loops; `setae jkr fit --figures` draws selected ones", most);
        return;
    }
    std::vector<NamedScan> scans;
    for (const auto& e : experiments) {
        if (!e.analysis) continue;
        try {
            scans.push_back({std::filesystem::path(e.input.file).stem().string(),
                             loops::scan_ranges(*e.analysis, e.bodies, e.input.options)});
        } catch (const UndefinedDataError&) {
            // its loading has too few samples for a fit of its parts
        }
    }
    auto ranges = range_figure(scans, {}, request.options.width);
    drawn.figure = std::move(ranges.figure);
    drawn.caption = std::move(ranges.caption);
    drawn.reason = std::move(ranges.reason);
}

std::vector<StudyFigure> loop_figures(const DrawnLoop& loop, const std::string& command, FigureWidth width) {
    const auto units = units_of(loop);
    StudyFigure drawn{.identifier = "loop",
                      .name = loop.name + "_loop",
                      .title = fmt::format("{}: force, contact radius and energy release rate", loop.name),
                      .command = command};
    draw_loop(loop, units, width, drawn);

    StudyFigure residuals{.identifier = "residuals",
                          .name = loop.name + "_residuals",
                          .title = fmt::format("{}: residuals of every fit", loop.name),
                          .command = command};
    const char* titles[] = {"A", "B"};
    std::size_t k = 0;
    for (const auto& branch : branches_of(loop.analysis))
        residuals.figure.panels.push_back(residual_panel(branch, titles[k++], units));
    line_up(residuals.figure, width, 65.0);
    residuals.caption = fmt::format(
        "{}: residuals of each fit over their root mean square. Residuals that vary smoothly show a deviation of the model, not noise.",
        loop.name);
    return {drawn, residuals};
}

}  // namespace setae::study_figures
