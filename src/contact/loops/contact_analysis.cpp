// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_analysis.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "attempt.hpp"
#include "finite_height.hpp"
#include "fits/fit_support.hpp"
#include "hold_growth.hpp"
#include "pinned_stretch.hpp"
#include "records/baseline.hpp"
#include "records/jump.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/contact/tabor.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {
namespace {

bool is_ignored(const Segments& segments, Index sample) {
    return std::any_of(segments.ignored.begin(), segments.ignored.end(),
                       [&](const IndexRange& range) { return range.contains(sample); });
}

Selection loading_samples(const PreparedRecord& record, const ContactSegments& contact, Index dropped) {
    return without_ignored(loading_selection(record.level, record.segments, contact, dropped), record.segments);
}

BranchAnalysis analyse_loading(const PreparedRecord& record, const ContactSegments& contact,
                               const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    BranchAnalysis branch =
        analyse_branch(record.levelled(), loading_samples(record, contact, options.samples_dropped), bodies, options);
    for (const Index dropped : options.sensitivity_dropped)
        branch.sensitivity.push_back(
            {.dropped = dropped,
             .fit = attempt([&] {
                 const Selection selection = loading_samples(record, contact, dropped);
                 return primary_fit(as_half_space(branch_data(record.levelled(), selection, options), bodies, options),
                                    bodies, options);
             })});
    return branch;
}

Outcome<BranchAnalysis> analyse_unloading(const PreparedRecord& record, const ContactSegments& contact,
                                          const std::optional<IndexRange>& pinned, const BranchAnalysis& loading,
                                          const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    if (!contact.unloading) return Outcome<BranchAnalysis>::missing("the record has no retraction");
    IndexRange range = *contact.unloading;
    if (pinned) range.first = pinned->last + 1;
    const std::string name = fmt::format("unloading, from {} to the {}",
                                         pinned ? "the point where the contact edge starts to move" : "the last press",
                                         contact.pull_off ? "pull-off minimum" : "last sample in contact");
    return attempt([&] {
        return analyse_branch(record.levelled(), without_ignored(range_selection(range, name), record.segments), bodies,
                              options, loading.primary().contact_modulus);
    });
}

/// Motion of the motor from one sample to the next, from the free flight after the contacts, where nothing bends; 0
/// where the record ends before.
double motor_step(const Loop& loop, const Segments& segments, Index at) {
    if (!segments.after || !segments.after->range) return 0.0;
    const auto [first, last] = *segments.after->range;
    const double way = loop.displacement[last] - loop.displacement[first];
    if (loop.time.size() == 0) return way / static_cast<double>(last - first);
    return way * (loop.time[at + 1] - loop.time[at]) / (loop.time[last] - loop.time[first]);
}

/// k of |ΔF| = k (|Δδ| − vΔt) over the largest step of the jump.
double stiffness_of_jump(const Loop& loop, const Segments& segments, const ContactSegments& contact) {
    if (loop.displacement.size() == 0) return undefined;
    const Index at = largest_step(loop.force, *contact.pull_off);
    const double relaxed = loop.displacement[at] - loop.displacement[at + 1] + motor_step(loop, segments, at);
    const double noise = segments.before.displacement_noise;
    constexpr double deviations = 3.0;
    const double least = noise > 0.0 ? deviations * std::sqrt(2.0) * noise : 1e-9 * std::abs(loop.displacement[at]);
    return relaxed > least ? (loop.force[at + 1] - loop.force[at]) / relaxed : INFINITY;
}

Outcome<PullOff> find_pull_off(const PreparedRecord& record, const ContactSegments& contact, double radius,
                               double contact_modulus) {
    if (!contact.pull_off)
        return Outcome<PullOff>::missing(contact.unloading
                                             ? "the force has no minimum below the baseline before contact ends"
                                             : "the record has no retraction");
    const Loop& loop = record.level;
    const ForceMinimum smallest =
        smallest_force(loop.force, {contact.unloading->first, largest_step(loop.force, *contact.pull_off)},
                       sample_noise(record.segments.before));
    PullOff result{.index = smallest.sample};
    result.force = {smallest.force,
                    std::hypot(smallest.standard_error, record.zero.modes.row(result.index).matrix().norm()),
                    "baseline noise"};
    const auto work = [&](const Estimate& force, contact::jkr::Control control) -> Estimate {
        return {contact::jkr::work_of_adhesion_from_pull_off(force.value, radius, control),
                contact::jkr::work_of_adhesion_from_pull_off(force.standard_error, radius, control), "baseline noise"};
    };
    result.work_of_adhesion = work(result.force, contact::jkr::Control::fixed_load);
    result.last_force = {
        loop.force[largest_step(loop.force, *contact.pull_off)],
        std::hypot(record.segments.before.force_noise, record.zero.modes.row(result.index).matrix().norm()),
        "baseline noise"};
    result.machine_stiffness = stiffness_of_jump(loop, record.segments, contact);
    constexpr double stiff = 10.0;
    const double contact_stiffness =
        2.0 * contact_modulus *
        contact::jkr::pull_off_at_fixed_grips({radius, contact_modulus, result.work_of_adhesion.value}).contact_radius;
    if (!(result.machine_stiffness >= stiff * contact_stiffness))
        result.work_of_adhesion_fixed_grips = Outcome<Estimate>::missing(fmt::format(
            "the testing machine ({}) is not {:.0f} times stiffer than the contact at pull-off ({})",
            format_value(result.machine_stiffness, "N/m", 3), stiff, format_value(contact_stiffness, "N/m", 3)));
    else if (!(result.last_force.value < 0.0))
        result.work_of_adhesion_fixed_grips =
            Outcome<Estimate>::missing("the record has no sample with a tension just before the jump");
    else result.work_of_adhesion_fixed_grips = {work(result.last_force, contact::jkr::Control::fixed_grips)};
    return result;
}

/// Standard deviation of the mean of n neighbouring samples of an autoregressive noise, ρ_k = φ^k; 0 for independent
/// noise, which the scatter of the samples shows.
double shared_noise(const Baseline& baseline, Index n) {
    const double phi = baseline.force_noise_correlation, count = static_cast<double>(n);
    if (!(phi > 0.0)) return 0.0;
    double sum = 1.0;
    for (Index k = 1; k < n; ++k) sum += 2.0 * (1.0 - static_cast<double>(k) / count) * std::pow(phi, k);
    return baseline.force_noise * std::sqrt(sum / count);
}

/// The last samples before pull-off with a visible contact: between camera frames there is no radius.
Selection last_points(const Loop& loop, const Segments& segments, const IndexRange& unloading, Index count) {
    Selection selection{.name = "last points before pull-off"};
    const bool measured = loop.contact_radius.size() > 0;
    for (Index i = unloading.last; i >= unloading.first && static_cast<Index>(selection.samples.size()) < count; --i)
        if ((!measured || loop.contact_radius[i] > 0.0) && !is_ignored(segments, i)) selection.samples.push_back(i);
    std::reverse(selection.samples.begin(), selection.samples.end());
    return selection;
}

/// @throws UndefinedDataError where noise of the displacement hides the contact radius that force and displacement
/// imply: F = 2aE* (δ − δ0 − a²/(3R)), so that da/a = −dδ/(δ − δ0 − a²/R). Its square biases W.
void require_resolved_radii(const BranchData& points, const ContactAnalysis& analysis, double contact_point,
                            double radius) {
    constexpr double most = 0.03;
    if (points.contact_radius.size() > 0 || !(points.displacement_noise > 0.0)) return;
    const double modulus = analysis.loading.primary().contact_modulus.value;
    double largest = 0.0;
    for (Index i = 0; i < points.force.size(); ++i) {
        const double depth = points.displacement[i] - contact_point;
        const double a = contact::jkr::contact_radius_at(points.force[i], depth, {radius, modulus});
        largest = std::max(largest, points.displacement_noise / std::abs(depth - a * a / radius));
    }
    if (largest > most)
        throw UndefinedDataError(
            fmt::format("noise of the displacement changes the contact radii computed from force and displacement by "
                        "{:.0f} %",
                        100.0 * largest));
}

/// Eq. S2 uses E* of loading. @throws UndefinedDataError where loading does not determine it.
void require_known_modulus(const JkrFit& loading) {
    constexpr double most = 0.3;
    const Estimate& modulus = loading.contact_modulus;
    if (!loading.converged)
        throw UndefinedDataError("E* is taken from loading, and the fit of loading did not converge");
    if (modulus.standard_error > most * modulus.value)
        throw UndefinedDataError(fmt::format("E* of loading has a standard error of {:.0f} %",
                                             100.0 * modulus.standard_error / modulus.value));
}

Outcome<RetractionFit> analyse_retraction(const PreparedRecord& record, const ContactSegments& contact,
                                          const ContactAnalysis& analysis, const LensAndCounterBody& bodies,
                                          const AnalysisOptions& options) {
    if (!contact.pull_off) return Outcome<RetractionFit>::missing(analysis.pull_off.reason);
    return attempt([&] {
        if (!options.retraction_modulus_free) require_known_modulus(analysis.loading.primary());
        const Selection selection =
            last_points(record.level, record.segments, *contact.unloading, options.retraction_points);
        BranchData points = branch_data(record.levelled(), selection, options);
        if (const auto height = bodies.soft_height(); height && analysis.unloading) {
            const JkrFit& fit = analysis.unloading->primary();
            points =
                as_half_space(points, contact::layer::Layer(*height, bodies.lens_poisson_ratio),
                              {bodies.radius, fit.contact_modulus.value, std::max(fit.work_of_adhesion.value, 0.0)});
        }
        // creep and drift during the loop move the contact point: that of the unloading branch is best for unloading
        const bool known = analysis.unloading && analysis.unloading->force_displacement &&
                           analysis.unloading->force_displacement->converged;
        const double contact_point = known ? analysis.unloading->force_displacement->contact_point.value : undefined;
        if (points.contact_radius.size() == 0 && !known)
            throw UndefinedDataError(
                "the contact point of the retraction is not known: the fit of force against displacement did "
                "not converge");
        require_resolved_radii(points, analysis, contact_point, bodies.radius);
        const auto fitted = [&](const BranchData& samples) {
            return fit_retraction(samples, bodies.radius, analysis.loading.primary().contact_modulus, contact_point,
                                  options.retraction_modulus_free);
        };
        RetractionFit fit = fitted(points);
        const double work = fit.work_of_adhesion.value;
        const auto add_error_of = [&](const Array1D& shift) {
            const BranchData moved = points.with_higher_force(shift);
            fit.work_of_adhesion.standard_error =
                std::hypot(fit.work_of_adhesion.standard_error, fitted(moved).work_of_adhesion.value - work);
        };
        for (Index mode = 0; mode < points.force_zero_modes.cols(); ++mode)
            add_error_of(points.force_zero_modes.col(mode));
        if (const double shared = shared_noise(record.segments.before, points.force.size()); shared > 0.0)
            add_error_of(Array1D::Constant(points.force.size(), shared));
        fit.first = selection.samples.front();
        fit.last = selection.samples.back();
        return fit;
    });
}

/// k [N/m] as given, else of the jump out; infinite where neither is known.
double stiffness_of_machine(const ContactAnalysis& analysis, const AnalysisOptions& options) {
    if (options.machine_stiffness) return *options.machine_stiffness;
    if (analysis.pull_off && analysis.pull_off->machine_stiffness > 0.0) return analysis.pull_off->machine_stiffness;
    return INFINITY;
}

/// W_ret from the first motion of the edge to the pull-off.
Outcome<WorkAlongRetraction> analyse_work_along(const PreparedRecord& record, const ContactAnalysis& analysis,
                                                double machine_stiffness, const LensAndCounterBody& bodies,
                                                const AnalysisOptions& options) {
    using Course = Outcome<WorkAlongRetraction>;
    if (!analysis.unloading) return Course::missing(analysis.unloading.reason);
    if (record.level.contact_radius.size() == 0)
        return Course::missing(
            "undetermined: the contact radius was not measured, so that only W_ret at pull-off is known");
    return attempt([&] {
        const JkrFit& loading = analysis.loading.primary();
        require_known_modulus(loading);
        const FitRange& range = analysis.unloading->range;
        const Selection selection =
            without_ignored(range_selection({range.first, range.last}, range.name), record.segments);
        return fit_work_along_retraction(
            as_half_space(branch_data(record.levelled(), selection, options), bodies, options),
            {.radius = bodies.radius,
             .contact_modulus = loading.contact_modulus,
             .work_approach = loading.work_of_adhesion,
             .largest_contact_radius = analysis.context.largest_contact_radius,
             .machine_stiffness = machine_stiffness});
    });
}

/// Contact radius at the largest force: that of the loading fit, shifted by the mean difference of the last frames
/// before it from the fit, at the end of a hold, in which the contact may grow. The largest of noisy frames would be
/// too large.
double radius_at_largest_force(const Loop& loop, const ContactSegments& contact, const contact::jkr::Contact& lens) {
    constexpr Index frames = 5;
    const IndexRange& loading = contact.loading;
    const Index last = contact.hold ? contact.hold->last : loading.last;
    const double fitted = contact::jkr::contact_radius_at_force(loop.force[loading.last], lens);
    if (loop.contact_radius.size() == 0) return fitted;
    double difference = 0.0;
    Index n = 0;
    for (Index i = last; i >= loading.first && n < frames; --i) {
        if (!(loop.contact_radius[i] > 0.0)) continue;
        difference += loop.contact_radius[i] - contact::jkr::contact_radius_at_force(loop.force[i], lens);
        ++n;
    }
    return n > 0 && std::isfinite(difference) ? fitted + difference / static_cast<double>(n) : fitted;
}

/// μ ∝ (W/E*)^(2/3)/z0: W and E* are of one fit, z0 of none. Undefined error where the fit has none.
Estimate tabor_parameter_of(const JkrFit& fit, const contact::jkr::Contact& lens, const Estimate& range) {
    Estimate result{.value = contact::jkr::tabor_parameter(lens, range.value), .method = "delta"};
    const auto &modulus = fit.contact_modulus, &work = fit.work_of_adhesion;
    if (!(work.value > 0.0) || !modulus.uncertain() || !work.uncertain() || !std::isfinite(fit.correlation))
        return result;
    const double of_modulus = modulus.standard_error / modulus.value, of_work = work.standard_error / work.value;
    const double of_ratio = of_modulus * of_modulus + of_work * of_work - 2.0 * fit.correlation * of_modulus * of_work;
    result.standard_error =
        result.value * std::sqrt(4.0 / 9.0 * of_ratio + range.variance() / (range.value * range.value));
    return result;
}

LoopContext find_context(const Loop& loop, const ContactSegments& contact, const BranchAnalysis& loading,
                         const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    const JkrFit& fit = loading.primary();
    const contact::jkr::Contact lens{.radius = bodies.radius,
                                     .contact_modulus = fit.contact_modulus.value,
                                     .work_of_adhesion = std::max(fit.work_of_adhesion.value, 0.0)};
    LoopContext context{.radius_measured = loop.contact_radius.size() > 0};
    context.largest_contact_radius = radius_at_largest_force(loop, contact, lens);
    context.largest_contact_area = pi * context.largest_contact_radius * context.largest_contact_radius;
    context.ideal_smooth_sphere_loss = contact::jkr::ideal_loop_loss(lens).total;
    context.tabor_parameter = tabor_parameter_of(fit, lens, options.interaction_range);
    if (lens.work_of_adhesion > 0.0)
        context.applicable_model =
            contact::tabor::which_model(loop.force[contact.loading.last], lens, options.interaction_range.value)
                .sentence;
    return context;
}

ContactPointInputs inputs_of(const PreparedRecord& record, Index index, const ContactAnalysis& analysis,
                             const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    const ContactSegments& contact = record.segments.contacts[static_cast<std::size_t>(index)];
    ContactPointInputs inputs{
        .loop = record.level, .segments = record.segments, .force_zero = record.zero, .contact = index};
    inputs.loading = as_half_space(
        branch_data(record.levelled(), loading_samples(record, contact, options.samples_dropped), options), bodies,
        options);
    inputs.force_displacement = analysis.loading.force_displacement;
    inputs.pointwise = analysis.loading.pointwise;
    if (analysis.unloading) inputs.unloading = analysis.unloading->primary();
    inputs.machine_stiffness = options.machine_stiffness;
    return inputs;
}

using Mode = ContactPointChoice::Mode;

/// Both branches with a fixed contact point, whose error is included in theirs.
void hold_contact_point(ContactAnalysis& analysis, const PreparedRecord& record, const ContactSegments& contact,
                        const LensAndCounterBody& bodies, AnalysisOptions options, const Estimate& contact_point) {
    const auto analysed = [&](double value) {
        options.contact_point = {.mode = Mode::value, .value = value};
        ContactAnalysis held;
        held.loading = analyse_loading(record, contact, bodies, options);
        held.unloading = analyse_unloading(record, contact, analysis.pinned, held.loading, bodies, options);
        return held;
    };
    ContactAnalysis held = analysed(contact_point.value);
    const auto add_error = [&](Outcome<JkrFit>& fit, const Outcome<JkrFit>& shifted) {
        if (!fit) return;
        if (shifted) add_force_zero_error(*fit.value, *shifted, bodies);
        fit.value->contact_point = contact_point;
    };
    if (contact_point.uncertain()) {
        const ContactAnalysis shifted = analysed(contact_point.value + contact_point.standard_error);
        add_error(held.loading.force_displacement, shifted.loading.force_displacement);
        if (held.unloading && shifted.unloading)
            add_error(held.unloading.value->force_displacement, shifted.unloading->force_displacement);
    }
    analysis.loading = held.loading;
    analysis.unloading = held.unloading;
}

/// Changes by one standard error of the stiffness of the testing machine, which are added to the errors of the fits of
/// force against displacement.
void add_compliance_error(ContactAnalysis& analysis, const PreparedRecord& record, const ContactSegments& contact,
                          const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    if (!options.machine_stiffness || !(options.machine_stiffness_standard_error > 0.0) ||
        record.level.displacement.size() == 0)
        return;
    const Estimate stiffness{.value = *options.machine_stiffness,
                             .standard_error = options.machine_stiffness_standard_error,
                             .method = "given"};
    analysis.compliance = ComplianceEffect{.stiffness = stiffness};
    PreparedRecord stiffer = record;
    stiffer.level.displacement +=
        record.level.force * (1.0 / stiffness.value - 1.0 / (stiffness.value + stiffness.standard_error));
    const auto add = [&](BranchAnalysis& branch, const Outcome<BranchAnalysis>& shifted) {
        if (!branch.force_displacement || !shifted || !shifted->force_displacement) return;
        add_force_zero_error(*branch.force_displacement.value, *shifted->force_displacement, bodies);
    };
    const auto shifted = attempt([&] { return analyse_loading(stiffer, contact, bodies, options); });
    if (shifted && shifted->force_displacement && analysis.loading.force_displacement) {
        analysis.compliance->modulus_change = shifted->force_displacement->contact_modulus.value -
                                              analysis.loading.force_displacement->contact_modulus.value;
        analysis.compliance->work_change = shifted->force_displacement->work_of_adhesion.value -
                                           analysis.loading.force_displacement->work_of_adhesion.value;
    }
    add(analysis.loading, shifted);
    if (analysis.unloading)
        add(*analysis.unloading.value,
            analyse_unloading(stiffer, contact, analysis.pinned, analysis.loading, bodies, options));
    if (analysis.budget) analysis.compliance->energy_change = analysis.budget->approach.standard_error.compliance;
}

Outcome<EnergyBudget> budget_of_contact(const PreparedRecord& record, Index index, const ContactAnalysis& analysis,
                                        const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    const JkrFit& fit = analysis.loading.primary();
    EnergyBudgetInputs inputs{
        .smooth_sphere = {bodies.radius, fit.contact_modulus.value, std::max(fit.work_of_adhesion.value, 0.0)},
        .largest_contact_area = analysis.context.largest_contact_area,
        .true_area_ratio = options.true_area_ratio,
        .drift = options.segments.drift};
    inputs.machine_stiffness = stiffness_of_machine(analysis, options);
    if (options.machine_stiffness && options.machine_stiffness_standard_error > 0.0)
        inputs.displacement_stiffness =
            Estimate{.value = *options.machine_stiffness, .standard_error = options.machine_stiffness_standard_error};
    return attempt([&] { return energy_budget(record.deflected, record.segments, index, inputs); });
}

}  // namespace

