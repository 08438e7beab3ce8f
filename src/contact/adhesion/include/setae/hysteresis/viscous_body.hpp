// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/contact/relaxation.hpp"
#include "setae/hysteresis/loop_course.hpp"

namespace setae::hysteresis {

/// What an elastomer does in time.
struct ViscousBody {
    std::optional<EdgeSpeed> edge;                    ///< an edge that minds its speed
    std::vector<contact::RelaxationTerm> relaxation;  ///< a bulk that relaxes

    /// The edge as this machine pulls it, where it minds.
    [[nodiscard]] std::optional<MovingEdge> moving_edge(const Drive& drive, double reading_time = 0.0) const;
};

/// The loop of sphere_loop() with everything that time does to it.
/// @throws as its parts; the drive is not looked at where the body does nothing in time.
[[nodiscard]] SphereLoop sphere_loop(const HystereticSphere& sphere, const Pressing& pressing, const Drive& drive,
                                     const ViscousBody& body);

}  // namespace setae::hysteresis
