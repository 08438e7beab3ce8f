// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/loop_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "records/jump.hpp"
#include "setae/core/errors.hpp"
#include "work_integral.hpp"

namespace setae::loops {
namespace {

/// The discretisation error of the smooth pieces between the jumps.
double smooth_error(const LevelRecord& record, const ContactSegments& contact, const IndexRange& range) {
    double error = 0.0;
    Index start = range.first;
    const auto add_until = [&](Index end) {
        error += discretisation_error(record, {.first = start, .last = end});
        start = end + 1;
    };
    if (contact.jump_in) add_until(largest_step(record.force, *contact.jump_in));
    if (contact.pull_off) add_until(largest_step(record.force, *contact.pull_off));
    add_until(range.last);
    return std::abs(error);
}

}  // namespace

LoopEnergy loop_energy(const Loop& loop, const Segments& segments, Index contact, DriftModel drift) {
    if (contact < 0 || contact >= static_cast<Index>(segments.contacts.size()))
        throw InvalidArgument(fmt::format("contact {} of {}", contact, segments.contacts.size()));
    const ContactSegments& touch = segments.contacts[static_cast<std::size_t>(contact)];
    if (loop.displacement.size() == 0)
        throw UndefinedDataError("a loop energy needs the displacement, which was not measured");
    const IndexRange range = closed_range(segments, contact);
    const LevelRecord record(loop, segments, drift);
    LoopEnergy result{.energy = work(record.force, loop.displacement, range),
                      .opening = loop.displacement[range.last] - loop.displacement[range.first]};
    result.without_drift = work(LevelRecord(loop, segments, DriftModel::constant).force, loop.displacement, range);
    LoopErrorBudget& budget = result.standard_error;
    budget.noise = noise_error(record, range);
    budget.drift = drift_error(record, range);
    std::array<double, 2> limits{};
    if (touch.jump_in) limits[0] = jump_error_limit(record, *touch.jump_in);
    if (touch.pull_off) limits[1] = jump_error_limit(record, *touch.pull_off);
    budget.sampling = std::hypot(limits[0], limits[1]) / std::sqrt(3.0);
    budget.discretisation = smooth_error(record, touch, range);
    const double drift_known = std::isnan(budget.drift) ? 0.0 : budget.drift;
    const double normal = std::hypot(std::hypot(budget.noise, drift_known), budget.discretisation);
    budget.total = std::hypot(normal, budget.sampling);
    if (budget.total > 0.0) result.half_width = half_width(normal, limits);
    return result;
}

std::optional<Estimate> partial_loop_energy(const Loop& loop, const Segments& segments, Index cycle,
                                            DriftModel drift_model) {
    if (cycle < 0 || cycle >= static_cast<Index>(segments.cycles.size()))
        throw InvalidArgument(fmt::format("cycle {} of {}", cycle, segments.cycles.size()));
    const Cycle& release = segments.cycles[static_cast<std::size_t>(cycle)];
    if (release.ends_in_pull_off || loop.displacement.size() == 0) return std::nullopt;
    const Index end = segments.contacts[static_cast<std::size_t>(release.contact)].extent.last;
    const Array1D& displacement = loop.displacement;
    const LevelRecord record(loop, segments, drift_model);
    const Array1D& force = record.force;
    const Index peak = release.unloading.first;
    Index reached = release.unloading.last;
    while (reached < end && displacement[reached] < displacement[peak]) ++reached;
    if (displacement[reached] < displacement[peak]) return std::nullopt;
    // the last step only as far as the displacement at which the release began
    const double step = displacement[reached] - displacement[reached - 1];
    const double share = (displacement[peak] - displacement[reached - 1]) / step;
    const double force_there = force[reached - 1] + share * (force[reached] - force[reached - 1]);
    const IndexRange whole{.first = peak, .last = reached - 1};
    const double drift = drift_error(record, whole);
    return Estimate{.value = work(force, displacement, whole) + 0.5 * (force[reached - 1] + force_there) * share * step,
                    .standard_error = std::hypot(noise_error(record, whole), std::isnan(drift) ? 0.0 : drift,
                                                 discretisation_error(record, whole)),
                    .method = "error budget"};
}

}  // namespace setae::loops
