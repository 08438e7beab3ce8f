// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::topography {

/// Points first … last whose x does not exceed the largest x before them.
struct BackwardRun {
    Index first = 0, last = 0;
    double depth = 0.0;  ///< distance below the largest x before [m], >= 0
};

/// Runs of a curve of defined points without progress in x; all other points have increasing x.
[[nodiscard]] inline std::vector<BackwardRun> backward_runs(const Array1D& x) {
    std::vector<BackwardRun> runs;
    Index front = 0;
    for (Index i = 1; i < x.size();) {
        if (x[i] > x[front]) {
            front = i++;
            continue;
        }
        BackwardRun run{i, i, 0.0};
        for (; i < x.size() && x[i] <= x[front]; ++i) run.depth = std::max(run.depth, x[front] - x[i]);
        run.last = i - 1;
        runs.push_back(run);
    }
    return runs;
}

}  // namespace setae::topography
