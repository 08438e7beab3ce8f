// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/experiment/analysis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "alerts.hpp"
#include "attempt.hpp"
#include "branch.hpp"
#include "drift.hpp"
#include "jump.hpp"
#include "pinned_stretch.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"

namespace setae::experiment {
namespace {

/// The loop with the machine's own deflection taken off the displacement.
Loop without_compliance(const Loop& loop, const std::optional<double>& machine_stiffness) {
    if (!machine_stiffness) return loop;
    if (!(*machine_stiffness > 0.0))
        throw InvalidArgument(fmt::format("machine stiffness must be > 0 N/m, got {}", *machine_stiffness));
    Loop corrected = loop;
    if (loop.displacement.size() == loop.force.size()) corrected.displacement -= loop.force / *machine_stiffness;
    return corrected;
}

BranchAnalysis analyse_loading(const Loop& loop, const Segments& segments, const ContactSegments& contact,
                               const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    BranchAnalysis branch = analyse_branch(
        loop, segments.before, loading_selection(loop, segments, contact, options.samples_dropped), bodies, options);
    for (const Index dropped : options.sensitivity_dropped)
        branch.sensitivity.push_back({.dropped = dropped, .fit = attempt([&] {
                                          const Selection selection = loading_selection(loop, segments, contact, dropped);
                                          return primary_fit(branch_data(loop, segments.before, selection, options), bodies,
                                                             options);
                                      })});
    return branch;
}

Outcome<BranchAnalysis> analyse_unloading(const Loop& loop, const Segments& segments, const ContactSegments& contact,
                                          const std::optional<IndexRange>& pinned, const LensAndCounterBody& bodies,
                                          const AnalysisOptions& options) {
    if (!contact.unloading) return Outcome<BranchAnalysis>::missing("the record has no retraction");
    IndexRange range = *contact.unloading;
    if (pinned) range.first = pinned->last + 1;
    const std::string name = fmt::format("unloading, from {} to the {}", pinned ? "where the contact edge lets go" : "the last press",
                                         contact.pull_off ? "pull-off minimum" : "last sample in contact");
    return attempt([&] { return analyse_branch(loop, segments.before, range_selection(range, name), bodies, options); });
}

/// −ΔF/Δδ of the largest step of the jump.
double stiffness_of_jump(const Loop& loop, const IndexRange& jump) {
    if (loop.displacement.size() == 0) return undefined;
    const Index at = largest_step(loop.force, jump);
    const double step = loop.displacement[at + 1] - loop.displacement[at];
    return step < 0.0 ? (loop.force[at + 1] - loop.force[at]) / -step : INFINITY;
}

Outcome<PullOff> find_pull_off(const Loop& loop, const Segments& segments, const ContactSegments& contact, double radius) {
    if (!contact.pull_off)
        return Outcome<PullOff>::missing(contact.unloading ? "the force has no minimum below the baseline before contact ends"
                                                           : "the record has no retraction");
    const Baseline& baseline = segments.before;
    PullOff result{.index = contact.pull_off->first};
    result.force = {loop.force[result.index] - baseline.force,
                    std::hypot(baseline.force_noise, baseline.force_standard_error), "baseline noise"};
    const auto work = [&](contact::jkr::Control control) -> Estimate {
        return {contact::jkr::work_of_adhesion_from_pull_off(result.force.value, radius, control),
                contact::jkr::work_of_adhesion_from_pull_off(result.force.standard_error, radius, control), "baseline noise"};
    };
    result.work_of_adhesion = work(contact::jkr::Control::fixed_load);
    result.work_of_adhesion_fixed_grips = work(contact::jkr::Control::fixed_grips);
    result.machine_stiffness = stiffness_of_jump(loop, *contact.pull_off);
    return result;
}

/// The last samples before pull-off in which the contact is seen: between camera frames there is no radius.
Selection last_points(const Loop& loop, const IndexRange& unloading, Index count) {
    Selection selection{.name = "last points before pull-off"};
    const bool measured = loop.contact_radius.size() > 0;
    for (Index i = unloading.last; i >= unloading.first && static_cast<Index>(selection.samples.size()) < count; --i)
        if (!measured || loop.contact_radius[i] > 0.0) selection.samples.push_back(i);
    std::reverse(selection.samples.begin(), selection.samples.end());
    return selection;
}

Outcome<RetractionFit> analyse_retraction(const Loop& loop, const LoopAnalysis& analysis, const LensAndCounterBody& bodies,
                                          const AnalysisOptions& options) {
    const ContactSegments& contact = analysis.segments.contacts.front();
    if (!contact.pull_off) return Outcome<RetractionFit>::missing(analysis.pull_off.reason);
    return attempt([&] {
        const Selection selection = last_points(loop, *contact.unloading, options.retraction_points);
        const BranchData points = branch_data(loop, analysis.segments.before, selection, options);
        // creep and drift during the loop move the contact point: the unloading branch knows its own best
        const bool known = analysis.unloading && analysis.unloading->force_displacement;
        const double contact_point = known ? analysis.unloading->force_displacement->contact_point.value : undefined;
        RetractionFit fit = fit_retraction(points, bodies.radius, analysis.loading.primary().contact_modulus, contact_point,
                                           options.retraction_modulus_free);
        fit.first = selection.samples.front();
        fit.last = selection.samples.back();
        return fit;
    });
}

/// Contact radius at the largest force: that of the loading fit, moved by the mean of what the last frames before it
/// differ from the fit. The largest of noisy frames would be too large.
double radius_at_largest_force(const Loop& loop, const LoopAnalysis& analysis, const contact::jkr::Contact& lens) {
    constexpr Index frames = 5;
    const IndexRange& loading = analysis.segments.contacts.front().loading;
    const double zero = analysis.segments.before.force;
    const double fitted = contact::jkr::contact_radius_at_force(loop.force[loading.last] - zero, lens);
    if (loop.contact_radius.size() == 0) return fitted;
    double difference = 0.0;
    Index n = 0;
    for (Index i = loading.last; i >= loading.first && n < frames; --i) {
        if (!(loop.contact_radius[i] > 0.0)) continue;
        difference += loop.contact_radius[i] - contact::jkr::contact_radius_at_force(loop.force[i] - zero, lens);
        ++n;
    }
    return n > 0 && std::isfinite(difference) ? fitted + difference / static_cast<double>(n) : fitted;
}

LoopContext find_context(const Loop& loop, const LoopAnalysis& analysis, const LensAndCounterBody& bodies,
                         const AnalysisOptions& options) {
    const JkrFit& fit = analysis.loading.primary();
    const contact::jkr::Contact lens{.radius = bodies.radius,
                                     .contact_modulus = fit.contact_modulus.value,
                                     .work_of_adhesion = std::max(fit.work_of_adhesion.value, 0.0)};
    LoopContext context{.radius_measured = loop.contact_radius.size() > 0};
    context.largest_contact_radius = radius_at_largest_force(loop, analysis, lens);
    context.largest_contact_area = pi * context.largest_contact_radius * context.largest_contact_radius;
    context.ideal_smooth_sphere_loss = contact::jkr::ideal_loop_loss(lens).total;
    context.tabor_parameter = contact::jkr::tabor_parameter(lens, options.interaction_range);
    return context;
}

Outcome<double> cycle_energy(const Loop& loop, const LoopAnalysis& analysis, Index index) {
    const Cycle& cycle = analysis.segments.cycles[static_cast<std::size_t>(index)];
    const ContactSegments& contact = analysis.segments.contacts[static_cast<std::size_t>(cycle.contact)];
    if (loop.displacement.size() == 0) return Outcome<double>::missing("the displacement was not measured");
    if (contact.cycles.size() == 1)
        return attempt([&] { return loop_energy(loop, analysis.segments, cycle.contact).energy; });
    if (const auto energy = partial_loop_energy(loop, analysis.segments, index)) return {*energy};
    return Outcome<double>::missing("the release is not followed by a press that closes it");
}

/// A branch between reversals, refused where its modulus says that the contact edge did not move.
Outcome<BranchAnalysis> analyse_partial(const Loop& loop, const LoopAnalysis& analysis, const IndexRange& range,
                                        const std::string& name, const LensAndCounterBody& bodies,
                                        const AnalysisOptions& options) {
    Outcome<BranchAnalysis> branch = attempt(
        [&] { return analyse_branch(loop, analysis.segments.before, range_selection(range, name), bodies, options); });
    if (!branch) return branch;
    const double first = analysis.loading.primary().contact_modulus.value;
    const double ratio = branch->primary().contact_modulus.value / first;
    const double limit = options.limits.pinned_modulus_ratio;
    if (ratio < limit && ratio > 1.0 / limit) return branch;
    return Outcome<BranchAnalysis>::missing(
        fmt::format("{}: E* would be {:.2g} times that of first loading: the contact edge is pinned, this is no jkr branch",
                    name, ratio));
}

CycleAnalysis analyse_cycle(const Loop& loop, const LoopAnalysis& analysis, Index index, const LensAndCounterBody& bodies,
                            const AnalysisOptions& options) {
    CycleAnalysis result{.cycle = analysis.segments.cycles[static_cast<std::size_t>(index)]};
    const ContactSegments& contact = analysis.segments.contacts[static_cast<std::size_t>(result.cycle.contact)];
    if (analysis.segments.cycles.size() == 1) {
        result.loading = analysis.loading;
        result.unloading = analysis.unloading;
        return result;
    }
    const auto whole = [&](const IndexRange& range, const std::string& name) {
        return attempt([&] {
            return analyse_branch(loop, analysis.segments.before, range_selection(range, name), bodies, options);
        });
    };
    const auto partial = [&](const IndexRange& range, const std::string& name) {
        return analyse_partial(loop, analysis, range, name, bodies, options);
    };
    const std::string loading_name = fmt::format("loading of cycle {}", index + 1);
    const std::string unloading_name = fmt::format("unloading of cycle {}", index + 1);
    IndexRange loading = result.cycle.loading;
    if (contact.cycles.front() == index) {
        loading.first = std::min(loading.first + options.samples_dropped, loading.last);
        result.loading = whole(loading, loading_name);
    } else {
        result.loading = partial(loading, loading_name);
    }
    result.unloading = contact.cycles.back() == index ? whole(result.cycle.unloading, unloading_name)
                                                      : partial(result.cycle.unloading, unloading_name);
    return result;
}

}  // namespace

LoopAnalysis analyse(const Loop& recorded, const LensAndCounterBody& bodies, const AnalysisOptions& options,
                     const std::string& subject) {
    const Loop corrected = without_compliance(recorded, options.machine_stiffness);
    LoopAnalysis analysis;
    analysis.segments = find_segments(corrected, options.segments);
    const ContactSegments& contact = analysis.segments.contacts.front();
    const Loop loop = options.force_drift ? without_force_drift(corrected, analysis.segments) : corrected;
    analysis.loading = analyse_loading(loop, analysis.segments, contact, bodies, options);
    analysis.context = find_context(loop, analysis, bodies, options);
    if (options.leave_pinned_out) analysis.pinned = pinned_stretch(loop, analysis, bodies, options);
    analysis.unloading = analyse_unloading(loop, analysis.segments, contact, analysis.pinned, bodies, options);
    analysis.pull_off = find_pull_off(loop, analysis.segments, contact, bodies.radius);
    analysis.retraction = analyse_retraction(loop, analysis, bodies, options);
    analysis.loop = attempt([&] { return loop_energy(corrected, analysis.segments); });
    for (Index i = 0; i < static_cast<Index>(analysis.segments.cycles.size()); ++i) {
        analysis.cycles.push_back(analyse_cycle(loop, analysis, i, bodies, options));
        analysis.cycles.back().energy = cycle_energy(corrected, analysis, i);
    }
    analysis.corrected = loop;
    analysis.corrected.force -= analysis.segments.before.force;
    analysis.alerts = alerts_of(analysis, loop, bodies, options.limits, subject);
    return analysis;
}

}  // namespace setae::experiment
