// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <utility>

#include <boost/math/tools/toms748_solve.hpp>

namespace setae::numerics {

/// Root of a continuous function between lower < upper, whose values there are known and differ in sign, to so many
/// bits. Source: Alefeld, Potra, Shi, ACM TOMS 748 (1995).
template <class Function>
[[nodiscard]] double bracketed_root(Function&& function, double lower, double upper, double at_lower, double at_upper,
                                    int bits) {
    std::uintmax_t rounds = 200;
    const auto root = boost::math::tools::toms748_solve(function, lower, upper, at_lower, at_upper,
                                                        boost::math::tools::eps_tolerance<double>(bits), rounds);
    return 0.5 * (root.first + root.second);
}

/// Root between two points in either order; one of the points may be the root.
template <class Function>
[[nodiscard]] double bracketed_root(Function&& function, double lower, double upper, int bits = 52) {
    if (lower > upper) std::swap(lower, upper);
    const double at_lower = function(lower);
    const double at_upper = function(upper);
    if (at_lower == 0.0) return lower;
    if (at_upper == 0.0) return upper;
    return bracketed_root(function, lower, upper, at_lower, at_upper, bits);
}

/// Limit of a statement that is true at `inside` and false at `outside`: both ends of the interval after so many
/// halvings, or when no number is between them.
template <class Statement>
[[nodiscard]] std::pair<double, double> bisected(Statement&& holds, double inside, double outside,
                                                 int halvings = std::numeric_limits<int>::max()) {
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (inside + outside);
        if (middle == inside || middle == outside) break;
        (holds(middle) ? inside : outside) = middle;
    }
    return {inside, outside};
}

/// Minimum of a function with one minimum between two points, by golden sections, to 0.618^rounds of their distance.
template <class Function>
[[nodiscard]] double golden_section(Function&& function, double lower, double upper, int rounds) {
    constexpr double golden = 0.6180339887498949;
    double a = upper - golden * (upper - lower), b = lower + golden * (upper - lower);
    double at_a = function(a), at_b = function(b);
    for (int k = 0; k < rounds; ++k) {
        if (at_a < at_b) {
            upper = b;
            b = a;
            at_b = at_a;
            a = upper - golden * (upper - lower);
            at_a = function(a);
        } else {
            lower = a;
            a = b;
            at_a = at_b;
            b = lower + golden * (upper - lower);
            at_b = function(b);
        }
    }
    return at_a < at_b ? a : b;
}

}  // namespace setae::numerics