Selection without_ignored(Selection selection, const Segments& segments) {
    if (!segments.ignored.empty()) std::erase_if(selection.samples, [&](Index i) { return is_ignored(segments, i); });
    return selection;
}

ContactAnalysis analyse_contact(const PreparedRecord& record, Index index, const LensAndCounterBody& bodies,
                                const AnalysisOptions& options, const ContactAnalysis* decided) {
    const Loop& loop = record.level;
    const Segments& segments = record.segments;
    const ContactSegments& contact = segments.contacts[static_cast<std::size_t>(index)];
    ContactAnalysis analysis;
    AnalysisOptions free = options;
    free.contact_point = {.mode = Mode::fit};
    analysis.loading = analyse_loading(record, contact, bodies, free);
    analysis.context = find_context(loop, contact, analysis.loading, bodies, options);
    analysis.hold = hold_growth(record.levelled(), contact, analysis.loading, bodies, options);
    if (decided) analysis.pinned = decided->pinned;
    else if (options.leave_pinned_out)
        analysis.pinned = pinned_stretch(loop, segments, contact, analysis, bodies, options);
    analysis.unloading = analyse_unloading(record, contact, analysis.pinned, analysis.loading, bodies, free);
    const ContactPointInputs inputs = inputs_of(record, index, analysis, bodies, options);
    analysis.contact_points = attempt([&] { return contact_points(inputs, bodies, options.contact_point); });
    const bool held =
        analysis.contact_points && analysis.contact_points->chosen != ContactPointMethod::force_displacement;
    if (held) {
        hold_contact_point(analysis, record, contact, bodies, options, analysis.contact_points->contact_point);
        analysis.context = find_context(loop, contact, analysis.loading, bodies, options);
    }
    analysis.pull_off = find_pull_off(record, contact, bodies.radius, analysis.loading.primary().contact_modulus.value);
    analysis.retraction = analyse_retraction(record, contact, analysis, bodies, options);
    analysis.loop = attempt([&] { return loop_energy(record.deflected, segments, index, options.segments.drift); });
    analysis.work_along_retraction =
        analyse_work_along(record, analysis, stiffness_of_machine(analysis, options), bodies, options);
    analysis.budget = budget_of_contact(record, index, analysis, bodies, options);
    if (held) free.contact_point = {.mode = Mode::value, .value = analysis.contact_points->contact_point.value};
    add_compliance_error(analysis, record, contact, bodies, free);
    return analysis;
}

}  // namespace setae::loops
