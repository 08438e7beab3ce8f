// SPDX-License-Identifier: GPL-3.0-or-later
#include "free_flight_steps.hpp"

#include <cmath>

#include "steps.hpp"

namespace setae::loops {

IndexRange cut_at_steps(const Loop& loop, IndexRange range, bool before_contact, std::vector<ForceStep>& steps) {
    constexpr double visible = 1e-3;  // share of the range of the force
    const double least = visible * (loop.force.maxCoeff() - loop.force.minCoeff());
    while (const auto step = step_in(loop.force.segment(range.first, range.count()), {.degree = 1, .rivalling = 3})) {
        if (std::abs(step->size) < least) break;
        const Index last = range.first + step->last;
        steps.push_back({.sample = last, .size = step->size});
        if (before_contact) range.first = last + 1;
        else range.last = last;
    }
    return range;
}

}  // namespace setae::loops
