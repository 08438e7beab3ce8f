// SPDX-License-Identifier: GPL-3.0-or-later
#include "floored_least_squares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setae::adhesion {
namespace {

bool is_active(const FlooredTerm& term, double x) { return !term.floored || term.slope * x > term.offset; }

double cost_at(const std::vector<FlooredTerm>& terms, double x) {
    double cost = 0.0;
    for (const auto& term : terms) {
        const double residual = term.measured - (is_active(term, x) ? term.slope * x - term.offset : 0.0);
        cost += term.weight * residual * residual;
    }
    return cost;
}

/// Minimum of the parabola that holds between two neighbouring kinks, clipped to them.
double candidate(const std::vector<FlooredTerm>& terms, double from, double to) {
    const double inside = to < std::numeric_limits<double>::infinity() ? 0.5 * (from + to) : from + 1.0;
    double numerator = 0.0, denominator = 0.0;
    for (const auto& term : terms) {
        if (!is_active(term, inside)) continue;
        numerator += term.weight * term.slope * (term.measured + term.offset);
        denominator += term.weight * term.slope * term.slope;
    }
    return denominator > 0.0 ? std::clamp(numerator / denominator, from, to) : from;
}

}  // namespace

FlooredMinimum floored_minimum(const std::vector<FlooredTerm>& terms, double lower, double upper) {
    std::vector<double> kinks;
    for (const auto& term : terms) {
        const double kink = term.offset / term.slope;
        if (term.floored && kink > lower && kink < upper) kinks.push_back(kink);
    }
    std::sort(kinks.begin(), kinks.end());
    // an open lower end: everything below the first kink is flat or one parabola; a distant point represents it
    if (lower == -std::numeric_limits<double>::infinity()) {
        double reach = kinks.empty() ? 0.0 : kinks.front();
        for (const auto& term : terms)
            reach = std::min(reach, -2.0 * (std::abs(term.measured) + std::abs(term.offset)) / term.slope);
        lower = reach;
    }
    kinks.insert(kinks.begin(), lower);
    kinks.push_back(upper);
    FlooredMinimum best{lower, std::numeric_limits<double>::infinity(), 0.0};
    for (std::size_t i = 0; i + 1 < kinks.size(); ++i) {
        const double x = candidate(terms, kinks[i], kinks[i + 1]);
        const double cost = cost_at(terms, x);
        if (cost < best.cost) best = {x, cost, 0.0};
    }
    for (const auto& term : terms)
        if (is_active(term, best.x)) best.curvature += term.weight * term.slope * term.slope;
    return best;
}

}  // namespace setae::adhesion
