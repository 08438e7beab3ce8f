// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// A positive function by its values at nodes, to be joined by power laws.
struct RefinedCurve {
    Array1D nodes, values;
};

/// Tabulates a positive function from lower to upper: 20 nodes a decade, and intervals halved (in ln q) until the power
/// law between their ends is within the tolerance of the function at their middle: six times at most where the function
/// is smooth, and on where halving helps little, so that jumps and bends are met by nodes where they are. Where the
/// function is not positive the table ends, at the last q that is. Returns no node where the function is not positive
/// at lower.
[[nodiscard]] RefinedCurve refined_curve(const std::function<double(double)>& function, double lower, double upper,
                                         double tolerance);

}  // namespace setae::spectra
