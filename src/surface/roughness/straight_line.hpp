// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

namespace setae::roughness {

/// The straight line through points: its slope, with the standard error from their scatter (NaN for two), and its value
/// at x = 0.
struct Line {
    double slope = 0.0, slope_error = 0.0, level = 0.0;
};

inline Line line_through(const std::vector<double>& x, const std::vector<double>& y) {
    const auto n = static_cast<double>(x.size());
    double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, squares = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - mean_x) * (x[i] - mean_x);
        xy += (x[i] - mean_x) * (y[i] - mean_y);
    }
    const double slope = xy / xx;
    for (std::size_t i = 0; i < x.size(); ++i) squares += std::pow(y[i] - mean_y - slope * (x[i] - mean_x), 2);
    return {slope, std::sqrt(squares / (n - 2.0) / xx), mean_y - slope * mean_x};
}

}  // namespace setae::roughness
