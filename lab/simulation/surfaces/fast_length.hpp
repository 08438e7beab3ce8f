// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::simulation {

/// Smallest product of 2, 3 and 5 that is not below n: lengths that transform fast.
[[nodiscard]] Index fast_length(double n);

}  // namespace setae::simulation
