// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/experiment/loop_energy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "drift.hpp"
#include "jump.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

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

/// Largest error of a jump. It happened somewhere within its sampling step, f of it with the motion before and 1 − f with that after: the
/// chord between the samples then errs by ½ [(1 − f) A_after − f A_before], A the area jump and motion of one step span; for steady
/// motion A (½ − f), evenly distributed between ± A/2.
double jump_error_limit(const Array1D& force, const Array1D& displacement, const IndexRange& jump) {
    const Index at = largest_step(force, jump);
    const auto area = [&](Index step) {
        if (step < 0 || step + 1 >= force.size()) return 0.0;
        return (force[at + 1] - force[at]) * (displacement[step + 1] - displacement[step]) -
               (displacement[at + 1] - displacement[at]) * (force[step + 1] - force[step]);
    };
    return 0.25 * std::abs(area(at - 1) + area(at + 1));
}

/// P(|N + U_1 + U_2| <= x): N normal, U evenly distributed between ± its limit.
double probability_within(double x, double deviation, const std::array<double, 2>& limits) {
    constexpr int cells = 24;
    double sum = 0.0;
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            const auto place = [](int k) { return 2.0 * (k + 0.5) / cells - 1.0; };
            const double shift = limits[0] * place(i) + limits[1] * place(j);
            sum += normal_probability((x - shift) / deviation) - normal_probability((-x - shift) / deviation);
        }
    return sum / (cells * cells);
}

/// Half the width of the 95 % interval of such a sum.
double half_width(double deviation, const std::array<double, 2>& limits) {
    const double smallest = std::max(deviation, 1e-3 * (limits[0] + limits[1]));
    double lower = 0.0, upper = 4.0 * deviation + limits[0] + limits[1];
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (lower + upper);
        (probability_within(middle, smallest, limits) < 0.95 ? lower : upper) = middle;
    }
    return upper;
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
    std::array<double, 2> limits{};
    if (touch.jump_in) limits[0] = jump_error_limit(force, loop.displacement, *touch.jump_in);
    if (touch.pull_off) limits[1] = jump_error_limit(force, loop.displacement, *touch.pull_off);
    budget.sampling = std::hypot(limits[0], limits[1]) / std::sqrt(3.0);
    budget.discretisation = discretisation_error(force, loop.displacement, touch);
    const double drift = std::isnan(budget.drift) ? 0.0 : budget.drift;
    const double normal = std::hypot(std::hypot(budget.noise, drift), budget.discretisation);
    budget.total = std::hypot(normal, budget.sampling);
    if (budget.total > 0.0) result.half_width = half_width(normal, limits);
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
