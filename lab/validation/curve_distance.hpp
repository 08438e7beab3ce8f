// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/simulation/micrograph.hpp"

namespace setae::validation {

/// Nearest point of a curve.
struct NearestPlace {
    double distance = 0.0;  ///< positive on the left of the direction of the curve in the picture
    Index segment = 0;      ///< between the points segment and segment + 1
    double x = 0.0, y = 0.0;
};

/// Nearest positions of points on a curve, found in squares of a few pixels.
class CurveIndex {
public:
    explicit CurveIndex(const simulation::PixelCurve& curve);

    [[nodiscard]] NearestPlace nearest(double x, double y) const;

private:
    simulation::PixelCurve curve_;
    double left_ = 0.0, top_ = 0.0;
    long columns_ = 0, rows_ = 0;
    std::vector<std::vector<Index>> segments_;
};

/// Length along a curve up to each of its points.
[[nodiscard]] Array1D length_along(const simulation::PixelCurve& curve);

}  // namespace setae::validation
