// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "setae/core/arrays.hpp"

namespace setae::formats {

/// Heights of points on the nodes of a regular grid, or why they are on none.
struct PointGrid {
    Array2D heights;               ///< h(x, y), smallest x and y first; NaN where a node has no point
    std::array<double, 2> size{};  ///< n · step along x and y, in the unit of the positions
    std::string problem;           ///< empty for a grid

    [[nodiscard]] bool found() const { return problem.empty(); }
};

/// Least share of nodes that have a point.
inline constexpr double min_filled = 0.1;

/// The regular grid that points x, y, in any order, lie on: both spacings are constant within 2 % of a step (files
/// round their positions), each node has at most one point, at least `min_filled` of them have one, and there are as
/// many points as columns and rows together.
///
/// Cost: n log n.
[[nodiscard]] PointGrid grid_of(const Array1D& x, const Array1D& y, const Array1D& heights);

}  // namespace setae::formats
