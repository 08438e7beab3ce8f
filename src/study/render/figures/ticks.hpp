// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ranges.hpp"

namespace setae::figures {

inline constexpr double letters_mm = 1.45;  ///< mean width of a letter of small text

/// Direction of an axis: numbers are next to each other along x, above each other along y.
enum class Direction { along_x, along_y };

/// Numbers at a linear axis.
struct LinearTicks {
    double step = 1.0;           ///< 1, 2 or 5 times a power of ten
    std::vector<double> places;  ///< multiples of the step within the range
    std::vector<std::string> labels;
    std::size_t letters = 1;  ///< number of letters of the longest label
};

/// The largest number of ticks that fit; at least three where they fit closer together.
[[nodiscard]] LinearTicks linear_ticks(const Range& range, double length_mm, Direction direction);

/// gnuplot's settings of the ticks of an axis that is logarithmic or linear, and numbered.
///
/// name: 'x' or 'y'.
[[nodiscard]] std::string logarithmic_tick_lines(const Range& range, double length_mm, char name);
[[nodiscard]] std::string linear_tick_lines(const Range& range, double length_mm, char name);

}  // namespace setae::figures
