// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::loops {

/// A reversal of a series.
struct TurningPoint {
    Index index = 0;
    bool peak = false;
};

/// Alternating troughs and peaks with a height of at least `height`, in order; the first and the last need that height
/// on their inner side only.
[[nodiscard]] std::vector<TurningPoint> turning_points(const ArrayView1D& series, double height);

}  // namespace setae::loops
