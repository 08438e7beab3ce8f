// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <Eigen/Core>

namespace setae::topography {

/// A choice of a map's points: 1 = chosen, 0 = not; shape (nx, ny) of the map, first index x. Of a line shape (n, 1).
using Mask = Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace setae::topography
