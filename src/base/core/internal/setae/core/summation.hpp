// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae {

/// Sum by recursive halving in a fixed order: rounding grows with log n, and the result does not depend on threads.
[[nodiscard]] double pairwise_sum(const ArrayView1D& values);

}  // namespace setae
