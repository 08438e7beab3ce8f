// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "plane_curve.hpp"
#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging {

/// Shortest paths along an edge.
///
/// The cost between neighbouring pixels is their distance over 0.02 + e, e: the gradient of the picture, smoothed by
/// 1.5 px, towards the left (vacuum; its sign is known), over the 99th percentile of all gradients, at most 1. Slopes
/// in the wrong direction are no edge. Source: Mortensen, Barrett, SIGGRAPH 1995 (intelligent scissors); Dijkstra 1959.
class LiveWire {
public:
    LiveWire(const FramePixels& pixels, Vacuum vacuum);

    /// The path of least cost through anchors, in their order or reversed, so that vacuum is on the left.
    [[nodiscard]] PlaneCurve through(const std::vector<Anchor>& anchors) const;

private:
    struct Path {
        std::vector<double> x, y;
        double cost = 0;
    };
    [[nodiscard]] Path between(const Anchor& from, const Anchor& to) const;
    [[nodiscard]] Path along(const std::vector<Anchor>& anchors) const;

    FramePixels rise_x_, rise_y_;  ///< of brightness, towards vacuum, in units of the strongest
};

}  // namespace setae::imaging
