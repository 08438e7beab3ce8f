// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/force_curve_summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "attempt.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

/// The branches of a curve; empty where it lacks one.
struct Ways {
    const CurveSegment* approach = nullptr;
    const CurveSegment* retraction = nullptr;
};

/// The first segment into the sample and the last one out of it.
Ways ways_of(const std::vector<CurveSegment>& segments) {
    Ways ways;
    for (const CurveSegment& segment : segments) {
        if (segment.name == "pause") continue;
        const bool inwards = segment.displacement[segment.displacement.size() - 1] > segment.displacement[0];
        if (inwards && !ways.approach) ways.approach = &segment;
        if (!inwards) ways.retraction = &segment;
    }
    return ways;
}

/// Variance of a baseline at a displacement, divided by that of the noise: 1/n, for a sloped line plus (δ − δ̄)²/S.
double line_variance(const CurveSegment& segment, double displacement, bool sloped) {
    const IndexRange& range = segment.baseline.range;
    const Array1D along = segment.displacement.segment(range.first - segment.range.first, range.count());
    const double away = displacement - along.mean(), sum = (along - along.mean()).square().sum();
    const double n = static_cast<double>(range.count());
    return 1.0 / n + (sloped && sum > 0.0 ? away * away / sum : 0.0);
}

double noise_of_flight(const CurveSegment& segment) {
    if (std::isfinite(segment.baseline.force_noise)) return segment.baseline.force_noise;
    throw UndefinedDataError(fmt::format("the {} segment has no free flight, which gives the noise", segment.name));
}

Estimate pull_off_of(const CurveSegment& retraction, bool sloped) {
    const double noise = noise_of_flight(retraction);
    if (!(retraction.smallest_force < 0.0))
        throw UndefinedDataError(fmt::format("no attraction exceeds the noise of {:.2g} N", noise));
    Index at = 0;
    const double force = retraction.force.minCoeff(&at);
    return {force, noise * std::sqrt(1.0 + line_variance(retraction, retraction.displacement[at], sloped)),
            "baseline noise"};
}

/// ∫F dδ of a way over displacements above `from`, in the order of the record, and its variance.
struct Work {
    double energy = 0.0, variance = 0.0;
    double first_displacement = 0.0, first_force = 0.0, last_displacement = 0.0, last_force = 0.0;
};

Work work_of(const CurveSegment& segment, double from, bool sloped) {
    std::vector<Index> inside;
    for (Index i = 0; i < segment.displacement.size(); ++i)
        if (segment.displacement[i] >= from) inside.push_back(i);
    if (inside.size() < 2) throw UndefinedDataError("approach and retraction have no displacement in common");
    const Array1D displacement = segment.displacement(inside), force = segment.force(inside);
    const Index last = displacement.size() - 1;
    Array1D weight = Array1D::Zero(last + 1);
    weight.head(last) += 0.5 * (displacement.tail(last) - displacement.head(last));
    weight.tail(last) += 0.5 * (displacement.tail(last) - displacement.head(last));
    const double noise = noise_of_flight(segment), length = displacement.maxCoeff() - displacement.minCoeff(),
                 middle = 0.5 * (displacement.maxCoeff() + displacement.minCoeff());
    return {
        .energy = (weight * force).sum(),
        .variance = noise * noise * (weight.square().sum() + length * length * line_variance(segment, middle, sloped)),
        .first_displacement = displacement[0],
        .first_force = force[0],
        .last_displacement = displacement[last],
        .last_force = force[last]};
}

/// A retraction whose free end scatters so much more than the approach's is still in contact there.
constexpr double max_noise_ratio = 5.0;

Estimate loss_of(const CurveSegment& approach, const CurveSegment& retraction, bool sloped) {
    const double ratio = noise_of_flight(retraction) / noise_of_flight(approach);
    if (ratio > max_noise_ratio)
        throw UndefinedDataError(
            fmt::format("the {} segment does not return to free flight: the scatter at its end is {:.3g} times that at "
                        "the beginning of the approach",
                        retraction.name, ratio));
    const double from = std::max(approach.displacement.minCoeff(), retraction.displacement.minCoeff());
    const Work in = work_of(approach, from, sloped), out = work_of(retraction, from, sloped);
    // creep of the sample while the base is held connects the two branches
    const double held = 0.5 * (in.last_force + out.first_force) * (out.first_displacement - in.last_displacement);
    return {in.energy + held + out.energy, std::sqrt(in.variance + out.variance), "baseline noise"};
}

