// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/core/arrays.hpp"
#include "setae/topography/mask.hpp"

namespace setae::diagnostics {

/// Neighbourhood of points.
enum class Neighbours {
    edges,              ///< the 4 that share an edge
    edges_and_corners,  ///< the 8 that share an edge or a corner
};

/// Number of the patch of each point, 1 … count; 0 if the point is not selected. Shape of the mask.
using PatchNumbers = Eigen::Array<std::int32_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The connected parts of a selection of points.
struct Patches {
    PatchNumbers numbers;  ///< in storage order (x, then y) of their first points
    std::int32_t count = 0;
};

/// Finds the patches of a mask; points that differ from 0 are selected.
///
/// Union-find over the runs of selected points along y, without recursion. Linear time; memory: the numbers and 8 bytes
/// per run.
/// @throws InvalidArgument for a mask without points or with 2³¹ or more.
/// Source: Rosenfeld, Pfaltz, J. ACM 13 (1966) 471; Tarjan, J. ACM 22 (1975) 215.
[[nodiscard]] Patches patches(const topography::Mask& mask, Neighbours neighbours = Neighbours::edges_and_corners,
                              bool periodic = false);

}  // namespace setae::diagnostics
