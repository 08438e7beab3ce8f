// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "setae/core/arrays.hpp"

namespace setae::processing {

/// Position between two points of a grid direction.
struct GridPlace {
    Index lower;
    Index upper;      ///< lower + 1, wrapped; `lower` at the last point of a grid that is not periodic
    double fraction;  ///< fraction of the distance from lower to upper, 0 … 1
};

/// Empty outside [0, n − 1] of a grid that is not periodic, with a tolerance of 1e-9 of a step.
inline std::optional<GridPlace> grid_place(double steps, Index n, bool periodic) {
    constexpr double forgiven = 1e-9;
    if (!periodic) {
        if (!(steps >= -forgiven && steps <= static_cast<double>(n - 1) + forgiven)) return {};
        steps = std::min(std::max(steps, 0.0), static_cast<double>(n - 1));
    } else if (!std::isfinite(steps)) {
        return {};
    }
    const double floor = std::floor(steps);
    const double fraction = steps - floor;
    auto lower = static_cast<Index>(floor);
    if (periodic) lower = ((lower % n) + n) % n;
    Index upper = lower + 1;
    if (upper == n) upper = periodic ? 0 : lower;
    return GridPlace{lower, upper, fraction};
}

}  // namespace setae::processing
