// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>

#include "setae/core/arrays.hpp"

namespace setae::formats {

/// Heights of points at the nodes of a regular grid, or why they form no grid.
struct PointGrid {
    Array2D heights;               ///< h(x, y), smallest x and y first; NaN if a node has no point
    std::array<double, 2> size{};  ///< n · step along x and y, in the unit of the positions
    std::string problem;           ///< empty for a grid

    [[nodiscard]] bool found() const { return problem.empty(); }
};

/// Minimum share of nodes with a point.
inline constexpr double min_filled = 0.1;

/// The regular grid of points x, y in any order: both spacings are constant within 2 % of a step (files round their
/// positions), each node has at most one point, at least `min_filled` of them have one, and there are as many points as
/// columns and rows together.
///
/// Cost: n log n.
[[nodiscard]] PointGrid grid_of(const Array1D& x, const Array1D& y, const Array1D& heights);

}  // namespace setae::formats
