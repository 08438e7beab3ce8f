// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::topography {

/// A map that is read in bands of scan lines, so it may be larger than memory.
struct TiledMap {
    Index nx = 0, ny = 0;
    std::array<double, 2> size{};  ///< extent along x and y [m]: n · pixel size
    bool periodic = false;
    Metadata metadata;
    /// Heights h(x, first … first + count − 1) [m], shape (nx, count), NaN = undefined. Called from one thread at a
    /// time.
    std::function<Array2D(Index first, Index count)> lines;
    /// Warnings on changes to the heights of `lines`; may be empty.
    std::function<std::vector<Alert>()> alerts = {};

    [[nodiscard]] std::array<double, 2> pixel_size() const {
        return {size[0] / static_cast<double>(nx), size[1] / static_cast<double>(ny)};
    }
};

/// A map in memory, accessed in bands; `map` must outlive the result.
[[nodiscard]] TiledMap tiled(const HeightMap& map);

/// Scan lines per band of at most `bytes` of memory; at least 1 and at most ny.
[[nodiscard]] Index lines_in(const TiledMap& map, std::size_t bytes);

}  // namespace setae::topography
