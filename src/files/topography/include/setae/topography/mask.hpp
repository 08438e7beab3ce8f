// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace setae::topography {

/// Selection of points of a map: 1 = selected, 0 = not; shape (nx, ny) of the map, first index x. Shape (n, 1) for a
/// line.
using Mask = Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace setae::topography
