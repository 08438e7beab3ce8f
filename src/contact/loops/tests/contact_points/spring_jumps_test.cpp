// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/spring_jumps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::loops::spring_jumps_test {
namespace {

const contact::jkr::Contact rubber{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
constexpr double fixed_grips = std::numeric_limits<double>::infinity();

TEST(SpringJumps, UnderFixedGripsLoseTheMaugisEnergy) {
    const SpringJumps jumps = spring_jumps(rubber, fixed_grips);
    const double unit = contact::jkr::maugis_units(rubber).energy;
    EXPECT_NEAR(jumps.total() / unit, 1.2749410291, 1e-10);
    EXPECT_NEAR(jumps.jump_in_loss / unit, 1.1537996562, 1e-10);
    EXPECT_NEAR(jumps.jump_out_loss / unit, 0.1211413729, 1e-10);
    const double force = pi * rubber.radius * rubber.work_of_adhesion;
    EXPECT_NEAR(jumps.before_jump_out.force / force, -5.0 / 6.0, 1e-12);
    EXPECT_NEAR(jumps.after_jump_in.force / force, -4.0 / 3.0, 1e-12);
    EXPECT_NEAR(jumps.after_jump_in.displacement, 0.0, 1e-15 * rubber.radius);
}

TEST(SpringJumps, OfAStiffMachineApproachFixedGripsInFirstOrder) {
    // before the jump out the spring holds F²/2k; after the jump in it does, too, but F²/k less is in the contact, F dδ
    // of dδ = −F/k
    const SpringJumps rigid = spring_jumps(rubber, fixed_grips), stiff = spring_jumps(rubber, 1e8);
    const auto spring = [](double force) { return force * force / 2e8; };
    EXPECT_NEAR((stiff.jump_in_loss - rigid.jump_in_loss) / spring(rigid.after_jump_in.force), 1.0, 1e-3);
    EXPECT_NEAR((stiff.jump_out_loss - rigid.jump_out_loss) / spring(rigid.before_jump_out.force), 1.0, 1e-3);
}

TEST(SpringJumps, OfASoftSpringEqualThoseOfADeadLoad) {
    constexpr double stiffness = 1e-9;
    const SpringJumps jumps = spring_jumps(rubber, stiffness);
    const contact::jkr::State load = contact::jkr::pull_off_at_fixed_load(rubber);
    EXPECT_NEAR(jumps.before_jump_out.force / load.force, 1.0, 1e-9);
    EXPECT_NEAR(jumps.after_jump_in.contact_radius / contact::jkr::contact_radius_at_force(0.0, rubber), 1.0, 1e-9);
    // what the spring held goes beyond all bounds
    EXPECT_NEAR(jumps.jump_out_loss / (load.force * load.force / (2.0 * stiffness)), 1.0, 1e-6);
    // at zero load only the contact's own energy is lost on the way in
    const double a = contact::jkr::contact_radius_at_force(0.0, rubber);
    EXPECT_NEAR(jumps.jump_in_loss / -contact::jkr::total_energy(a, contact::jkr::displacement(a, rubber), rubber), 1.0,
                1e-9);
}

TEST(SpringJumps, OutHappensWhereContactStiffnessEqualsMachineStiffness) {
    for (const double stiffness : {1.0, 40.0, 1000.0}) {
        const SpringJumps jumps = spring_jumps(rubber, stiffness);
        const double a = jumps.before_jump_out.contact_radius, step = 1e-5 * a;
        const auto change = [&](auto function) { return function(a + step, rubber) - function(a - step, rubber); };
        const double slope = change(contact::jkr::force) /
                             change([](double at, const auto& c) { return contact::jkr::displacement(at, c); });
        EXPECT_NEAR(slope / stiffness, -1.0, 1e-6) << stiffness;
        EXPECT_NEAR(jumps.after_jump_in.force / (-stiffness * jumps.after_jump_in.displacement), 1.0, 1e-10)
            << stiffness;
    }
}

TEST(SpringJumps, RequireAdhesionAndAMachineStiffness) {
    EXPECT_THROW((void)spring_jumps(rubber, 0.0), InvalidArgument);
    EXPECT_THROW((void)spring_jumps({1e-3, 1e6, 0.0}, 10.0), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::spring_jumps_test
