// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "setae/contact/relaxation.hpp"
#include "setae/core/table.hpp"
#include "setae/hysteresis/moving_edge.hpp"

namespace setae::hysteresis {

/// The loop as a curve: displacement δ [m], force [N], contact_radius [m], branch (0 approach, 1 retraction), in the
/// order of time, with `points` per branch and jumps as vertical lines at fixed displacement of the motor. The enclosed
/// area tends to energy_loss() as the number of points increases.
/// edge: a rate-dependent edge.
/// @throws InvalidArgument as sphere_loop() and edge_retraction(), and for fewer than 8 points.
[[nodiscard]] Table loop_course(const HystereticSphere& sphere, const Pressing& pressing,
                                const std::optional<MovingEdge>& edge = {}, int points = 200);

/// Speeds of the motor, and hold time at the turning point.
struct Drive {
    double approach_speed = 0.0, retraction_speed = 0.0;  ///< [m/s], > 0
    double hold_time = 0.0;                               ///< [s], >= 0
};

/// The loop in time, including the section with a pinned edge. The jump out takes no time: the history ends before it.
/// @throws InvalidArgument as loop_course(), and for speeds and times outside their domains.
[[nodiscard]] contact::ContactHistory contact_history(const HystereticSphere& sphere, const Pressing& pressing,
                                                      const Drive& drive, const std::optional<MovingEdge>& edge = {},
                                                      int points = 200);

}  // namespace setae::hysteresis
