// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/arrays.hpp"

namespace setae::topography {

/// The first defined height, row by row: an origin for sums without loss of digits by an offset. Empty if there is
/// none.
[[nodiscard]] std::optional<double> first_defined(const ArrayView2D& heights);

}  // namespace setae::topography
