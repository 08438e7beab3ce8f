// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/record_checks.hpp"

#include <algorithm>
#include <cmath>

#include "baseline.hpp"

namespace setae::loops {
namespace {

/// Runs of one value, at the extreme given and elsewhere.
struct Runs {
    std::vector<IndexRange> at_extreme;
    Index longest_elsewhere = 1;
};

Runs runs_at(const Array1D& force, double extreme, double other_extreme) {
    Runs runs;
    Index first = 0;
    for (Index i = 1; i <= force.size(); ++i) {
        if (i < force.size() && force[i] == force[first]) continue;
        const IndexRange run{.first = first, .last = i - 1};
        if (force[first] == extreme) runs.at_extreme.push_back(run);
        else if (force[first] != other_extreme) runs.longest_elsewhere = std::max(runs.longest_elsewhere, run.count());
        first = i;
    }
    return runs;
}

std::vector<IndexRange> saturated_at(const Array1D& force, double extreme, double other_extreme) {
    constexpr Index fewest = 5;
    constexpr Index times_usual = 2;  // a coarse converter repeats values everywhere
    Runs runs = runs_at(force, extreme, other_extreme);
    const Index least = std::max(fewest, times_usual * runs.longest_elsewhere + 1);
    std::erase_if(runs.at_extreme, [&](const IndexRange& run) { return run.count() < least; });
    return runs.at_extreme;
}

void find_gaps(const Array1D& radius, RecordFaults& faults) {
    std::vector<Index> frames;
    for (Index i = 0; i < radius.size(); ++i)
        if (radius[i] > 0.0) frames.push_back(i);
    constexpr std::size_t fewest = 5;
    if (frames.size() < fewest) return;
    Array1D steps(static_cast<Index>(frames.size()) - 1);
    for (Index k = 0; k < steps.size(); ++k)
        steps[k] = static_cast<double>(frames[static_cast<std::size_t>(k) + 1] - frames[static_cast<std::size_t>(k)]);
    const double usual = median_of(steps);
    faults.frames = static_cast<Index>(frames.size());
    for (Index k = 0; k < steps.size(); ++k) {
        const IndexRange gap{.first = frames[static_cast<std::size_t>(k)] + 1,
                             .last = frames[static_cast<std::size_t>(k) + 1] - 1};
        // between two contacts the radius is 0, not missing
        const bool measured = gap.count() > 0 && (radius.segment(gap.first, gap.count()) == 0.0).any();
        const Index missing = static_cast<Index>(std::lround(steps[k] / usual)) - 1;
        if (measured || missing < 1) continue;
        faults.frames += missing;
        faults.frames_missing += missing;
        if (!faults.longest_gap || gap.count() > faults.longest_gap->count()) faults.longest_gap = gap;
    }
}

}  // namespace

RecordFaults record_faults(const Loop& loop) {
    RecordFaults faults;
    if (loop.force.size() == 0) return faults;
    const double highest = loop.force.maxCoeff(), lowest = loop.force.minCoeff();
    if (highest > lowest) {
        faults.saturated_high = saturated_at(loop.force, highest, lowest);
        faults.saturated_low = saturated_at(loop.force, lowest, highest);
    }
    find_gaps(loop.contact_radius, faults);
    if (loop.time.size() > 1)
        for (Index i = 1; i < loop.time.size() && !faults.time_backwards; ++i)
            if (loop.time[i] < loop.time[i - 1]) faults.time_backwards = i;
    return faults;
}

}  // namespace setae::loops
