// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace setae::numerics {

struct Minimum {
    double place = 0.0, value = 0.0;
};

/// Minimum of a function with one minimum between lower < upper, its position to at most so many bits. It ends after
/// 200 evaluations: rounding can make the last bits unreachable.
/// @throws Cancelled if the caller requested a stop (parallel::CancellationScope).
/// Source: Brent, Algorithms for Minimization without Derivatives (1973), ch. 5, by Boost.
[[nodiscard]] Minimum minimum_between(const std::function<double(double)>& function, double lower, double upper,
                                      int bits);

}  // namespace setae::numerics
