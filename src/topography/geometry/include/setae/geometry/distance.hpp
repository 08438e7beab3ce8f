// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/geometry/patches.hpp"
#include "setae/geometry/point_grid.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/topography/mask.hpp"

namespace setae::geometry {

/// Distance [m] of every point to the nearest chosen one, 0 on chosen points; infinite where none is chosen.
///
///   d(i, j) = min over chosen (k, l) of √((i − k)² Δx² + (j − l)² Δy²);  periodic: the shorter way round in both
///   directions
///
/// Exact but for the rounding of the formula. Two passes, linear in the points whatever their choice.
/// @throws InvalidArgument for a mask without points or a pixel size that is not positive.
/// Source: Felzenszwalb, Huttenlocher, Theory of Computing 8 (2012) 415.
[[nodiscard]] Array2D distance_map(const topography::Mask& mask, const PointGrid& grid, parallel::Threads threads = {});

/// Number of the patch that lies closest to every point; of equally close ones any, the same for any number of threads;
/// 0 where there is no patch.
[[nodiscard]] PatchNumbers closest_patch_map(const Patches& patches, std::array<double, 2> pixel_size = {1.0, 1.0},
                                             parallel::Threads threads = {});

}  // namespace setae::geometry
