// SPDX-License-Identifier: GPL-3.0-or-later
#include "branch.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "attempt.hpp"
#include "finite_height.hpp"
#include "fits/fit_support.hpp"
#include "records/channel_noise.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

Array1D picked(const Array1D& series, const std::vector<Index>& samples) {
    if (series.size() == 0) return Array1D();
    Array1D values(static_cast<Index>(samples.size()));
    for (Index i = 0; i < values.size(); ++i) values[i] = series[samples[static_cast<std::size_t>(i)]];
    return values;
}

std::vector<Index> in_contact(const Loop& loop, const std::vector<Index>& samples) {
    if (loop.contact_radius.size() == 0) return samples;
    std::vector<Index> kept;
    for (const Index i : samples)
        if (loop.contact_radius[i] > 0.0) kept.push_back(i);
    return kept;
}

/// A fit with the errors of the zero of force in its covariance, or why there is none.
template <class Fit>
Outcome<JkrFit> fitted(const BranchData& data, const LensAndCounterBody& bodies, const Fit& fit) {
    Outcome<JkrFit> result = attempt([&] { return fit(data); });
    if (!result) return result;
    for (Index mode = 0; mode < data.force_zero_modes.cols(); ++mode) {
        const BranchData higher = data.with_higher_force(data.force_zero_modes.col(mode));
        if (const Outcome<JkrFit> shifted = attempt([&] { return fit(higher); }))
            add_force_zero_error(*result.value, *shifted, bodies);
    }
    return result;
}

/// Force against displacement, with a fixed contact point where one is given.
JkrFit depth_fit(const BranchData& data, const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    if (options.contact_point.mode == ContactPointChoice::Mode::value)
        return fit_with_contact_point(data, bodies, options.contact_point.value);
    return fit_force_displacement(
        data, bodies, options.effective_variance ? DepthErrors::effective_variance : DepthErrors::depth_only);
}

bool can_weigh_both(const BranchData& data) { return data.force_noise > 0.0 && data.contact_radius_noise > 0.0; }

bool can_join(const BranchData& data) {
    return can_weigh_both(data) && data.contact_radius.size() > 0 && data.displacement.size() > 0;
}

const char* why_not_joined(const BranchData& data) {
    if (data.contact_radius.size() == 0) return "the joint fit needs the contact radius, which was not measured";
    if (data.displacement.size() == 0) return "the joint fit needs the displacement, which was not measured";
    return "the noise of force, displacement or contact radius is not known";
}

/// The largest force, or the begin of a hold: because of noise the largest of held forces can be anywhere in it. A
/// force that is the largest within three times the time of the ramp for this rise belongs to the ramp.
Index end_of_loading(const Loop& loop, const ContactSegments& contact) {
    const Index first = contact.loading.first, peak = contact.loading.last;
    if (!contact.hold || contact.hold->first <= first || contact.hold->first >= peak) return peak;
    const Index begins = contact.hold->first;
    const double rise = (loop.force[begins] - loop.force[first]) / static_cast<double>(begins - first);
    const double ramp = (loop.force[peak] - loop.force[begins]) / rise;
    constexpr double turns = 3.0;
    return static_cast<double>(peak - begins) <= turns * std::max(ramp, 1.0) ? peak : begins;
}

}  // namespace

Selection range_selection(const IndexRange& range, std::string name) {
    Selection selection{.name = std::move(name)};
    for (Index i = range.first; i <= range.last; ++i) selection.samples.push_back(i);
    return selection;
}

Selection loading_selection(const Loop& loop, const Segments& segments, const ContactSegments& contact, Index dropped) {
    const Index end = end_of_loading(loop, contact);
    Selection selection{.name = fmt::format("loading, from {} samples after first contact to the {}", dropped,
                                            end < contact.loading.last ? "hold" : "largest force")};
    Index next = contact.loading.first + dropped;
    const auto take_until = [&](Index last) {
        for (; next <= last; ++next) selection.samples.push_back(next);
    };
    for (const Index index : contact.cycles) {
        const Cycle& cycle = segments.cycles[static_cast<std::size_t>(index)];
        const Index peak = cycle.loading.last;
        if (peak >= end) break;
        take_until(peak);
        next = std::max(next, cycle.unloading.last);
        while (next < end && loop.force[next] < loop.force[peak]) ++next;
    }
    take_until(end);
    return selection;
}

