// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/contact/relaxation.hpp"
#include "setae/hysteresis/loop_course.hpp"

namespace setae::hysteresis {

/// Time dependence of an elastomer.
struct ViscousBody {
    std::optional<EdgeSpeed> edge;                    ///< rate-dependent edge
    std::vector<contact::RelaxationTerm> relaxation;  ///< relaxing bulk

    /// The edge with the speeds of this testing machine, where it is rate-dependent.
    [[nodiscard]] std::optional<MovingEdge> moving_edge(const Drive& drive, double reading_time = 0.0) const;
};

/// The loop of sphere_loop() with all effects of time.
/// @throws as its parts; the drive is not used for a body without time dependence.
[[nodiscard]] SphereLoop sphere_loop(const HystereticSphere& sphere, const Pressing& pressing, const Drive& drive,
                                     const ViscousBody& body);

}  // namespace setae::hysteresis
