// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::synthesis {

topography::HeightMap cut(const topography::HeightMap& map, Index x0, Index y0, Index nx, Index ny) {
    const auto [points_x, points_y] = map.shape();
    if (nx < 2 || ny < 2 || nx > points_x || ny > points_y)
        throw InvalidArgument(
            fmt::format("a window of {} x {} points of a surface of {} x {}; expected at least 2 x 2 and no more than "
                        "the surface has",
                        nx, ny, points_x, points_y));
    const bool inside = x0 >= 0 && y0 >= 0 && x0 + nx <= points_x && y0 + ny <= points_y;
    if (!inside && !map.periodic)
        throw InvalidArgument(
            fmt::format("a window of {} x {} points that starts at ({}, {}) extends beyond the surface of {} x {} "
                        "points, which is not periodic; move the window inside",
                        nx, ny, x0, y0, points_x, points_y));
    const auto wrapped = [](Index i, Index n) { return (i % n + n) % n; };
    const auto pixel = map.pixel_size();
    topography::HeightMap window{.heights = Array2D(nx, ny),
                                 .size = {static_cast<double>(nx) * pixel[0], static_cast<double>(ny) * pixel[1]},
                                 .periodic = false,
                                 .metadata = map.metadata};
    const Index first = wrapped(y0, points_y), straight = std::min(ny, points_y - first);
    for (Index i = 0; i < nx; ++i) {
        const auto row = map.heights.row(wrapped(x0 + i, points_x));
        window.heights.row(i).head(straight) = row.segment(first, straight);
        window.heights.row(i).tail(ny - straight) = row.head(ny - straight);
    }
    return window;
}

}  // namespace setae::synthesis
