// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/grid.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::half_space {

void require(const Grid& grid) {
    if (grid.nx < 1 || grid.ny < 1)
        throw InvalidArgument(fmt::format("a grid of {} x {} points; expected at least 1 x 1", grid.nx, grid.ny));
    const auto positive = [](double size) { return size > 0.0 && std::isfinite(size); };
    if (!positive(grid.size_x) || !positive(grid.size_y))
        throw InvalidArgument(
            fmt::format("a grid of {} m x {} m; expected widths > 0 and finite", grid.size_x, grid.size_y));
}

void require_shape(const ArrayView2D& map, const Grid& grid, const char* what) {
    if (map.rows() != grid.nx || map.cols() != grid.ny)
        throw InvalidArgument(fmt::format("{} have {} x {} points, the grid has {} x {}", what, map.rows(), map.cols(),
                                          grid.nx, grid.ny));
}

}  // namespace setae::half_space
