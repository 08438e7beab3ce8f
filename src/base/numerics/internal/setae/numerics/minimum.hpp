// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace setae::numerics {

struct Minimum {
    double place = 0.0, value = 0.0;
};

/// Smallest value of a function with one valley between lower < upper, its place to so many bits at most. It ends after
/// 200 values of the function, whatever these are: bits that rounding hides are not waited for.
/// @throws Cancelled where the caller asked to stop (parallel::CancellationScope).
/// Source: Brent, Algorithms for Minimization without Derivatives (1973), ch. 5, by Boost.
[[nodiscard]] Minimum minimum_between(const std::function<double(double)>& function, double lower, double upper,
                                      int bits);

}  // namespace setae::numerics
