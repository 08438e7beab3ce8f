// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/core/arrays.hpp"

namespace setae::topography {

/// The first height that is defined, row by row: an origin about which sums lose no digits to an offset. Nothing where
/// none is.
[[nodiscard]] std::optional<double> first_defined(const ArrayView2D& heights);

}  // namespace setae::topography
