// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/geometry/point_grid.hpp"
#include "setae/topography/mask.hpp"

namespace setae::geometry {

/// Number of the patch each point belongs to, 1 … count; 0 where the point is not chosen. Shape of the mask.
using PatchNumbers = Eigen::Array<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The connected parts of a choice of points.
struct Patches {
    PatchNumbers numbers;  ///< in the order in which storage order (x, then y) first meets them
    std::int32_t count = 0;
    Neighbours neighbours = Neighbours::edges_and_corners;  ///< how they were found
    bool periodic = false;
};

/// Finds the patches of a mask; points that differ from 0 are chosen.
///
/// Union-find over the runs of chosen points along y, no recursion. Linear time; memory: the numbers and 8 bytes a run.
/// @throws InvalidArgument for a mask without points or with 2³¹ or more.
/// Source: Rosenfeld, Pfaltz, J. ACM 13 (1966) 471; Tarjan, J. ACM 22 (1975) 215.
[[nodiscard]] Patches patches(const topography::Mask& mask, Neighbours neighbours = Neighbours::edges_and_corners,
                              bool periodic = false);

/// What one patch is like.
struct PatchShape {
    Index points = 0;
    double area = 0.0;  ///< points · pixel area [m²]
    double centroid_x =
        0.0;  ///< mean position of its points, (i, j) at (i Δx, j Δy) [m]; of one that crosses the border of a
    double centroid_y = 0.0;  ///< periodic grid in one piece, then brought into 0 … size; NaN where it spans the period
    double edge_length = 0.0;   ///< of its edges towards points that are not chosen [m]: edge_length() of it alone
    bool spans_period = false;  ///< it meets its own periodic image: it is endless
};

/// Shapes of patch 1 … count. pixel_size: Δx, Δy [m]. One pass over the numbers; of periodic ones they are found once
/// more, cut at the borders.
/// @throws InvalidArgument for a pixel size that is not positive or numbers outside 0 … count.
[[nodiscard]] std::vector<PatchShape> patch_shapes(const Patches& patches,
                                                   std::array<double, 2> pixel_size = {1.0, 1.0});

}  // namespace setae::geometry
