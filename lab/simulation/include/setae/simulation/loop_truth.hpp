// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "setae/hysteresis/viscous_body.hpp"

/// Simulated measurements of bodies with known properties.
namespace setae::simulation {

/// Motion of the testing machine: its motor moves forth and back at constant speed, and pulls the sphere by a spring.
///
/// Motor position m = δ + F/k_m, 0 at first contact.
struct LoadingProtocol {
    double maximum_force = 1e-3;      ///< largest force [N], > 0
    double approach_speed = 60e-9;    ///< speed of the motor [m/s], > 0
    double retraction_speed = 60e-9;  ///< speed of the motor [m/s], > 0
    double start_gap = 2e-6;          ///< free flight before first contact and after separation [m], > 0
    double hold_time = 0.0;           ///< hold time at the turning point [s], >= 0
    double force_rate = 10.0;         ///< samples of force and displacement [1/s], > 0
    double camera_rate = 1.0;         ///< frames with the contact radius [1/s], in (0, force_rate]
    double machine_stiffness = std::numeric_limits<double>::infinity();  ///< k_m [N/m], > 0; infinite: fixed grips

    [[nodiscard]] hysteresis::Pressing pressing() const { return {maximum_force, machine_stiffness}; }
    [[nodiscard]] hysteresis::Drive drive() const { return {approach_speed, retraction_speed, hold_time}; }
};

/// The loop of this specimen in this testing machine: hysteresis::sphere_loop().
/// @throws InvalidArgument for values outside their domains.
[[nodiscard]] hysteresis::SphereLoop true_loop(const hysteresis::HystereticSphere& specimen,
                                               const LoadingProtocol& protocol,
                                               const hysteresis::ViscousBody& body = {});

}  // namespace setae::simulation
