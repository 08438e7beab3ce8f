// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"
#include "setae/topography/tiled_map.hpp"

namespace setae::topography {

/// Some scan lines of a map: h(x, first_line + j) is heights[x · distance + j].
struct HeightBand {
    const double* heights = nullptr;
    Index distance = 0;
    Index first_line = 0, lines = 0;
};

/// The heights of a map in bands of scan lines, a curve as one scan line. Referenced data must outlive this object.
struct HeightBands {
    Index nx = 0, ny = 0;
    std::size_t count = 0;
    /// body(number, band) for every band, on several threads if heights are in memory.
    std::function<void(const std::function<void(std::size_t, const HeightBand&)>& body)> for_each;
};

[[nodiscard]] HeightBands bands_of(const Measurement& measurement, parallel::Threads threads);
[[nodiscard]] HeightBands bands_of(const TiledMap& map);

}  // namespace setae::topography