template <class Result>
Outcome<Estimate> part_of(const Outcome<ForceCurveFit>& fit, Result&& result) {
    return fit ? Outcome<Estimate>(result(*fit)) : Outcome<Estimate>::missing(fit.reason);
}

Outcome<Estimate> work_by_pull_off(const Outcome<Estimate>& force, const LensAndCounterBody& bodies,
                                   const ForceCurveFitOptions& options) {
    if (!force) return Outcome<Estimate>::missing(force.reason);
    if (options.shape != TipShape::paraboloid)
        return Outcome<Estimate>::missing(
            fmt::format("the pull-off force of a {} does not give W", to_string(options.shape)));
    const double work = contact::jkr::work_of_adhesion_from_pull_off(force->value, bodies.radius);
    return Estimate{work, work * force->standard_error / std::abs(force->value), "delta"};
}

ForceCurveSummary summary_of(const std::vector<CurveSegment>& segments, const LensAndCounterBody& bodies,
                             const ForceCurveFitOptions& options) {
    const Ways ways = ways_of(segments);
    const bool dry = options.model == ContactModel::hertz, sloped = options.subtract_baseline_slope;
    const auto no = [](const char* way) { return Outcome<Estimate>::missing(fmt::format("the curve has no {}", way)); };
    const CurveSegment* fitted = dry ? ways.approach : ways.retraction;
    ForceCurveSummary summary;
    const auto fit =
        fitted ? attempt([&] { return fit_force_curve(*fitted, bodies, options); })
               : Outcome<ForceCurveFit>::missing(fmt::format("the curve has no {}", dry ? "approach" : "retraction"));
    if (fitted) summary.fitted_segment = fitted->name;
    summary.contact_modulus = part_of(fit, [](const ForceCurveFit& f) { return f.contact_modulus; });
    summary.youngs_modulus = part_of(fit, [](const ForceCurveFit& f) { return f.youngs_modulus; });
    summary.pull_off_force =
        ways.retraction ? attempt([&] { return pull_off_of(*ways.retraction, sloped); }) : no("retraction");
    summary.energy_loss = !ways.approach ? no("approach")
                          : !ways.retraction
                              ? no("retraction")
                              : attempt([&] { return loss_of(*ways.approach, *ways.retraction, sloped); });
    summary.work_by_pull_off = dry;
    if (dry) summary.work_of_adhesion = work_by_pull_off(summary.pull_off_force, bodies, options);
    else summary.work_of_adhesion = fit ? fit->work_of_adhesion : Outcome<Estimate>::missing(fit.reason);
    return summary;
}

constexpr CurveQuantity quantities_of_curves[] = {
    {"contact_modulus", "E*", "E_star", "Pa", &ForceCurveSummary::contact_modulus},
    {"youngs_modulus", "E", "E", "Pa", &ForceCurveSummary::youngs_modulus},
    {"work_of_adhesion", "W", "W", "J/m2", &ForceCurveSummary::work_of_adhesion},
    {"pull_off_force", "F_po", "F_po", "N", &ForceCurveSummary::pull_off_force},
    {"energy_loss", "E_loss", "E_loss", "J", &ForceCurveSummary::energy_loss}};

}  // namespace

std::span<const CurveQuantity> curve_quantities() { return quantities_of_curves; }

ForceCurveSummary summary_of_force_curve(const Table& curve, const LensAndCounterBody& bodies,
                                         const ForceCurveFitOptions& options) {
    return summary_of(segments_of_curve(curve, options), bodies, options);
}

ForceCurveAnalysis analyse_force_curve(const Table& curve, const LensAndCounterBody& bodies,
                                       const ForceCurveFitOptions& options) {
    return {fit_force_curve(curve, bodies, options), summary_of_force_curve(curve, bodies, options)};
}

}  // namespace setae::loops
