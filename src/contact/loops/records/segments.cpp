// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/segments.hpp"
#include "setae/core/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "baseline.hpp"
#include "channel_fault_search.hpp"
#include "channel_noise.hpp"
#include "contact_edges.hpp"
#include "force_zero.hpp"
#include "free_flight_steps.hpp"
#include "jump.hpp"
#include "record.hpp"
#include "setae/core/errors.hpp"
#include "turning_points.hpp"

namespace setae::loops {
namespace {

Index index_of_smallest(const Array1D& values, Index first, Index last) {
    Index at = 0;
    values.segment(first, last - first + 1).minCoeff(&at);
    return first + at;
}

/// The reversals of one contact: trough, peak, trough … ; the last trough is missing without an unloading.
struct Touch {
    std::vector<Index> troughs;
    std::vector<Index> peaks;
    Index end = 0;  ///< last sample before the next contact's first trough
};

/// Removes reversals of force with which the position does not turn: slips, not releases.
void drop_slips(const Record& record, Touch& touch) {
    for (std::size_t k = 0; k + 1 < touch.peaks.size();) {
        const Index peak = touch.peaks[k], trough = touch.troughs[k + 1], next = touch.peaks[k + 1];
        const bool released = record.position(trough) < record.position(peak);
        const bool pressed_again = record.position(next) > record.position(trough);
        if (released && pressed_again) {
            ++k;
            continue;
        }
        touch.troughs.erase(touch.troughs.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        const std::size_t lower = record.force[peak] < record.force[next] ? k : k + 1;
        touch.peaks.erase(touch.peaks.begin() + static_cast<std::ptrdiff_t>(lower));
    }
}

/// Removes a last rise of the force during separation: under fixed grips a contact continues beyond its smallest force,
/// and the record may end there.
void drop_rise_before_separation(const Record& record, Touch& touch) {
    if (touch.peaks.size() < 2 || touch.troughs.size() != touch.peaks.size()) return;
    if (record.position(touch.peaks.back()) < record.position(touch.troughs.back())) touch.peaks.pop_back();
}

std::vector<Touch> find_touches(const Record& record) {
    std::vector<Touch> touches(1);
    Index free_from = 0;
    for (const TurningPoint& point : turning_points(record.force, record.turning)) {
        Touch& touch = touches.back();
        if (point.peak && record.is_free(point.index)) {
            free_from = point.index;
            touch.end = point.index;
            if (!touch.peaks.empty()) touches.emplace_back();
            else touch = {};  // a trough that no peak follows
        } else if (point.peak) {
            if (touch.troughs.empty()) touch.troughs.push_back(index_of_smallest(record.force, free_from, point.index));
            touch.peaks.push_back(point.index);
        } else if (touch.peaks.empty() ||
                   record.force[touch.peaks.back()] - record.force[point.index] >= record.turning) {
            touch.troughs.push_back(point.index);
        }
    }
    if (touches.back().peaks.empty()) touches.pop_back();
    else touches.back().end = record.size() - 1;
    for (Touch& touch : touches) {
        drop_rise_before_separation(record, touch);
        drop_slips(record, touch);
    }
    return touches;
}

/// First sample of contact on the way to the peak, and the jump that led there.
void find_approach(const Record& record, Index start, const Touch& touch, ContactSegments& contact) {
    const Index trough = touch.troughs.front(), peak = touch.peaks.front();
    Index first = trough;
    if (record.force[trough] < -record.feature) {
        Index free = trough;
        while (free > start && record.force[free] < -record.feature) --free;
        if (record.force[free] >= -record.feature) contact.jump_in = {.first = free, .last = trough};
    } else if (!record.has_radius()) {
        first = peak;
        while (first > start && record.force[first - 1] > record.feature) --first;
    }
    if (record.has_radius())
        while (first < peak && !(record.loop.contact_radius[first] > 0.0)) ++first;
    contact.loading.first = first;
}

/// End of the contact: pull-off minimum and first free sample, or the last sample in contact.
void find_separation(const Record& record, const Touch& touch, ContactSegments& contact) {
    if (touch.troughs.size() <= touch.peaks.size()) return;
    const Index peak = touch.peaks.back();
    Index last = touch.troughs.back();
    const bool pulled = record.force[last] < -record.feature;
    if (!pulled) {  // no adhesion to mark the end: the first sample of free flight does
        last = peak;
        while (last < touch.end && !record.is_free(last + 1)) ++last;
    }
    Index free = last;
    while (free < touch.end && !record.is_free(free)) ++free;
    if (record.has_radius())
        while (last > peak && !(record.loop.contact_radius[last] > 0.0)) --last;
    const bool parts = pulled && record.is_free(free) && free > last;
    if (parts) {
        const Index before_jump = largest_step(record.level, {.first = last, .last = free});
        last = smallest_force(record.level, {.first = peak, .last = before_jump}, record.noise).sample;
        contact.pull_off = {.first = last, .last = free};
    }
    contact.unloading = {.first = peak, .last = last};
}

/// The stretch around the largest force in which it hardly changes, if it is longer than a turn takes.
std::optional<IndexRange> find_hold(const Record& record, const ContactSegments& contact) {
    constexpr double level_share = 0.02;
    constexpr double turns = 2.0;
    const Index peak = contact.loading.last;
    const double level = record.force[peak] - std::max(level_share * record.range, record.feature);
    IndexRange hold{.first = peak, .last = peak};
    while (hold.first > contact.loading.first && record.force[hold.first - 1] >= level) --hold.first;
    while (hold.last + 1 < record.size() && record.force[hold.last + 1] >= level) ++hold.last;
    const double steps = static_cast<double>(std::max<Index>(contact.loading.count() - 1, 1));
    const double per_sample = (record.force[peak] - record.force[contact.loading.first]) / steps;
    const double turn = 2.0 * (record.force[peak] - level) / per_sample;
    if (static_cast<double>(hold.count()) < turns * std::max(turn, 1.0)) return std::nullopt;
    return hold;
}

ContactSegments describe(const Record& record, Index start, const Touch& touch) {
    ContactSegments contact{.extent = {.first = start, .last = touch.end}};
    find_approach(record, start, touch, contact);
    const auto highest = std::max_element(touch.peaks.begin(), touch.peaks.end(),
                                          [&](Index i, Index j) { return record.force[i] < record.force[j]; });
    contact.loading.last = *highest;
    find_separation(record, touch, contact);
    contact.hold = find_hold(record, contact);
    return contact;
}

void add_cycles(const Touch& touch, Index contact_index, Segments& segments) {
    ContactSegments& contact = segments.contacts.back();
    for (std::size_t k = 0; k < touch.peaks.size(); ++k) {
        const bool last = k + 1 == touch.peaks.size();
        if (last && !contact.unloading) return;
        Cycle cycle{
            .loading = {.first = k == 0 ? contact.loading.first : touch.troughs[k], .last = touch.peaks[k]},
            .unloading = {.first = touch.peaks[k], .last = last ? contact.unloading->last : touch.troughs[k + 1]},
            .contact = contact_index,
            .ends_in_pull_off = last && contact.pull_off.has_value()};
        contact.cycles.push_back(static_cast<Index>(segments.cycles.size()));
        segments.cycles.push_back(cycle);
    }
}

/// A press of some samples, in which the force rises with the displacement.
void require_press(const Record& record, const ContactSegments& contact) {
    constexpr Index fewest = 4;
    if (contact.loading.count() < fewest)
        throw UndefinedDataError(
            fmt::format("the largest force, at sample {}, comes {} samples after first contact, which is too short for "
                        "a loading branch; check the sign of the force",
                        contact.loading.last, contact.loading.count() - 1));
    if (!record.has_displacement()) return;
    const auto force = record.force.segment(contact.loading.first, contact.loading.count());
    const auto position = record.loop.displacement.segment(contact.loading.first, contact.loading.count());
    if (((force - force.mean()) * (position - position.mean())).sum() > 0.0) return;
    throw UndefinedDataError(
        fmt::format("between samples {} and {} the force rises while the displacement does not, which is no "
                    "contact: the sensor drifts, or a sign is wrong; check the signs of force and displacement",
                    contact.loading.first, contact.loading.last));
}

/// Without a measured radius, adhesion distinguishes contact from drift.
void require_adhesion(const Record& record, const Segments& segments) {
    if (record.has_radius()) return;
    for (const ContactSegments& contact : segments.contacts)
        if (contact.jump_in || contact.pull_off) return;
    throw UndefinedDataError(
        fmt::format("the record shows no adhesive contact: the force never falls below the baseline by more than {} "
                    "before or after its maximum, as it does at jump-in and pull-off; give the contact radius if "
                    "adhesion is too weak to be seen",
                    format_value(record.feature, "N", 3)));
}

/// Why a record without free flight is not analysed.
[[noreturn]] void refuse(const Loop& loop, const ContactEdges& edges) {
    if (edges.found)
        throw UndefinedDataError(
            "the record shows no contact: it has no free flight and no jump of the force into or out of "
            "contact, or it begins and ends in contact; record free flight before or after contact, or give "
            "the zero of force (force_zero)");
    constexpr double range_of_noise = 12.0;  // in standard deviations, beyond the range of noise
    const double range = loop.force.maxCoeff() - loop.force.minCoeff(), noise = record_noise(loop.force);
    if (range <= range_of_noise * noise)
        throw UndefinedDataError(
            fmt::format("the force never exceeds its noise (range {}, noise {}); the record contains no contact",
                        format_value(range, "N", 3), format_value(noise, "N", 3)));
    throw UndefinedDataError(
        "the record shows no contact: nowhere between free flight before and after it does the force "
        "rise with the displacement; check the signs of force and displacement, and which columns they "
        "are");
}

/// Contact and free flight of the record. @throws ChannelFaultError unless the user has given the free flight.
ContactEdges edges_of(const Loop& loop, bool said) {
    ContactEdges edges;
    if (loop.displacement.size() > 0) edges = find_contact_edges(loop);
    if (loop.displacement.size() > 0 && !edges.found && !said)
        if (const auto fault = channel_fault(loop)) throw ChannelFaultError(*fault);
    if (loop.contact_radius.size() == 0) return edges;
    const ContactEdges seen = contact_edges_of_frames(loop);
    if (!edges.found || !seen.found) return seen;
    // the frames give the samples in contact, the force the frames between which it began
    if (edges.before && seen.before) edges.before->last = std::min(edges.before->last, seen.before->last);
    else edges.before = seen.before;
    if (edges.after && seen.after) edges.after->first = std::max(edges.after->first, seen.after->first);
    else edges.after = seen.after;
    return edges;
}

/// Free flight after contact from where the sensor has settled.
IndexRange settled(IndexRange after) {
    constexpr Index fewest = 5;
    const Index left_out = std::min(1 + after.count() / 10, after.count() - fewest);
    return {after.first + std::max<Index>(left_out, 0), after.last};
}

/// Noise of a record whose zero of force is given.
Baseline baseline_with_zero(const Loop& loop, double force) {
    Baseline baseline{.force = force, .force_noise = record_noise(loop.force)};
    if (loop.displacement.size() > 0) baseline.displacement_noise = record_noise(loop.displacement);
    return baseline;
}

/// The given share of the record, from its start, that is free flight.
IndexRange share_of(const Loop& loop, double share, const ContactEdges& edges) {
    if (!(share > 0.0 && share < 1.0))
        throw InvalidArgument(fmt::format("baseline_share must lie in (0, 1), got {}", share));
    constexpr Index fewest = 5;
    const auto count = static_cast<Index>(share * static_cast<double>(loop.force.size()));
    const IndexRange range{0, std::max(count, fewest) - 1};
    const Index free = edges.before ? edges.before->count() : 0;
    if (edges.found && range.count() > free)
        throw UndefinedDataError(
            fmt::format("the first {} samples are not free flight: contact begins after sample {}; reduce the "
                        "baseline share or leave it out",
                        range.count(), free));
    return range;
}

/// Baselines before and after contact, and no more.
Segments find_free_flight(const Loop& loop, const SegmentOptions& options) {
    Segments segments;
    if (options.force_baseline) {
        segments.before = baseline_with_zero(loop, *options.force_baseline);
        return segments;
    }
    const SegmentEdits& edits = options.edits;
    const ContactEdges edges = edges_of(loop, edits.baseline_before || edits.baseline_after);
    if (edits.baseline_before) segments.before = given_baseline(loop, *edits.baseline_before, "baseline");
    else if (options.baseline_share)
        segments.before = baseline_over(loop, share_of(loop, *options.baseline_share, edges));
    else if (edges.before)
        segments.before = baseline_over(loop, cut_at_steps(loop, *edges.before, true, segments.steps));
    if (edges.after)
        segments.after = baseline_over(loop, cut_at_steps(loop, settled(*edges.after), false, segments.steps));
    else if (edits.baseline_after) segments.after = given_baseline(loop, *edits.baseline_after, "baseline_after");
    if (segments.before.range) return segments;
    if (segments.after) {
        segments.before = *segments.after;
        segments.before.range.reset();
        return segments;
    }
    if (loop.contact_radius.size() == 0) refuse(loop, edges);
    segments.before = baseline_with_zero(loop, 0.0);  // recorded in contact only: the zero of force is taken as given
    return segments;
}

}  // namespace

Segments find_segments(const Loop& loop, const SegmentOptions& options) {
    require_valid(loop);
    if (!(loop.force.maxCoeff() > loop.force.minCoeff()))
        throw UndefinedDataError("the force is constant; the record contains no contact");
    Segments segments = find_free_flight(loop, options);
    const Array1D level = loop.force - force_zero(loop, segments, options.drift).value;
    const Record record = make_record(loop, level, segments, options);
    const std::vector<Touch> touches = find_touches(record);
    if (touches.empty())
        throw UndefinedDataError(
            "the record shows no contact: the force has no maximum above its zero, or the contact radius is "
            "never > 0");
    Index start = 0;
    for (const Touch& touch : touches) {
        segments.contacts.push_back(describe(record, start, touch));
        require_press(record, segments.contacts.back());
        add_cycles(touch, static_cast<Index>(segments.contacts.size()) - 1, segments);
        start = touch.end + 1;
    }
    require_adhesion(record, segments);
    return apply(options.edits, std::move(segments), loop);
}

}  // namespace setae::loops
