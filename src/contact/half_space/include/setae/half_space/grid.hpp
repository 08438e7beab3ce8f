// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/parallel/slab.hpp"

namespace setae::half_space {

/// Points and widths of a map of pressures, displacements or heights, shape (nx, ny): x_i = i size_x/nx. One of nx and
/// ny may be 1: a line contact, independent of that coordinate, with the width along it as its length.
struct Grid {
    Index nx = 0, ny = 0;               ///< >= 1
    double size_x = 0.0, size_y = 0.0;  ///< [m], > 0

    [[nodiscard]] Index points() const { return nx * ny; }
    [[nodiscard]] double pixel_x() const { return size_x / static_cast<double>(nx); }
    [[nodiscard]] double pixel_y() const { return size_y / static_cast<double>(ny); }
    [[nodiscard]] double pixel_area() const { return pixel_x() * pixel_y(); }
    [[nodiscard]] double area() const { return size_x * size_y; }

    friend bool operator==(const Grid&, const Grid&) = default;
};

/// Smallest number of rows of coarsened maps.
inline constexpr Index coarsest_side = 64;

/// Rows of a map for each of the processes that solve it together; `ranks`: nullptr for one process.
/// @throws as parallel::nested_slab.
[[nodiscard]] parallel::Slab slab_of(const Grid& grid, const parallel::Ranks* ranks);

/// Refuses a grid outside its domain. @throws InvalidArgument.
void require(const Grid& grid);

/// Refuses a map of another shape than the grid's; `what` names it. @throws InvalidArgument.
void require_shape(const ArrayView2D& map, const Grid& grid, const char* what);
/// The check for the rows of this process.
void require_shape(const ArrayView2D& map, const Grid& grid, const parallel::Slab& slab, const char* what);

}  // namespace setae::half_space
