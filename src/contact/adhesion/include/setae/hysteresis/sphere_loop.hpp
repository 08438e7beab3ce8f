// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "setae/contact/jkr.hpp"

namespace setae::hysteresis {

/// A soft sphere whose adhesion differs between approach and retraction.
struct HystereticSphere {
    double radius = 0.0;           ///< R [m], > 0
    double contact_modulus = 0.0;  ///< E* [Pa], > 0
    double work_approach = 0.0;    ///< W_app [J/m²], > 0
    double work_retraction = 0.0;  ///< W_ret [J/m²], >= W_app

    [[nodiscard]] contact::jkr::Contact approach() const { return {radius, contact_modulus, work_approach}; }
    [[nodiscard]] contact::jkr::Contact retraction() const { return {radius, contact_modulus, work_retraction}; }
};

/// Loading and unloading of the sphere.
struct Pressing {
    double maximum_force = 0.0;                                          ///< largest force [N], >= 0
    double machine_stiffness = std::numeric_limits<double>::infinity();  ///< k_m [N/m], > 0; infinite: fixed grips
};

/// States and losses of the loop, by closed forms.
struct SphereLoop {
    contact::jkr::State after_jump_in;  ///< first state of contact
    contact::jkr::State turning_point;  ///< largest force; its contact radius is a_max
    contact::jkr::State unpinned;       ///< same contact radius, G = W_ret: the edge begins to retract
    contact::jkr::State separation;     ///< last state of contact
    double smallest_force = 0.0;        ///< [N], < 0: measured pull-off force, −3/2 πRW_ret where the edge retracted
    double jump_in_loss = 0.0;          ///< [J]
    double edge_loss = 0.0;             ///< (W_ret − W_app) π a_max² [J]
    double jump_out_loss = 0.0;         ///< [J]
    double speed_loss = 0.0;            ///< additional loss of the rate-dependent edge [J]: EdgeSpeed
    double bulk_loss = 0.0;             ///< loss by relaxation of the bulk [J]: contact::RelaxationTerm

    /// ∮ F dδ [J]
    [[nodiscard]] double energy_loss() const {
        return jump_in_loss + edge_loss + jump_out_loss + speed_loss + bulk_loss;
    }
    [[nodiscard]] double largest_contact_area() const;  ///< π a_max² [m²]
};

/// Computes the loop.
///
/// Approach: free flight to first contact, m = 0; there the contact jumps to the stable radius on the testing machine's
/// line δ + F/k_m = 0, and follows JKR's curve for W_app to the maximum force. Retraction: the edge stays at a_max, dF
/// = 2E* a_max dδ, until G = W_ret; then JKR's curve for W_ret down to where dF/dδ = −k_m (fixed grips: where δ(a)
/// turns, F = −5/6 πRW_ret; k_m → 0: −3/2 πRW_ret), or at once where a_max is not stable at W_ret; then free flight.
/// Losses of the jumps are the differences of total energy, including the testing machine's spring:
///
///   jump in: −U(a, δ; W_app) − F²/2k_m,   jump out: U(a, δ; W_ret) + F²/2k_m
///
/// @throws InvalidArgument for values outside their domains.
/// Source: Johnson, Kendall, Roberts 1971; Maugis (2000) ch. 4; sum: energy balance of the closed loop.
[[nodiscard]] SphereLoop sphere_loop(const HystereticSphere& sphere, const Pressing& pressing);

/// W_ret [J/m²] for a given energy loss of the loop [J]; sphere.work_retraction is not used.
/// @throws InvalidArgument as sphere_loop(), and for a loss below that with W_ret = W_app; the message states that
/// loss.
[[nodiscard]] double work_retraction_for_loss(HystereticSphere sphere, const Pressing& pressing, double energy_loss);

}  // namespace setae::hysteresis
