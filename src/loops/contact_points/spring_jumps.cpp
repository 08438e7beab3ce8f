// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/spring_jumps.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::loops {
namespace {

/// Root of a function with one sign change between two ends, by Newton steps that a bisection replaces where they leave
/// the bracket. `at` gives value and derivative; the function is < 0 at `lower`.
template <class Function>
double bracketed_root(const Function& at, double lower, double upper) {
    constexpr int most = 100;
    constexpr double rounding = 4e-16;
    double x = 0.5 * (lower + upper);
    for (int i = 0; i < most && upper - lower > rounding * upper; ++i) {
        const auto [value, slope] = at(x);
        if (value == 0.0) return x;
        (value < 0.0 ? lower : upper) = x;
        const double next = x - value / slope;
        const double inside = next > lower && next < upper ? next : 0.5 * (lower + upper);
        if (std::abs(inside - x) <= rounding * x) return inside;
        x = inside;
    }
    return x;
}

struct ValueAndSlope {
    double value;
    double slope;
};

}  // namespace

SpringJumps spring_jumps(const contact::jkr::Contact& contact, double machine_stiffness) {
    if (!(machine_stiffness > 0.0))
        throw InvalidArgument(
            fmt::format("machine stiffness must be > 0 N/m, infinite for fixed grips, got {}", machine_stiffness));
    if (!(contact.work_of_adhesion > 0.0))
        throw InvalidArgument(
            fmt::format("a jump needs a work of adhesion > 0 J/m2, got {}", contact.work_of_adhesion));
    const contact::jkr::State grips = contact::jkr::pull_off_at_fixed_grips(contact);
    const double length = grips.contact_radius;
    const double softness = 4.0 * contact.contact_modulus * length / (3.0 * machine_stiffness);
    // both polynomials divided by 1 + κ, so that neither end of the range of κ overflows
    const double stiff = 1.0 / (1.0 + softness), soft = std::isinf(softness) ? 1.0 : softness / (1.0 + softness);
    const double in = bracketed_root(
        [&](double v) {
            return ValueAndSlope{stiff * (v * v * v - 4.0) + soft * v * v * (v * v * v - 6.0),
                                 stiff * 3.0 * v * v + soft * v * (5.0 * v * v * v - 12.0)};
        },
        std::cbrt(3.9), std::cbrt(6.1));
    const double out = bracketed_root(
        [&](double v) {
            return ValueAndSlope{stiff * (v * v * v - 1.0) + soft * 1.5 * v * v * (v * v * v - 3.0),
                                 stiff * 3.0 * v * v + soft * 1.5 * v * (5.0 * v * v * v - 6.0)};
        },
        std::cbrt(0.9), std::cbrt(3.1));
    const auto state = [&](double v) {
        const double a = length * v * v;
        return contact::jkr::State{.force = contact::jkr::force(a, contact),
                                   .displacement = contact::jkr::displacement(a, contact),
                                   .contact_radius = a};
    };
    const auto energy = [&](const contact::jkr::State& at) {
        return contact::jkr::total_energy(at.contact_radius, at.displacement, contact) +
               0.5 * at.force * at.force / machine_stiffness;
    };
    SpringJumps jumps{.after_jump_in = state(in), .before_jump_out = state(out)};
    jumps.jump_in_loss = -energy(jumps.after_jump_in);
    jumps.jump_out_loss = energy(jumps.before_jump_out);
    return jumps;
}

}  // namespace setae::loops
