// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/jkr.hpp"

namespace setae::hysteresis {

/// State of JKR equilibrium at a contact radius.
[[nodiscard]] contact::jkr::State equilibrium(double contact_radius, const contact::jkr::Contact& contact);

/// A motor that is connected to the contact by a spring: m = δ + F/k_m.
class Machine {
public:
    explicit Machine(double stiffness) : compliance_(1.0 / stiffness) {}

    [[nodiscard]] double motor(const contact::jkr::State& state) const {
        return state.displacement + compliance_ * state.force;
    }

    /// Contact radius at which the contact becomes unstable, dm/da = 0 on JKR's curve: between that under fixed grips
    /// and that under a fixed load. The derivative times √a has one change of sign in its powers of √a, hence one root.
    [[nodiscard]] double instability_radius(const contact::jkr::Contact& contact) const;

    /// Contact radius in stable equilibrium at a motor position, at most `largest`.
    [[nodiscard]] double stable_radius(double motor_position, const contact::jkr::Contact& contact,
                                       double largest) const;

    /// State with the edge pinned at the radius of the turning point.
    [[nodiscard]] contact::jkr::State pinned(const contact::jkr::State& turning_point, double motor_position,
                                             double contact_modulus) const;

    /// Energy [J] of contact and spring; zero for separated bodies and a relaxed spring.
    [[nodiscard]] double energy(const contact::jkr::State& state, const contact::jkr::Contact& contact) const;

private:
    double compliance_;  ///< 1/k_m [m/N]
};

}  // namespace setae::hysteresis
