// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "setae/contact/jkr.hpp"

/// Simulated measurements of bodies whose every property is known.
namespace setae::simulation {

/// A soft sphere on a flat whose adhesion may differ between approach and retraction.
struct LoopSpecimen {
    double radius = 0.0;           ///< R [m], > 0
    double contact_modulus = 0.0;  ///< E* [Pa], > 0
    double work_approach = 0.0;    ///< W_app [J/m²], > 0
    double work_retraction = 0.0;  ///< W_ret [J/m²], >= W_app
};

/// What the machine does: its motor moves to and fro at constant speed, and pulls the sphere by a spring.
///
/// Motor position m = δ + F/k_m, 0 where the bodies first touch.
struct LoadingProtocol {
    double maximum_force = 1e-3;      ///< [N] at the turning point
    double approach_speed = 60e-9;    ///< of the motor [m/s], > 0
    double retraction_speed = 60e-9;  ///< of the motor [m/s], > 0
    double start_gap = 2e-6;          ///< free flight before first touch and after parting [m], > 0
    double hold_time = 0.0;           ///< at the turning point [s], >= 0
    double force_rate = 10.0;         ///< samples of force and displacement [1/s], > 0
    double camera_rate = 1.0;         ///< frames that show the contact radius [1/s], in (0, force_rate]
    double machine_stiffness = std::numeric_limits<double>::infinity();  ///< k_m [N/m], > 0; infinite: fixed grips
};

/// What happens in the loop, by closed forms.
struct LoopTruth {
    contact::jkr::State after_jump_in;  ///< first state of contact
    contact::jkr::State turning_point;  ///< largest force; its contact radius is a_max
    contact::jkr::State unpinned;       ///< same contact radius, G = W_ret: the edge begins to recede
    contact::jkr::State parting;        ///< last state of contact
    double smallest_force = 0.0;  ///< [N], < 0: what is read as pull-off force, −3/2 πRW_ret where the edge receded
    double jump_in_loss = 0.0;    ///< [J]
    double pinning_loss = 0.0;    ///< (W_ret − W_app) π a_max² [J]
    double jump_out_loss = 0.0;   ///< [J]

    [[nodiscard]] double energy_loss() const { return jump_in_loss + pinning_loss + jump_out_loss; }  ///< ∮ F dδ [J]
    [[nodiscard]] double largest_contact_area() const;  ///< π a_max² [m²]
};

/// What a loop of this specimen in this machine goes through.
///
/// Approach: free flight to first touch, m = 0; there the contact springs to the stable radius on the machine's line
/// δ + F/k_m = 0, and follows JKR's curve for W_app to the maximum force. Retraction: the edge stays pinned at a_max,
/// dF = 2E* a_max dδ, until G = W_ret; then JKR's curve for W_ret down to where dF/dδ = −k_m (fixed grips: where δ(a)
/// turns, F = −5/6 πRW_ret; k_m → 0: −3/2 πRW_ret), or at once where a_max is not stable at W_ret; then free flight.
/// Losses of the jumps are the differences of total energy, the machine's spring included:
///
///   jump in: −U(a, δ; W_app) − F²/2k_m,   jump out: U(a, δ; W_ret) + F²/2k_m
///
/// @throws InvalidArgument for values outside their domains.
/// Source: Johnson, Kendall, Roberts 1971; Maugis (2000) ch. 4; of the sum: energy balance of the closed loop.
[[nodiscard]] LoopTruth loop_truth(const LoopSpecimen& specimen, const LoadingProtocol& protocol);

}  // namespace setae::simulation
