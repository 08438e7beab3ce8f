// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include "drawing.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/figures/typesetting.hpp"

namespace setae::study_figures {
namespace {

using figures::Mark;
using figures::Panel;
using figures::Series;
using loops::LoopAnalysis;
using study::ExperimentResult;
using study::StudyResult;

constexpr double mN = 1e3, um = 1e6, nJ = 1e9;  ///< per SI unit
constexpr Index few_symbols_per_branch = 24, few_points_per_loop = 400, few_points_per_fit = 120;
constexpr std::size_t max_loops = 60;

using Loops = std::vector<const ExperimentResult*>;
using Wanted = std::function<bool(const ExperimentResult&)>;

/// As many as a panel shows.
Loops loops_that(const StudyResult& result, const Wanted& wanted) {
    Loops found;
    for (const auto& e : result.experiments) {
        if (found.size() == max_loops) break;
        if (e.analysis && wanted(e)) found.push_back(&e);
    }
    return found;
}

/// A sentence for the caption where loops on some elastomer are too many for a panel.
std::string left_out_loops(const StudyResult& result) {
    std::map<std::string_view, std::size_t> loops;
    for (const auto& e : result.experiments)
        if (e.analysis) ++loops[e.input.elastomer];
    const bool cut = std::ranges::any_of(loops, [](const auto& entry) { return entry.second > max_loops; });
    return cut ? fmt::format(" The figure shows the first {} loops on each elastomer.", max_loops) : "";
}

bool has_radius(const ExperimentResult& e) { return e.analysis->corrected.contact_radius.size() > 0; }
bool has_displacement(const ExperimentResult& e) { return e.analysis->corrected.displacement.size() > 0; }

/// Radius of the sphere [m]; 0 where the study does not state it.
double sphere_radius(const StudyResult& result, const ExperimentResult& e) {
    if (e.input.sphere_radius) return e.input.sphere_radius->value;
    const auto* elastomer = result.study.elastomer(e.input.elastomer);
    return elastomer && elastomer->sphere_radius ? elastomer->sphere_radius->value : 0.0;
}

/// A series' look: which surface or stage, and its name.
struct Look {
    std::string label;
    int colour = 0;
};

/// One branch as symbols: contact radius [µm] against force [mN].
Series branch(const LoopAnalysis& loop, const loops::IndexRange& range, const Look& look, bool loading) {
    const auto& record = loop.corrected;
    // frames are fewer than samples of force
    std::vector<Index> frames, samples;
    for (Index i = range.first; i <= range.last; ++i)
        if (std::isfinite(record.contact_radius[i])) frames.push_back(i);
    const Array1D force = taken(record.force, frames), radius = taken(record.contact_radius, frames);
    for (const Index i : thinned(force, radius, 0, force.size() - 1, few_symbols_per_branch))
        samples.push_back(frames[static_cast<std::size_t>(i)]);
    return {.label = look.label + (loading ? ", loading" : ", unloading"),
            .x = taken(record.force, samples) * mN,
            .y = taken(record.contact_radius, samples) * um,
            .mark = Mark::points,
            .colour = look.colour,
            .hollow = loading,
            .in_legend = false};
}

/// a(F) of a JKR contact from its pull-off to `most` [N], as drawn; empty where W is not positive.
DrawnCurve jkr_curve(double radius, double modulus, double work, double most) {
    if (!(radius > 0.0 && modulus > 0.0 && work > 0.0 && std::isfinite(modulus) && std::isfinite(work))) return {};
    const contact::jkr::Contact contact{radius, modulus, work};
    const double least = contact::jkr::pull_off_at_fixed_load(contact).force;
    if (!(most > least)) return {};
    // even steps of the square root, because a(F) is vertical at pull-off
    const Array1D root = Array1D::LinSpaced(few_points_per_fit, 0.0, std::sqrt(most - least));
    const Array1D force = (least + root.square()).max(least);
    return {force * mN, contact::jkr::contact_radius_at_force(force, contact) * um};
}

void add_fit(Panel& panel, const StudyResult& result, const ExperimentResult& e, const loops::JkrFit& fit,
             const Look& look, const std::string& which, int dash) {
    const auto curve = jkr_curve(sphere_radius(result, e), fit.contact_modulus.value, fit.work_of_adhesion.value,
                                 e.analysis->corrected.force.maxCoeff());
    if (curve.x.size() == 0) return;
    panel.series.push_back({.label = look.label + ", JKR " + which,
                            .x = curve.x,
                            .y = curve.y,
                            .mark = Mark::line,
                            .colour = look.colour,
                            .dash = dash,
                            .line_width = 1.0,
                            .in_legend = false});
}

/// Eq. S2 through the last points before pull-off, drawn somewhat beyond them.
void add_retraction(Panel& panel, const StudyResult& result, const ExperimentResult& e, const Look& look) {
    const auto& loop = *e.analysis;
    if (!loop.retraction) return;
    const auto& force = loop.corrected.force;
    const double least = force[loop.retraction->last], first = force[loop.retraction->first];
    const double beyond = std::max(first + 0.5 * std::abs(first - least), 0.5 * least);
    const auto curve = jkr_curve(sphere_radius(result, e), loop.retraction->contact_modulus.value,
                                 loop.retraction->work_of_adhesion.value, beyond);
    if (curve.x.size() == 0) return;
    panel.series.push_back({.label = look.label + ", (S2)",
                            .x = curve.x,
                            .y = curve.y,
                            .mark = Mark::line,
                            .colour = look.colour,
                            .dash = 0,
                            .line_width = 1.6,
                            .in_legend = false});
}

void add_branches(Panel& panel, const ExperimentResult& e, const Look& look) {
    const auto& contact = e.analysis->segments.contacts.front();
    if (contact.unloading) panel.series.push_back(branch(*e.analysis, *contact.unloading, look, false));
    panel.series.push_back(branch(*e.analysis, contact.loading, look, true));
}

Panel radius_panel(const std::string& title, const std::string& shows = {}) {
    return {.title = title,
            .shows = shows,
            .x = {.quantity = "force *F*", .unit = "mN"},
            .y = {.quantity = "contact radius *a*", .unit = "um"}};
}

void explain(Panel& panel, const std::vector<Look>& looks, bool unloading_fit, bool retraction) {
    for (const auto& look : looks)
        panel.series.push_back({.label = look.label, .mark = Mark::points, .colour = look.colour, .legend_only = true});
    panel.series.push_back({.label = "loading",
                            .mark = Mark::points,
                            .colour = colour::black,
                            .symbol = 0,
                            .hollow = true,
                            .legend_only = true});
    panel.series.push_back(
        {.label = "unloading", .mark = Mark::points, .colour = colour::black, .symbol = 0, .legend_only = true});
    panel.series.push_back({.label = unloading_fit ? "JKR, loading" : "JKR",
                            .mark = Mark::line,
                            .colour = colour::black,
                            .dash = 1,
                            .legend_only = true});
    if (unloading_fit)
        panel.series.push_back(
            {.label = "JKR, unloading", .mark = Mark::line, .colour = colour::black, .dash = 0, .legend_only = true});
    if (retraction)
        panel.series.push_back({.label = "(S2)",
                                .mark = Mark::line,
                                .colour = colour::black,
                                .dash = 0,
                                .line_width = 1.6,
                                .legend_only = true});
}

std::vector<Look> looks_of(const StudyResult& result, const Loops& loops) {
    std::vector<Look> looks;
    for (std::size_t i = 0; i < result.surfaces.size(); ++i)
        if (std::any_of(loops.begin(), loops.end(),
                        [&](const ExperimentResult* e) { return e->input.surface == result.surfaces[i].name; }))
            looks.push_back({result.surfaces[i].name, colour_of_place(i)});
    return looks;
}

Look look_of(const StudyResult& result, const ExperimentResult& e) {
    return {e.input.surface, colour_of_place(place_of_surface(result, e.input.surface))};
}

/// The elastomer whose Young's modulus is nearest to the paper's 1.9 MPa by ratio, of those with loops.
const study::ElastomerResult* elastomer_of_figure_2(const StudyResult& result, const Wanted& wanted) {
    constexpr double modulus_of_paper = 1.9e6;
    const study::ElastomerResult* nearest = nullptr;
    double distance = HUGE_VAL;
    for (const auto& elastomer : result.elastomers) {
        if (loops_that(result, [&](const ExperimentResult& e) {
                return e.input.elastomer == elastomer.input.name && wanted(e);
            }).empty())
            continue;
        const double modulus = elastomer.youngs_modulus.value;
        const double here = modulus > 0.0 ? std::abs(std::log(modulus / modulus_of_paper)) : 1e9;
        if (here < distance) {
            distance = here;
            nearest = &elastomer;
        }
    }
    return nearest;
}

/// δ at first contact [m]: as fitted, else at the jump into contact of the record.
double zero_of_displacement(const LoopAnalysis& loop) {
    for (const auto* fit : {&loop.loading.force_displacement, &loop.loading.radius_force})
        if (*fit && std::isfinite((*fit)->contact_point.value)) return (*fit)->contact_point.value;
    if (loop.loading.pointwise) return loop.loading.pointwise->contact_point.value;
    const auto& contact = loop.segments.contacts.front();
    return loop.corrected.displacement[contact.jump_in ? contact.jump_in->first : contact.loading.first];
}

/// Force [mN] against displacement [µm] of the first contact.
DrawnCurve closed_loop(const LoopAnalysis& loop) {
    const auto& record = loop.corrected;
    const auto& extent = loop.segments.contacts.front().extent;
    const auto samples =
        thinned(record.displacement, record.force, extent.first, extent.last, few_points_per_loop - 100);
    return {(taken(record.displacement, samples) - zero_of_displacement(loop)) * um, taken(record.force, samples) * mN};
}

std::string why_no_loops(const StudyResult& result, bool reference) {
    const auto kind = reference ? "on a smooth reference" : "on a rough surface";
    const auto all = std::count_if(result.experiments.begin(), result.experiments.end(),
                                   [&](const ExperimentResult& e) { return e.input.reference == reference; });
    if (all == 0) return fmt::format("the study has no loop {}", kind);
    const auto analysed = loops_that(result, [&](const ExperimentResult& e) { return e.input.reference == reference; });
    if (analysed.empty()) return fmt::format("every loop {} failed", kind);
    return fmt::format("no loop {} has a contact radius", kind);
}

/// "soft, 0.7 MPa", as panels are titled.
std::string title_of(const study::ElastomerResult& elastomer) {
    const double modulus = elastomer.youngs_modulus.value;
    return elastomer.input.name +
           (modulus > 0.0 ? fmt::format(", {} MPa", figures::number_text(MPa * modulus, 2)) : "");
}

std::string modulus_of(const study::ElastomerResult& elastomer) {
    return elastomer.youngs_modulus.value > 0.0
               ? fmt::format("{}, E = {}", elastomer.input.name, with_error(elastomer.youngs_modulus, 1e-6, "MPa"))
               : elastomer.input.name;
}

/// Panels of one elastomer each, filled by `fill`.
figures::Figure panels_of_elastomers(const FigureRequest& request, const Wanted& wanted,
                                     const std::function<void(Panel&, const Loops&)>& fill) {
    figures::Figure figure;
    for (const auto& elastomer : request.result.elastomers) {
        const auto loops = loops_that(request.result, [&](const ExperimentResult& e) {
            return wanted(e) && e.input.elastomer == elastomer.input.name;
        });
        if (loops.empty()) continue;
        auto panel = radius_panel(title_of(elastomer));
        fill(panel, loops);
        figure.panels.push_back(panel);
    }
    arrange(figure, request.options.width, 62.0);
    return figure;
}

}  // namespace

void contact_of_one_elastomer(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    const auto rough = [](const ExperimentResult& e) { return !e.input.reference; };
    const auto* elastomer =
        elastomer_of_figure_2(result, [&](const ExperimentResult& e) { return rough(e) && has_radius(e); });
    if (!elastomer) {
        drawn.reason = why_no_loops(result, false);
        return;
    }
    const auto loops = loops_that(
        result, [&](const ExperimentResult& e) { return rough(e) && e.input.elastomer == elastomer->input.name; });
    Loops with_radius, with_displacement;
    for (const auto* e : loops) {
        if (has_radius(*e)) with_radius.push_back(e);
        if (has_displacement(*e)) with_displacement.push_back(e);
    }
    auto radius = radius_panel("A", "contact radius");
    for (const auto* e : with_radius)
        add_fit(radius, result, *e, e->analysis->loading.primary(), look_of(result, *e), "of loading", 1);
    for (const auto* e : with_radius) add_branches(radius, *e, look_of(result, *e));
    explain(radius, looks_of(result, with_radius), false, false);
    Panel force{.title = "B",
                .shows = "force and displacement",
                .x = {.quantity = "displacement *δ*", .unit = "um"},
                .y = {.quantity = "force *F*", .unit = "mN"},
                .horizontal_lines = {0.0}};
    // the loop with the largest loss shows the meaning of the area best
    const ExperimentResult* shaded = nullptr;
    for (const auto* e : with_displacement)
        if (e->analysis->loop && (!shaded || e->analysis->loop->energy > shaded->analysis->loop->energy)) shaded = e;
    double depth = 0.0, lift = 0.0;
    for (const auto* e : with_displacement) {
        const auto curve = closed_loop(*e->analysis);
        const auto look = look_of(result, *e);
        if (e == shaded)
            force.series.push_back({.label = look.label + ", lost energy",
                                    .x = curve.x,
                                    .y = curve.y,
                                    .mark = Mark::area,
                                    .colour = look.colour,
                                    .in_legend = false});
        force.series.push_back({.label = look.label,
                                .x = curve.x,
                                .y = curve.y,
                                .mark = Mark::line,
                                .colour = look.colour,
                                .dash = 0,
                                .line_width = 1.0,
                                .in_legend = false});
        depth = std::max(depth, curve.x.maxCoeff());
        // free flight is of no interest beyond the jumps
        for (Index i = 0; i < curve.x.size(); ++i)
            if (std::abs(curve.y[i]) > 0.02 * curve.y.maxCoeff()) lift = std::min(lift, curve.x[i]);
    }
    if (depth > 0.0) {
        force.x.from = lift - 0.12 * (depth - lift);
        force.x.to = depth + 0.05 * (depth - lift);
    }
    drawn.figure.panels = {radius};
    if (!with_displacement.empty()) drawn.figure.panels.push_back(force);
    arrange(drawn.figure, request.options.width, 75.0);
    drawn.caption = fmt::format(
        "Contact on {} ({}). A: contact radius against force. Hollow symbols: loading; filled symbols: unloading; dashed: JKR (Eq. 1) fitted to loading.{}{} Each branch is thinned to about {} "
        "symbols and each loop to at most {} points; jumps are kept.{} Compare Fig. 2 of Dalvi et al. 2019.",
        modulus_of(*elastomer), counted(with_radius.size(), "loop"),
        with_displacement.empty() ? "" : " B: force against displacement from first contact.",
        shaded
            ? fmt::format(
                  " Shaded: the closed loop on {}, which loses {}; ± is one standard error (noise, drift, sampling).",
                  shaded->input.surface, with_error(shaded->analysis->loop->estimate(), nJ, "nJ"))
            : "",
        few_symbols_per_branch, few_points_per_loop, left_out_loops(result));
}

void contact_radius_of_all(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    std::size_t n = 0, retractions = 0;
    drawn.figure = panels_of_elastomers(
        request, [](const ExperimentResult& e) { return !e.input.reference && has_radius(e); },
        [&](Panel& panel, const Loops& loops) {
            for (const auto* e : loops)
                add_fit(panel, result, *e, e->analysis->loading.primary(), look_of(result, *e), "of loading", 1);
            for (const auto* e : loops) add_branches(panel, *e, look_of(result, *e));
            for (const auto* e : loops) {
                add_retraction(panel, result, *e, look_of(result, *e));
                ++n;
                retractions += e->analysis->retraction ? 1 : 0;
            }
            explain(panel, looks_of(result, loops), false, true);
        });
    if (n == 0) {
        drawn.reason = why_no_loops(result, false);
        return;
    }
    drawn.caption = fmt::format(
        "Contact radius against force on each elastomer ({}). Hollow symbols: loading; filled symbols: unloading; dashed: JKR (Eq. 1) fitted to loading; solid: Eq. S2 "
        "through the last points before pull-off, with the modulus of loading ({}). All panels use the symbols and colours of the first panel.{} "
        "Compare Fig. S5 of Dalvi et al. 2019.",
        counted(n, "loop"), counted(retractions, "fit"), left_out_loops(result));
}

void contact_radius_of_references(const FigureRequest& request, StudyFigure& drawn) {
    const auto& result = request.result;
    std::size_t n = 0;
    std::string works;
    const auto look = [](const ExperimentResult& e) {
        return Look{e.input.stage.empty() ? "reference" : e.input.stage,
                    colour_of_place(e.input.stage == "after" ? 1 : 0)};
    };
    drawn.figure = panels_of_elastomers(
        request, [](const ExperimentResult& e) { return e.input.reference && has_radius(e); },
        [&](Panel& panel, const Loops& loops) {
            std::vector<Look> looks;
            for (const auto* e : loops) {
                const auto here = look(*e);
                add_fit(panel, result, *e, e->analysis->loading.primary(), here, "of loading", 1);
                if (e->analysis->unloading)
                    add_fit(panel, result, *e, e->analysis->unloading->primary(), here, "of unloading", 0);
                if (std::none_of(looks.begin(), looks.end(),
                                 [&](const Look& other) { return other.label == here.label; }))
                    looks.push_back(here);
                ++n;
            }
            for (const auto* e : loops) add_branches(panel, *e, look(*e));
            explain(panel, looks, true, false);
        });
    if (n == 0) {
        drawn.reason = why_no_loops(result, true);
        return;
    }
    for (const auto& reference : result.references)
        works +=
            fmt::format("{}{}{}: {} and {}", works.empty() ? "" : "; ", reference.elastomer,
                        reference.stage.empty() ? "" : " " + reference.stage,
                        with_error(reference.approach, 1e3, "mJ/m2"), with_error(reference.retraction, 1e3, "mJ/m2"));
    drawn.caption = fmt::format(
        "Contact radius against force on the smooth reference ({}). Hollow symbols: loading; filled symbols: unloading. JKR (Eq. 1) is fitted to loading (dashed) and to "
        "unloading (solid). W of loading and unloading: {}; ± is one standard error.{} Compare Fig. S6 of Dalvi et al. 2019.",
        counted(n, "loop"), works, left_out_loops(result));
}

}  // namespace setae::study_figures
