// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "setae/core/arrays.hpp"
#include "setae/core/units.hpp"

namespace setae::imaging {

/// An edge as its distance from a centre at equal angles from x towards y [px].
struct TracedEdge {
    const Array1D& radius;
    double centre_x = 0, centre_y = 0;

    /// Distance of a place from the edge along its ray, from the nearest ray of the edge; negative inside [px].
    [[nodiscard]] double distance(double x, double y) const {
        const double dx = x - centre_x, dy = y - centre_y, a_radian = static_cast<double>(radius.size()) / (2.0 * pi);
        const auto ray = (std::lround(std::atan2(dy, dx) * a_radian) + radius.size()) % radius.size();
        return std::hypot(dx, dy) - radius[ray];
    }
};

}  // namespace setae::imaging
