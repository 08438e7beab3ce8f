// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::imaging {

/// The closed path k(j), one column per row of `gain` (N, K), with the largest sum of gain(j, k(j)) − cost |k(j + 1) −
/// k(j)|, where neighbours differ by at most `most`. It is found over three rounds of the rows; the middle one is used,
/// which is closed if one round is independent of its start.
[[nodiscard]] std::vector<Index> closed_path(const Array2D& gain, double cost, Index most);

}  // namespace setae::imaging
