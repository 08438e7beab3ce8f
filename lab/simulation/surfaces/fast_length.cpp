// SPDX-License-Identifier: GPL-3.0-or-later
#include "fast_length.hpp"

#include <algorithm>
#include <cmath>

#include "setae/fourier/fast_length.hpp"

namespace setae::simulation {

Index fast_length(double n) { return fourier::fast_length(static_cast<Index>(std::ceil(std::max(n, 2.0)))); }

}  // namespace setae::simulation
