// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/machine.hpp"

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::hysteresis {
namespace {

using contact::jkr::Contact;
using contact::jkr::State;

/// Root of a function that is < 0 at `lower` and > 0 at `upper`, or the end where it is not.
template <class Function>
double root_or_end(const Function& function, double lower, double upper) {
    const double at_lower = function(lower), at_upper = function(upper);
    if (!(at_lower < 0.0)) return lower;
    if (!(at_upper > 0.0)) return upper;
    return numerics::bracketed_root(function, lower, upper, at_lower, at_upper, 52);
}

}  // namespace

State equilibrium(double contact_radius, const Contact& contact) {
    return {.force = contact::jkr::force(contact_radius, contact),
            .displacement = contact::jkr::displacement(contact_radius, contact),
            .contact_radius = contact_radius};
}

double Machine::instability_radius(const Contact& contact) const {
    const double R = contact.radius, E = contact.contact_modulus, W = contact.work_of_adhesion;
    const auto slope = [&](double a) {
        return 2.0 * a / R - std::sqrt(pi * W / (2.0 * E * a)) +
               compliance_ * (4.0 * E * a * a / R - 1.5 * std::sqrt(8.0 * pi * E * W * a));
    };
    return root_or_end(slope, contact::jkr::pull_off_at_fixed_grips(contact).contact_radius,
                       contact::jkr::pull_off_at_fixed_load(contact).contact_radius);
}

double Machine::stable_radius(double motor_position, const Contact& contact, double largest) const {
    const auto excess = [&](double a) { return motor(equilibrium(a, contact)) - motor_position; };
    return root_or_end(excess, std::min(largest, instability_radius(contact)), largest);
}

State Machine::pinned(const State& turning_point, double motor_position, double contact_modulus) const {
    const double stiffness = 2.0 * contact_modulus * turning_point.contact_radius;
    const double change = (motor_position - motor(turning_point)) / (1.0 + compliance_ * stiffness);
    return {.force = turning_point.force + stiffness * change,
            .displacement = turning_point.displacement + change,
            .contact_radius = turning_point.contact_radius};
}

double Machine::energy(const State& state, const Contact& contact) const {
    return contact::jkr::total_energy(state.contact_radius, state.displacement, contact) +
           0.5 * compliance_ * state.force * state.force;
}

}  // namespace setae::hysteresis
