// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "setae/hysteresis/viscous_body.hpp"

/// Simulated measurements of bodies whose every property is known.
namespace setae::simulation {

/// What the machine does: its motor moves to and fro at constant speed, and pulls the sphere by a spring.
///
/// Motor position m = δ + F/k_m, 0 where the bodies first touch.
struct LoadingProtocol {
    double maximum_force = 1e-3;      ///< [N] at the turning point, > 0
    double approach_speed = 60e-9;    ///< of the motor [m/s], > 0
    double retraction_speed = 60e-9;  ///< of the motor [m/s], > 0
    double start_gap = 2e-6;          ///< free flight before first touch and after parting [m], > 0
    double hold_time = 0.0;           ///< at the turning point [s], >= 0
    double force_rate = 10.0;         ///< samples of force and displacement [1/s], > 0
    double camera_rate = 1.0;         ///< frames that show the contact radius [1/s], in (0, force_rate]
    double machine_stiffness = std::numeric_limits<double>::infinity();  ///< k_m [N/m], > 0; infinite: fixed grips

    [[nodiscard]] hysteresis::Pressing pressing() const { return {maximum_force, machine_stiffness}; }
    [[nodiscard]] hysteresis::Drive drive() const { return {approach_speed, retraction_speed, hold_time}; }
};

/// What a loop of this specimen in this machine goes through: hysteresis::sphere_loop().
/// @throws InvalidArgument for values outside their domains.
[[nodiscard]] hysteresis::SphereLoop loop_truth(const hysteresis::HystereticSphere& specimen,
                                                const LoadingProtocol& protocol,
                                                const hysteresis::ViscousBody& body = {});

}  // namespace setae::simulation
