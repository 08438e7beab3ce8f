// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace setae::adhesion {

/// A term weight · (measured − max(0, slope · x − offset))², or without the floor.
struct FlooredTerm {
    double measured = 0.0;
    double slope = 0.0;  ///< > 0
    double offset = 0.0;
    double weight = 1.0;
    bool floored = true;
};

struct FlooredMinimum {
    double x = 0.0;
    double cost = 0.0;
    double curvature = 0.0;  ///< Σ weight · slope² over the terms above their floor at x
};

/// Global minimum over lower <= x <= upper: between two kinks x = offset/slope the cost is one parabola, so the least
/// of their minima is the answer. Cost n log n + n².
[[nodiscard]] FlooredMinimum floored_minimum(const std::vector<FlooredTerm>& terms, double lower, double upper);

}  // namespace setae::adhesion
