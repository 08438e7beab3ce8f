// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Undefined points first … first + count − 1 of row i.
struct Run {
    Index i;
    Index first;
    Index count;
};

/// Undefined points joined through neighbours along x and y: runs in the order of rows.
struct Patch {
    std::vector<Run> runs;
    Index points = 0;
};

/// All patches of a map, in the order of their first runs; periodic maps wrap. Memory: the runs.
[[nodiscard]] std::vector<Patch> undefined_patches(const ArrayView2D& heights, bool periodic);

}  // namespace setae::processing
