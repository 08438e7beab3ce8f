// SPDX-License-Identifier: GPL-3.0-or-later
#include "alerts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "alert_list.hpp"
#include "finite_height.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"

namespace setae::loops {
namespace {

void check_fit(AlertList& list, const BranchAnalysis& branch, const char* name, const AlertLimits& limits) {
    const JkrFit& fit = branch.primary();
    if (!fit.converged)
        list.add("NOT_CONVERGED",
                 fmt::format("{}: the fit did not converge within {} iterations", name, fit.iterations),
                 "do not use these values; check the segments and the fit range");
    if (fit.unbounded_work && fit.unbounded_work->value < -limits.work_deviations * fit.unbounded_work->standard_error)
        list.add("WORK_NEGATIVE",
                 fmt::format("{}: the contact is smaller than a contact without adhesion: the fit gives W = {}; 0 is "
                             "reported",
                             name, format_uncertain(*fit.unbounded_work, "J/m2")),
                 "check the zero of force, the contact point and the stiffness of the testing machine");
    if (fit.within_noise == true || fit.relative_residual < limits.relative_misfit) return;
    const std::string residuals =
        fmt::format("the rms residual is {}, {:.1f} % of the fitted range",
                    format_value(fit.rms_residual, fit.residual_unit), 100.0 * fit.relative_residual);
    const std::string beyond =
        fit.within_noise ? fmt::format("; neighbouring residuals are correlated and exceed the noise (χ²_red {:.3g})",
                                       fit.chi2_reduced)
                         : "";
    if (fit.relative_residual > limits.relative_residual)
        list.add("POOR_FIT", fmt::format("{}: the JKR curve does not fit the data: {}{}", name, residuals, beyond),
                 "look at the residuals; after a slip, a second contact, drift or a sensor fault, E* and W have "
                 "no meaning");
    else if (fit.within_noise)
        list.add("BEYOND_NOISE",
                 fmt::format("{}: the JKR curve does not fit the data within the noise: {}{}", name, residuals, beyond),
                 "look at the residuals; report E* and W with their fit range, on which they depend");
}

void check_sensitivity(AlertList& list, const BranchAnalysis& loading, const AlertLimits& limits) {
    double least = INFINITY, most = -INFINITY;
    for (const RangeSensitivity& entry : loading.sensitivity) {
        if (!entry.fit) continue;
        least = std::min(least, entry.fit->work_of_adhesion.value);
        most = std::max(most, entry.fit->work_of_adhesion.value);
    }
    constexpr double deviations = 2.0;  // standard deviations of noise, which affects W, too
    const Estimate& work = loading.primary().work_of_adhesion;
    if (most - least > std::max(limits.work_spread * std::abs(work.value), deviations * std::sqrt(work.variance())))
        list.add("RANGE_SENSITIVE",
                 fmt::format("loading: W varies from {} to {} with the number of samples left out after first contact",
                             format_value(least, "J/m2"), format_value(most, "J/m2")),
                 "report W together with its fit range");
}

/// A base below a soft body of finite height increases the contact stiffness.
void check_height(AlertList& list, const LoopContext& context, const Loop& loop, const LensAndCounterBody& bodies,
                  const AlertLimits& limits) {
    const double a = context.largest_contact_radius;
    const auto excess = [&](double height) {
        return 100.0 * modulus_excess(a, std::max(height, a), bodies.lens_poisson_ratio);
    };
    if (const auto height = bodies.soft_height()) {
        if (a > limits.contact_radius_per_thickness * *height)
            list.add(
                "THIN_LAYER",
                fmt::format(
                    "a/h reaches {:.2f}: with the formulas of a half-space, E* from force and displacement would be "
                    "{:.0f} % too high; the fits are corrected as for a layer bonded to a rigid base",
                    a / *height, excess(*height)),
                "if the soft body is not a layer bonded to a rigid base, use a higher body or a smaller load");
        return;
    }
    if (loop.displacement.size() == 0 || !(a > limits.contact_radius_per_unknown_height * bodies.radius)) return;
    list.add(
        "HEIGHT_UNKNOWN",
        fmt::format("the height of the soft body is not given and is taken as infinite: E* from force and "
                    "displacement is {:.1f} % too high if the height is {} (the radius of the sphere), and {:.1f} % "
                    "if it is ten times that",
                    excess(bodies.radius), format_value(bodies.radius, "m"), excess(10.0 * bodies.radius)),
        "give lens_height or layer_thickness");
}

void check_size(AlertList& list, const LoopContext& context, const LensAndCounterBody& bodies,
                const AlertLimits& limits) {
    const double strain = context.largest_contact_radius / bodies.radius;
    if (strain > limits.contact_radius_per_sphere_radius)
        list.add(
            "LARGE_STRAIN",
            fmt::format("a/R reaches {:.2f}: there the sphere is deeper than the paraboloid of JKR by {:.1f} % of a²/R",
                        strain, 100.0 * strain * strain / 3.0),
            "reduce the load, or treat E* and W as those of an effective paraboloid");
    if (context.tabor_parameter.value < limits.tabor_parameter)
        list.add("TABOR_RANGE",
                 fmt::format("the Tabor parameter is {:.2g}: JKR holds above {}", context.tabor_parameter.value,
                             limits.tabor_parameter),
                 "fit maugis_dugdale, or dmt if the Tabor parameter is below 0.1");
}

void check_contact_point(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, const AlertLimits& limits) {
    constexpr const char* action =
        "check the drift and the compliance of the testing machine; E* and W change with the contact "
        "point";
    if (loop.displacement.size() > 0 && !analysis.contact_points)
        list.add("CONTACT_POINT_UNKNOWN", analysis.contact_points.reason,
                 "choose another estimator of the contact point, or give the contact point");
    if (analysis.contact_points && analysis.contact_points->spread_share > limits.contact_point_share) {
        const ContactPoints& points = *analysis.contact_points;
        std::string each;
        for (const ContactPointEstimate& estimate : points.estimates)
            if (estimate.contact_point)
                each += fmt::format("{}{} {}", each.empty() ? "" : ", ", contact_point_name(estimate.method),
                                    format_value(estimate.contact_point->value - points.contact_point.value, "m", 3));
        list.add("CONTACT_POINT_SPREAD",
                 fmt::format("the estimates of the contact point spread over {}, {:.0f} % of the largest penetration; "
                             "distances from the one used: {}",
                             format_value(points.spread, "m"), 100.0 * points.spread_share, each),
                 action);
        return;
    }
    if (!analysis.unloading || !analysis.loading.force_displacement || !analysis.unloading->force_displacement) return;
    const double loading = analysis.loading.force_displacement->contact_point.value;
    const double unloading = analysis.unloading->force_displacement->contact_point.value;
    const double penetration = loop.displacement[analysis.loading.range.last] - loading;
    if (std::abs(unloading - loading) > limits.contact_point_share * std::abs(penetration))
        list.add(
            "CONTACT_POINT_SPREAD",
            fmt::format("the contact points of loading and unloading differ by {}, {:.0f} % of the largest penetration",
                        format_value(unloading - loading, "m"), 100.0 * std::abs((unloading - loading) / penetration)),
            action);
}

/// The displacement of a contact much stiffer than the testing machine is a small difference of large numbers.
void check_stiffness(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, const AlertLimits& limits) {
    if (!analysis.pull_off || loop.displacement.size() == 0) return;
    const double machine = analysis.pull_off->machine_stiffness;
    const FitRange& range = analysis.loading.range;
    const double deflection = loop.displacement[range.last] - loop.displacement[range.first];
    const double contact = (range.force_last - range.force_first) / deflection;
    if (!(contact > limits.stiffness_ratio * machine)) return;
    list.add(
        "STIFFNESS_UNRESOLVED",
        fmt::format("the contact is {:.0f} times stiffer than the testing machine ({} against {}): an error of 1 % "
                    "in the calibration of the sensor changes the penetration by {:.0f} %",
                    contact / machine, format_value(contact, "N/m", 3), format_value(machine, "N/m", 3),
                    contact / machine),
        "use E* as a lower bound only; measure with a stiffer sensor or a softer sample");
}

/// Intervals of fits to very noisy records are known to be somewhat too short (setae lab records).
void check_noise(AlertList& list, const LoopAnalysis& analysis, const Loop& loop, const AlertLimits& limits) {
    const Baseline& noise = analysis.segments.before;
    const auto check = [&](const char* channel, double sigma, double range, const char* unit, const char* of) {
        if (!(sigma > limits.noise_share * range) || !(range > 0.0)) return;
        list.add(
            "NOISY_RECORD",
            fmt::format("the noise of the {} is {} per sample, {:.0f} % of the largest {}: 95 % intervals cover the "
                        "true value in fewer than 95 % of cases",
                        channel, format_value(sigma, unit, 3), 100.0 * sigma / range, of),
            "average over neighbouring samples, or record more slowly");
    };
    check("force", noise.force_noise, -loop.force.minCoeff(), "N", "tension");
    if (loop.displacement.size() == 0 || !analysis.loading.force_displacement) return;
    const double contact_point = analysis.loading.force_displacement->contact_point.value;
    check("displacement", noise.displacement_noise, loop.displacement[analysis.loading.range.last] - contact_point, "m",
          "penetration");
}

void check_loop(AlertList& list, const LoopAnalysis& analysis, const AlertLimits& limits) {
    if (!analysis.unloading)
        list.add("NO_RETRACTION", analysis.unloading.reason, "record the retraction to pull-off and beyond");
    if (!analysis.loop) return;
    const LoopErrorBudget& budget = analysis.loop->standard_error;
    const double sampling = std::hypot(budget.sampling, budget.discretisation);
    if (sampling > limits.loop_sampling_share * std::abs(analysis.loop->energy))
        list.add("LOOP_UNDERSAMPLED",
                 fmt::format("the sampling of the record leaves {} of the loop energy {} uncertain",
                             format_value(sampling, "J"), format_value(analysis.loop->energy, "J")),
                 "record more samples per second, above all at jump-in and pull-off");
}

}  // namespace

std::vector<Alert> alerts_of(const LoopAnalysis& analysis, const Loop& loop, const LensAndCounterBody& bodies,
                             const AlertLimits& limits, const std::string& subject) {
    AlertList list(subject);
    check_fit(list, analysis.loading, "loading", limits);
    if (analysis.unloading) check_fit(list, *analysis.unloading, "unloading", limits);
    check_sensitivity(list, analysis.loading, limits);
    check_size(list, analysis.context, bodies, limits);
    check_contact_point(list, analysis, loop, limits);
    check_stiffness(list, analysis, loop, limits);
    check_loop(list, analysis, limits);
    check_drift(list, analysis, loop, limits);
    check_noise(list, analysis, loop, limits);
    check_record(list, analysis, loop, bodies, limits);
    check_height(list, analysis.context, loop, bodies, limits);
    return list.take();
}

}  // namespace setae::loops
