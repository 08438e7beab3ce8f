// SPDX-License-Identifier: GPL-3.0-or-later
#include "turning_points.hpp"

namespace setae::loops {

std::vector<TurningPoint> turning_points(const ArrayView1D& series, double height) {
    std::vector<TurningPoint> points;
    Index lowest = 0, highest = 0;  // since the last confirmed reversal
    bool rising_wanted = true, falling_wanted = true;
    for (Index i = 0; i < series.size(); ++i) {
        if (series[i] < series[lowest]) lowest = i;
        if (series[i] > series[highest]) highest = i;
        if (rising_wanted && series[i] >= series[lowest] + height) {
            points.push_back({.index = lowest, .peak = false});
            highest = i;
            rising_wanted = false;
            falling_wanted = true;
        } else if (falling_wanted && series[i] <= series[highest] - height) {
            points.push_back({.index = highest, .peak = true});
            lowest = i;
            falling_wanted = false;
            rising_wanted = true;
        }
    }
    if (!points.empty())
        points.push_back({.index = points.back().peak ? lowest : highest, .peak = !points.back().peak});
    return points;
}

}  // namespace setae::loops
