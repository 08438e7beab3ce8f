// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "plane_curve.hpp"
#include "setae/imaging/contour_trace.hpp"

namespace setae::imaging {

/// Shortest paths along an edge.
///
/// From pixel to neighbour the way costs its length over 0.02 + e, e: the rise of the picture, smoothed by 1.5 px,
/// towards the left hand (towards vacuum: its sign is known), over the 99th percentile of all rises, at most 1: what is
/// steep in the wrong direction is no edge. Source: Mortensen, Barrett, SIGGRAPH 1995 (intelligent scissors); Dijkstra
/// 1959.
class LiveWire {
public:
    LiveWire(const FramePixels& pixels, Vacuum vacuum);

    /// The cheapest path through anchors, in their order or in the reverse one, whichever has vacuum on its left hand.
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
