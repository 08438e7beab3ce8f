// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/processing/processed.hpp"
#include "setae/topography/mask.hpp"

namespace setae::processing {

/// Some neighbouring lines of a map, contiguous in memory.
struct LineBand {
    Index first = 0, count = 0, points = 0;
    std::vector<double> heights;
    std::vector<std::uint8_t> chosen;  ///< empty: all

    [[nodiscard]] double* line(Index number) { return heights.data() + (number - first) * points; }
    /// Whether a point of a line is used: defined and selected.
    [[nodiscard]] bool counts(Index number, Index point) const {
        const auto k = static_cast<std::size_t>((number - first) * points + point);
        return !std::isnan(heights[k]) && (chosen.empty() || chosen[k]);
    }
};

/// Number of lines along a direction, and of points on each.
[[nodiscard]] Index line_count(const Array2D& heights, Direction direction);
[[nodiscard]] Index points_on_line(const Array2D& heights, Direction direction);

/// body(band, first, last) for the lines of a map in bands of a few; a band begins `before` lines earlier if they
/// exist. `chosen` is empty for all points. With `write`, lines first … last − 1 of the band are written back.
void for_each_band(Array2D& heights, const topography::Mask& chosen, Direction direction, Index before, bool write,
                   parallel::Threads threads, const std::function<void(LineBand& band, Index first, Index last)>& body);

}  // namespace setae::processing