BranchData BranchData::with_higher_force(const Eigen::Ref<const Array1D>& shift) const {
    BranchData higher = *this;
    higher.force += shift;
    if (higher.displacement.size() > 0) higher.displacement -= compliance * shift;
    return higher;
}

BranchData branch_data(const LevelledLoop& record, const Selection& selection, const AnalysisOptions& options) {
    const Loop& loop = record.loop;
    const std::vector<Index> samples = in_contact(loop, selection.samples);
    BranchData data{.force = picked(loop.force, samples),
                    .displacement = picked(loop.displacement, samples),
                    .contact_radius = picked(loop.contact_radius, samples),
                    .force_noise = record.noise.force_noise,
                    .displacement_noise = record.noise.displacement_noise,
                    .force_displacement_covariance = record.noise.force_displacement_covariance,
                    .force_zero_modes = record.zero_modes(samples, Eigen::all),
                    .compliance = options.machine_stiffness ? 1.0 / *options.machine_stiffness : 0.0};
    data.contact_radius_noise =
        options.contact_radius_noise ? *options.contact_radius_noise : white_noise(data.contact_radius);
    return data;
}

JkrFit primary_fit(const BranchData& data, const LensAndCounterBody& bodies, const AnalysisOptions& options) {
    if (data.contact_radius.size() == 0) return depth_fit(data, bodies, options);
    const bool both = options.effective_variance && can_weigh_both(data);
    return fit_radius_force(data, bodies, both ? RadiusErrors::effective_variance : RadiusErrors::radius_only);
}

const JkrFit& BranchAnalysis::primary() const {
    if (effective_variance_first && radius_force_effective_variance) return *radius_force_effective_variance;
    return radius_force ? *radius_force : *force_displacement;
}

BranchAnalysis analyse_branch(const LevelledLoop& record, const Selection& selection, const LensAndCounterBody& bodies,
                              const AnalysisOptions& options, const std::optional<Estimate>& elastic_modulus) {
    const BranchData data = as_half_space(branch_data(record, selection, options), bodies, options);
    BranchAnalysis branch{.effective_variance_first = options.effective_variance};
    const auto radius_fit = [&](RadiusErrors errors) {
        return fitted(data, bodies,
                      [&](const BranchData& samples) { return fit_radius_force(samples, bodies, errors); });
    };
    branch.radius_force = radius_fit(RadiusErrors::radius_only);
    branch.radius_force_effective_variance =
        can_weigh_both(data) ? radius_fit(RadiusErrors::effective_variance)
                             : Outcome<JkrFit>::missing("the noise of force or contact radius is not known");
    branch.linear_form =
        fitted(data, bodies, [&](const BranchData& samples) { return fit_linear_form(samples, bodies); });
    branch.force_displacement =
        fitted(data, bodies, [&](const BranchData& samples) { return depth_fit(samples, bodies, options); });
    branch.joint = can_join(data)
                       ? fitted(data, bodies, [&](const BranchData& samples) { return fit_joint(samples, bodies); })
                       : Outcome<JkrFit>::missing(why_not_joined(data));
    branch.pointwise = attempt([&] { return fit_pointwise_modulus(data, bodies); });
    if (!branch.radius_force && !branch.force_displacement)
        throw UndefinedDataError(fmt::format(
            "{}: no fit: {}", selection.name,
            data.contact_radius.size() > 0 ? branch.radius_force.reason : branch.force_displacement.reason));
    const std::vector<Index> samples = in_contact(record.loop, selection.samples);
    branch.range = {.name = selection.name,
                    .first = samples.front(),
                    .last = samples.back(),
                    .n = static_cast<Index>(samples.size()),
                    .force_first = data.force[0],
                    .force_last = data.force[data.force.size() - 1]};
    const JkrFit& fit = branch.primary();
    const bool measured = data.contact_radius.size() > 0;
    const Estimate contact_point =
        branch.force_displacement ? branch.force_displacement->contact_point : Estimate{.value = 0.0};
    branch.energy_release_rate = energy_release_rates(
        data, bodies.radius, elastic_modulus && measured ? *elastic_modulus : fit.contact_modulus, contact_point);
    return branch;
}

}  // namespace setae::loops
