// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// A positive function by its values at nodes, with power laws between.
struct RefinedCurve {
    Array1D nodes, values;
};

/// Tabulates a positive function from lower to upper: 20 nodes per decade; intervals are halved (in ln q) until the
/// power law between their ends agrees with the function at their middle within the tolerance: at most six times if the
/// function is smooth, and further if halving has little effect, so that jumps and bends have nodes at their positions.
/// The table ends at the last q with a positive function. It is empty if the function is not positive at lower.
[[nodiscard]] RefinedCurve refined_curve(const std::function<double(double)>& function, double lower, double upper,
                                         double tolerance);

}  // namespace setae::spectra
