// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::imaging {

/// The closed path k(j), one column a row of `gain` (N, K), with the largest sum of gain(j, k(j)) − cost |k(j + 1) −
/// k(j)|, where neighbours differ by at most `most`. Found over three rounds of the rows, of which the middle one is
/// taken: the path closes where one round forgets where it began.
[[nodiscard]] std::vector<Index> closed_path(const Array2D& gain, double cost, Index most);

}  // namespace setae::imaging
