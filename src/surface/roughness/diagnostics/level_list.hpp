// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "evidence.hpp"

namespace setae::diagnostics {

/// A height and its number of points.
struct Level {
    double height;
    Index count;
};

/// All heights of a map in increasing order, those that differ by less than a billionth of their range as one.
///
/// Cost: linear for few different values, as from a digitiser; n log n with a copy of all heights if the number of
/// values exceeds a sixteenth of the number of points.
[[nodiscard]] std::vector<Level> all_levels(const Evidence& evidence);

/// The outermost levels at both ends, in increasing order, at least `needed` of each if they exist. If there are many
/// heights only those near the ends are sorted.
struct EndLevels {
    std::vector<Level> lowest, highest;
};
[[nodiscard]] EndLevels end_levels(const Evidence& evidence, std::size_t needed, parallel::Threads threads);

}  // namespace setae::diagnostics
