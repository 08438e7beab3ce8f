// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace setae::geometry {

/// Where the points of a mask lie: (i, j) at (i Δx, j Δy).
struct PointGrid {
    std::array<double, 2> pixel_size{1.0, 1.0};  ///< Δx, Δy [m], > 0
    bool periodic = false;                       ///< whether the last point's neighbour is the first
};

/// Which points touch.
enum class Neighbours {
    edges,              ///< the 4 that share an edge
    edges_and_corners,  ///< the 8 that share an edge or a corner
};

}  // namespace setae::geometry
