// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

namespace setae::numerics {

/// Root of a continuous function between two points, in either order, where its signs differ (or it vanishes), to 52
/// bits. Source: Alefeld, Potra, Shi, ACM TOMS 748 (1995).
template <class Function>
[[nodiscard]] double bracketed_root(Function&& function, double lower, double upper) {
    if (lower > upper) std::swap(lower, upper);
    const double at_lower = function(lower);
    const double at_upper = function(upper);
    if (at_lower == 0.0) return lower;
    if (at_upper == 0.0) return upper;
    std::uintmax_t rounds = 200;
    const auto root = boost::math::tools::toms748_solve(function, lower, upper, at_lower, at_upper,
                                                        boost::math::tools::eps_tolerance<double>(52), rounds);
    return 0.5 * (root.first + root.second);
}

}  // namespace setae::numerics
