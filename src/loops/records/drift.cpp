// SPDX-License-Identifier: GPL-3.0-or-later
#include "drift.hpp"

#include "baseline.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

double middle(const Array1D& clock, const IndexRange& range) { return 0.5 * (clock[range.first] + clock[range.last]); }

}  // namespace

ForceZero force_zero(const Loop& loop, const Segments& segments, DriftModel drift) {
    const Baseline& before = segments.before;
    if (!before.range || drift == DriftModel::constant) return {};
    const Array1D clock = clock_of(loop);
    const double start = middle(clock, *before.range);
    if (drift == DriftModel::extrapolated)
        return {.share = clock - start,
                .change = before.force_slope,
                .change_standard_error = before.force_slope_standard_error};
    if (!segments.after || !segments.after->range) return {};
    return {.share = (clock - start) / (middle(clock, *segments.after->range) - start),
            .change = segments.after->force - before.force,
            .change_standard_error = segments.after->force_standard_error,
            .weight_lost = 1.0};
}

Loop without_force_drift(const Loop& loop, const Segments& segments, DriftModel drift) {
    const ForceZero zero = force_zero(loop, segments, drift);
    Loop level = loop;
    if (!zero.constant()) level.force -= zero.share * zero.change;
    return level;
}

Loop without_displacement_drift(const Loop& loop, double rate) {
    if (rate == 0.0 || loop.displacement.size() == 0) return loop;
    if (loop.time.size() != loop.force.size() || !loop.time.allFinite())
        throw InvalidArgument(
            "a drift of the displacement needs the time of every sample, which the record does not have");
    Loop level = loop;
    level.displacement -= rate * (loop.time - loop.time[0]);
    return level;
}

}  // namespace setae::loops
