// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/experiment/loop_energy.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "drift.hpp"
#include "jump.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::experiment {
namespace {

/// ∫F dδ by the trapezoid rule, each term small because F is counted from the baseline.
double work(const Array1D& force, const Array1D& displacement, const IndexRange& range, Index stride = 1) {
    double sum = 0.0;
    Index i = range.first;
    while (i < range.last) {
        const Index next = std::min(i + stride, range.last);
        sum += 0.5 * (force[i] + force[next]) * (displacement[next] - displacement[i]);
        i = next;
    }
    return sum;
}

/// Error of the sums from independent noise of each sample.
double noise_error(const Array1D& force, const Array1D& displacement, const IndexRange& range, const Baseline& noise) {
    double variance = 0.0;
    for (Index i = range.first + 1; i < range.last; ++i) {
        const double by_force = 0.5 * (displacement[i + 1] - displacement[i - 1]);
        const double by_displacement = 0.5 * (force[i - 1] - force[i + 1]);
        variance += std::pow(by_force * noise.force_noise, 2) + std::pow(by_displacement * noise.displacement_noise, 2) +
                    2.0 * by_force * by_displacement * noise.force_displacement_covariance;
    }
    return std::sqrt(std::max(variance, 0.0));
}

/// Error of a jump: its ends lie somewhere within the sampling steps beside it, which sweeps the area spanned by jump and
/// step; evenly distributed, hence √12.
double jump_error(const Array1D& force, const Array1D& displacement, const IndexRange& jump) {
    const Index at = largest_step(force, jump);
    const auto area = [&](Index step) {
        if (step < 0 || step + 1 >= force.size()) return 0.0;
        return (force[at + 1] - force[at]) * (displacement[step + 1] - displacement[step]) -
               (displacement[at + 1] - displacement[at]) * (force[step + 1] - force[step]);
    };
    return std::hypot(area(at - 1), area(at + 1)) / std::sqrt(12.0);
}

/// The trapezoid rule against itself with every second sample, on the smooth pieces between the jumps.
double discretisation_error(const Array1D& force, const Array1D& displacement, const ContactSegments& contact) {
    double error = 0.0;
    Index start = contact.extent.first;
    const auto add_until = [&](Index end) {
        const IndexRange piece{.first = start, .last = end};
        error += (work(force, displacement, piece, 2) - work(force, displacement, piece)) / 3.0;
        start = end + 1;
    };
    if (contact.jump_in) add_until(largest_step(force, *contact.jump_in));
    if (contact.pull_off) add_until(largest_step(force, *contact.pull_off));
    add_until(contact.extent.last);
    return std::abs(error);
}

}  // namespace

LoopEnergy loop_energy(const Loop& loop, const Segments& segments, Index contact) {
    if (contact < 0 || contact >= static_cast<Index>(segments.contacts.size()))
        throw InvalidArgument(fmt::format("contact {} of {}", contact, segments.contacts.size()));
    const ContactSegments& touch = segments.contacts[static_cast<std::size_t>(contact)];
    if (loop.displacement.size() == 0) throw UndefinedDataError("a loop energy needs the displacement, which was not measured");
    if (!touch.unloading || (!touch.pull_off && touch.unloading->last >= touch.extent.last))
        throw UndefinedDataError("the record ends in contact: no closed loop");

    const Baseline& before = segments.before;
    Array1D force = loop.force - before.force;
    LoopEnergy result{.without_drift = work(force, loop.displacement, touch.extent),
                      .opening = loop.displacement[touch.extent.last] - loop.displacement[touch.extent.first]};
    LoopErrorBudget& budget = result.standard_error;
    budget.drift = undefined;
    if (segments.after && before.range) {
        const Array1D share = share_of_drift(loop, *before.range, *segments.after->range);
        force -= share * (segments.after->force - before.force);
        const double by_after = work(share, loop.displacement, touch.extent);
        budget.drift = std::hypot((result.opening - by_after) * before.force_standard_error,
                                  by_after * segments.after->force_standard_error);
    }
    result.energy = work(force, loop.displacement, touch.extent);
    budget.noise = noise_error(force, loop.displacement, touch.extent, before);
    if (touch.jump_in) budget.sampling = jump_error(force, loop.displacement, *touch.jump_in);
    if (touch.pull_off) budget.sampling = std::hypot(budget.sampling, jump_error(force, loop.displacement, *touch.pull_off));
    budget.discretisation = discretisation_error(force, loop.displacement, touch);
    const double drift = std::isnan(budget.drift) ? 0.0 : budget.drift;
    budget.total = std::hypot(std::hypot(budget.noise, drift), std::hypot(budget.sampling, budget.discretisation));
    return result;
}

std::optional<double> partial_loop_energy(const Loop& loop, const Segments& segments, Index cycle) {
    if (cycle < 0 || cycle >= static_cast<Index>(segments.cycles.size()))
        throw InvalidArgument(fmt::format("cycle {} of {}", cycle, segments.cycles.size()));
    const Cycle& release = segments.cycles[static_cast<std::size_t>(cycle)];
    if (release.ends_in_pull_off || loop.displacement.size() == 0) return std::nullopt;
    const Index end = segments.contacts[static_cast<std::size_t>(release.contact)].extent.last;
    const Array1D& displacement = loop.displacement;
    const Array1D force = loop.force - segments.before.force;
    const Index peak = release.unloading.first;
    Index reached = release.unloading.last;
    while (reached < end && displacement[reached] < displacement[peak]) ++reached;
    if (displacement[reached] < displacement[peak]) return std::nullopt;
    // the last step only as far as the displacement at which the release began
    const double step = displacement[reached] - displacement[reached - 1];
    const double share = (displacement[peak] - displacement[reached - 1]) / step;
    const double force_there = force[reached - 1] + share * (force[reached] - force[reached - 1]);
    return work(force, displacement, {.first = peak, .last = reached - 1}) +
           0.5 * (force[reached - 1] + force_there) * share * step;
}

}  // namespace setae::experiment
