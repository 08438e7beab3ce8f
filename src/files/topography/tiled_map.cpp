// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/tiled_map.hpp"

#include <algorithm>

namespace setae::topography {

TiledMap tiled(const HeightMap& map) {
    return {map.heights.rows(),
            map.heights.cols(),
            map.size,
            map.periodic,
            map.metadata,
            [&map](Index first, Index count) -> Array2D { return map.heights.middleCols(first, count); }};
}

Index lines_in(const TiledMap& map, std::size_t bytes) {
    const auto line = static_cast<std::size_t>(map.nx) * sizeof(double);
    return std::clamp<Index>(static_cast<Index>(bytes / std::max<std::size_t>(line, 1)), 1, map.ny);
}

}  // namespace setae::topography
