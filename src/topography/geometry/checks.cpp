// SPDX-License-Identifier: GPL-3.0-or-later
#include "checks.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::geometry {

void require_points(const topography::Mask& mask) {
    if (mask.size() == 0)
        throw InvalidArgument(fmt::format("mask of {} x {} points; expected at least one", mask.rows(), mask.cols()));
}

void require_pixels(const PointGrid& grid) {
    for (const double size : grid.pixel_size)
        if (!(size > 0.0 && std::isfinite(size)))
            throw InvalidArgument(
                fmt::format("pixels of {} x {} m; expected positive lengths", grid.pixel_size[0], grid.pixel_size[1]));
}

}  // namespace setae::geometry
