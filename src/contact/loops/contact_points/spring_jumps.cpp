// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/spring_jumps.hpp"

#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::loops {

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
    const double in =
        numerics::bracketed_root([&](double v) { return stiff * (v * v * v - 4.0) + soft * v * v * (v * v * v - 6.0); },
                                 std::cbrt(3.9), std::cbrt(6.1));
    const double out = numerics::bracketed_root(
        [&](double v) { return stiff * (v * v * v - 1.0) + soft * 1.5 * v * v * (v * v * v - 3.0); }, std::cbrt(0.9),
        std::cbrt(3.1));
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
