// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "fill_patches.hpp"

namespace setae::processing {

/// Coupling of neighbours along x and y: 1/Δx², 1/Δy² up to a factor.
struct Couplings {
    double x = 1.0;
    double y = 1.0;
};

/// Position of a patch in its box: origin, size, and whether the box extends all around a periodic map.
struct PatchBox {
    std::array<Index, 2> origin{}, shape{};
    std::array<bool, 2> wraps{};
    /// Whether points beyond the lower and upper side of the box along x and y do not exist because the map ends there.
    std::array<std::array<bool, 2>, 2> ends{};
};

/// Points of a patch in the order of rows of its box.
struct PatchGraph {
    PatchBox box;
    std::vector<Run> runs;         ///< in coordinates of the box, sorted, not touching others of the same row
    std::vector<Index> run_first;  ///< number of the first point of a run
    Index points = 0;
    Index bandwidth = 0;  ///< largest difference of the numbers of neighbours
};

[[nodiscard]] PatchGraph patch_graph(const Patch& patch, std::array<Index, 2> map_shape, bool periodic);

/// Calls visit(a, b, along_x) for every pair of neighbours a < b.
void for_each_edge(const PatchGraph& graph, const std::function<void(Index a, Index b, bool along_x)>& visit);

/// Contribution of defined neighbours to the equations of the points of a patch, in its order.
struct PatchBoundary {
    Array1D leak_x, leak_y;  ///< sum of couplings to defined neighbours along x and y
    Array1D right;           ///< sum of couplings times (their heights − centre)
    double centre = 0.0;     ///< middle of their heights
    double range = 0.0;      ///< largest difference of their heights
};

[[nodiscard]] PatchBoundary patch_boundary(const PatchGraph& graph, const ArrayView2D& heights, bool periodic,
                                           const Couplings& couplings);

}  // namespace setae::processing
