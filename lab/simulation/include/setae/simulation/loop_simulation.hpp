// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/loops/loop.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/simulation/loop_truth.hpp"

namespace setae::simulation {

/// Errors of the record.
///
///   F_rec = F + offset + slope m + drift t + noise,   δ_rec = δ + c F + drift t + noise
struct LoopArtefacts {
    double compliance = 0.0;               ///< compliance c of the load path [m/N] that the displacement contains
    double force_drift_rate = 0.0;         ///< [N/s]
    double displacement_drift_rate = 0.0;  ///< [m/s]
    double baseline_offset = 0.0;          ///< [N]
    double baseline_slope = 0.0;           ///< [N/m]
    double force_noise = 0.0;              ///< standard deviation of a sample [N]
    double displacement_noise = 0.0;       ///< standard deviation of a sample [m]
    double radius_noise = 0.0;             ///< standard deviation of a frame [m]
    numerics::RandomKey key{};             ///< key of the noise
};

/// A record with its true values.
struct SimulatedLoop {
    loops::Loop loop;  ///< contact radius: 0 out of contact, NaN between camera frames
    hysteresis::SphereLoop truth;
};

/// The record of a loop: samples at times i/force_rate, a frame of the camera at the first sample at or after each
/// multiple of 1/camera_rate. The jumps take no time. If the bulk relaxes, contact radius and displacement are those of
/// an elastic sphere, and the force includes contact::relaxation_force().
/// @throws InvalidArgument as true_loop, for negative noise, a camera faster than the force, and for records of more
/// than 10⁸ samples.
[[nodiscard]] SimulatedLoop simulated_loop(const hysteresis::HystereticSphere& specimen,
                                           const LoadingProtocol& protocol, const LoopArtefacts& artefacts = {},
                                           const hysteresis::ViscousBody& body = {});

}  // namespace setae::simulation
