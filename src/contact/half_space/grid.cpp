// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/grid.hpp"

#include <cmath>
#include <numeric>

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
    require_shape(map, grid, parallel::Slab(grid.nx), what);
}

void require_shape(const ArrayView2D& map, const Grid& grid, const parallel::Slab& slab, const char* what) {
    const bool differs = map.rows() != slab.rows() || map.cols() != grid.ny;
    if (!slab.anywhere(differs)) return;
    if (slab.in_one_process())
        throw InvalidArgument(fmt::format("{} have {} x {} points, but the grid has {} x {}", what, map.rows(),
                                          map.cols(), grid.nx, grid.ny));
    throw InvalidArgument(fmt::format("{} have {} x {} points here, but this process has rows {} to {} of {} x {}{}",
                                      what, map.rows(), map.cols(), slab.first(), slab.first() + slab.rows() - 1,
                                      grid.nx, grid.ny, differs ? "" : "; those of another process do not fit"));
}

parallel::Slab slab_of(const Grid& grid, const parallel::Ranks* ranks) {
    require(grid);
    // rows begin on the same places of vector registers in every process, or sums over them would round otherwise
    constexpr Index numbers = EIGEN_MAX_ALIGN_BYTES / sizeof(float);
    const Index columns = parallel::coarsest_side_of(grid.ny, coarsest_side);
    return parallel::nested_slab(grid.nx, coarsest_side, numbers / std::gcd(numbers, columns), ranks);
}

}  // namespace setae::half_space
