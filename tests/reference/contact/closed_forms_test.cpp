// SPDX-License-Identifier: GPL-3.0-or-later
// Origins and digits: README.md beside this file.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "setae/contact/elasticity.hpp"
#include "setae/contact/hertz.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"

namespace setae::contact::closed_forms_test {
namespace {

constexpr jkr::Contact unit{.radius = 1.0, .contact_modulus = 0.75, .work_of_adhesion = 1.0 / pi};
constexpr double tolerance = 1e-9;

void expect_state(const jkr::State& state, double force, double radius, double displacement) {
    EXPECT_NEAR(state.force, force, tolerance);
    EXPECT_NEAR(state.contact_radius, radius, tolerance);
    EXPECT_NEAR(state.displacement, displacement, tolerance);
}

TEST(Hertz, GivesTheTabulatedContact) {
    const SphereOnFlat contact{.radius = 4.0, .contact_modulus = 5.0};
    EXPECT_NEAR(hertz::penetration(7.0, contact), 0.6507879989531481, 1e-15);
    EXPECT_NEAR(hertz::contact_radius(7.0, contact), 1.6134286460245437, 1e-15);
}

TEST(Jkr, GivesTheInstabilitiesInMaugisUnits) {
    expect_state(jkr::pull_off_at_fixed_load(unit), -1.5, 1.144714242553, -0.436790232368);
    expect_state(jkr::pull_off_at_fixed_grips(unit), -0.833333333333, 0.550321208149, -0.908560296416);
    expect_state(jkr::jump_in_at_fixed_grips(unit), -4.0 / 3.0, 1.386722548701, 0.0);
}

TEST(Jkr, GivesZeroLoadAndZeroPenetration) {
    const double a = jkr::contact_radius_at_force(0.0, unit);
    EXPECT_NEAR(a, 1.817120592832, tolerance);
    EXPECT_NEAR(jkr::displacement(a, unit), 1.100642416298, tolerance);
    EXPECT_NEAR(jkr::contact_radius_at_displacement(1.100642416298, unit), a, tolerance);
    EXPECT_NEAR(jkr::contact_radius_at_displacement(0.0, unit), 1.386722548701, tolerance);
    EXPECT_NEAR(jkr::force_at_displacement(0.0, unit), -4.0 / 3.0, tolerance);
}

TEST(Jkr, GivesTheCurveAtTwoRadii) {
    EXPECT_NEAR(jkr::displacement(1.0, unit), -0.632993161855, tolerance);
    EXPECT_NEAR(jkr::force(1.0, unit), -1.449489742783, tolerance);
    EXPECT_NEAR(jkr::displacement(2.0, unit), 1.690598923241, tolerance);
    EXPECT_NEAR(jkr::force(2.0, unit), 1.071796769724, tolerance);
}

TEST(Jkr, LosesTheTabulatedEnergyInItsJumps) {
    const jkr::LoopLoss loss = jkr::ideal_loop_loss(unit);
    EXPECT_NEAR(loss.jump_in, 1.1537996562, tolerance);
    EXPECT_NEAR(loss.jump_out, 0.1211413729, tolerance);
    EXPECT_NEAR(loss.total, 1.2749410291, tolerance);
    const double radius = jkr::contact_radius_at_displacement(0.0, unit);
    EXPECT_NEAR(loss.total / (unit.work_of_adhesion * pi * radius * radius), 0.662996052495, tolerance);
}

TEST(Jkr, HasUnitScalesInMaugisUnits) {
    const jkr::MaugisUnits scales = jkr::maugis_units(unit);
    for (const double scale : {scales.length, scales.height, scales.force, scales.energy})
        EXPECT_NEAR(scale, 1.0, tolerance);
}

TEST(Jkr, IsUniversalInMaugisUnits) {
    const jkr::Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.0396};
    const jkr::MaugisUnits scales = jkr::maugis_units(lens);
    EXPECT_NEAR(jkr::ideal_loop_loss(lens).total / scales.energy, 1.2749410291, tolerance);
    EXPECT_NEAR(jkr::force_at_displacement(1.690598923241 * scales.height, lens) / scales.force, 1.071796769724,
                tolerance);
    EXPECT_NEAR(jkr::contact_radius_at_force(-1.449489742783 * scales.force, lens, jkr::Branch::inner) / scales.length,
                1.0, tolerance);
}

TEST(ContactModulus, MatchesPublishedElastomersOnDiamond) {
    const ElasticSolid diamond{.youngs_modulus = 1100e9, .poisson_ratio = 0.06};
    constexpr std::array rubber{0.69e6, 1.03e6, 1.91e6, 10.03e6};
    constexpr std::array expected{0.91999923e6, 1.37333162e6, 2.54666079e6, 13.37317133e6};
    for (std::size_t i = 0; i < rubber.size(); ++i)
        EXPECT_NEAR(contact_modulus({.youngs_modulus = rubber[i], .poisson_ratio = 0.5}, diamond), expected[i], 0.005);
}

TEST(Jkr, JumpsOfThePublishedReferenceLoseUnderOneNanojoule) {
    const ElasticSolid silicon{.youngs_modulus = 160e9, .poisson_ratio = 0.22};
    constexpr std::array modulus{0.69e6, 1.03e6, 1.91e6, 10.03e6};
    constexpr std::array work{0.0396, 0.0368, 0.0388, 0.0510};
    constexpr std::array expected_nanojoule{0.46, 0.31, 0.23, 0.12};
    for (std::size_t i = 0; i < modulus.size(); ++i) {
        const double combined = contact_modulus({.youngs_modulus = modulus[i], .poisson_ratio = 0.5}, silicon);
        const jkr::LoopLoss loss =
            jkr::ideal_loop_loss({.radius = 1.25e-3, .contact_modulus = combined, .work_of_adhesion = work[i]});
        EXPECT_NEAR(loss.total / units::nJ, expected_nanojoule[i], 0.005) << modulus[i];
    }
}

}  // namespace
}  // namespace setae::contact::closed_forms_test
