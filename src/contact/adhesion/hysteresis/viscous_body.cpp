// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/viscous_body.hpp"

namespace setae::hysteresis {

std::optional<MovingEdge> ViscousBody::moving_edge(const Drive& drive, double reading_time) const {
    if (!edge) return std::nullopt;
    return MovingEdge{.law = *edge, .motor_speed = drive.retraction_speed, .reading_time = reading_time};
}

SphereLoop sphere_loop(const HystereticSphere& sphere, const Pressing& pressing, const Drive& drive,
                       const ViscousBody& body) {
    const auto edge = body.moving_edge(drive);
    auto loop = edge ? sphere_loop(sphere, pressing, *edge) : sphere_loop(sphere, pressing);
    if (!body.relaxation.empty())
        loop.bulk_loss = contact::relaxation_loss(contact_history(sphere, pressing, drive, edge), sphere.radius,
                                                  sphere.contact_modulus, body.relaxation);
    return loop;
}

}  // namespace setae::hysteresis
