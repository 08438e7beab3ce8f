// SPDX-License-Identifier: GPL-3.0-or-later
#include "drift.hpp"

namespace setae::experiment {
namespace {

double middle(const IndexRange& range) { return 0.5 * static_cast<double>(range.first + range.last); }

}  // namespace

Array1D share_of_drift(const Loop& loop, const IndexRange& before, const IndexRange& after) {
    Array1D clock = Array1D::LinSpaced(loop.force.size(), 0.0, static_cast<double>(loop.force.size() - 1));
    double start = middle(before), end = middle(after);
    if (loop.time.size() > 0 && loop.time.allFinite() && loop.time[after.last] > loop.time[before.first]) {
        start = 0.5 * (loop.time[before.first] + loop.time[before.last]);
        end = 0.5 * (loop.time[after.first] + loop.time[after.last]);
        clock = loop.time;
    }
    return (clock - start) / (end - start);
}

Loop without_force_drift(const Loop& loop, const Segments& segments) {
    if (!segments.after || !segments.before.range) return loop;
    Loop level = loop;
    level.force -= share_of_drift(loop, *segments.before.range, *segments.after->range) *
                   (segments.after->force - segments.before.force);
    return level;
}

}  // namespace setae::experiment
