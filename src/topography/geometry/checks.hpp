// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/geometry/point_grid.hpp"
#include "setae/topography/mask.hpp"

namespace setae::geometry {

/// @throws InvalidArgument for a mask without points.
void require_points(const topography::Mask& mask);

/// @throws InvalidArgument for a pixel size that is not a positive length.
void require_pixels(const PointGrid& grid);

}  // namespace setae::geometry
