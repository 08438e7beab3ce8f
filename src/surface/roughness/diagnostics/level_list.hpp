// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "evidence.hpp"

namespace setae::diagnostics {

/// A height and how many points have it.
struct Level {
    double height;
    Index count;
};

/// All heights of a map in increasing order, those that differ by less than a billionth of their range as one.
///
/// Cost: linear for heights of few values, as a digitiser gives, and n log n with a copy of all where there are more
/// than a sixteenth as many values as points.
[[nodiscard]] std::vector<Level> all_levels(const Evidence& evidence);

/// The outermost levels at both ends, in increasing order, at least `needed` of each where there are so many. Of many
/// heights only those near the ends are sorted.
struct EndLevels {
    std::vector<Level> lowest, highest;
};
[[nodiscard]] EndLevels end_levels(const Evidence& evidence, std::size_t needed, parallel::Threads threads);

}  // namespace setae::diagnostics
