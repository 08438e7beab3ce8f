// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/jkr.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "setae/contact/hertz.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::jkr::jkr_test {
namespace {

/// A millimetre lens of soft rubber, so that nothing rests on R = W = 1.
constexpr Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.05};
constexpr SphereOnFlat bodies{.radius = lens.radius, .contact_modulus = lens.contact_modulus};

TEST(JkrRadius, AtForceInvertsForceOnBothBranches) {
    const double fold = pull_off_at_fixed_load(lens).contact_radius;
    for (const double factor : {1.0 + 1e-6, 1.001, 1.5, 3.0, 30.0}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_force(force(a, lens), lens) / a, 1.0, 1e-9) << factor;
    }
    for (const double factor : {1e-6, 0.01, 0.5, 0.99, 1.0 - 1e-6}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_force(force(a, lens), lens, Branch::inner) / a, 1.0, 1e-9) << factor;
    }
}

TEST(JkrRadius, AtDisplacementInvertsDisplacementOnBothBranches) {
    const double fold = pull_off_at_fixed_grips(lens).contact_radius;
    for (const double factor : {1.0 + 1e-6, 1.001, 1.5, 3.0, 30.0, 1e4}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_displacement(displacement(a, lens), lens) / a, 1.0, 1e-9) << factor;
    }
    for (const double factor : {1e-6, 0.01, 0.5, 0.99, 1.0 - 1e-6}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_displacement(displacement(a, lens), lens, Branch::inner) / a, 1.0, 1e-9)
            << factor;
    }
}

TEST(JkrRadius, ApproachesTheFoldAsASquareRoot) {
    // a = a_c (1 + u)², u² (6 + O(u)) = 3ε with δ = δ_c (1 − ε): (a/a_c − 1) / √(2ε) → 1. The displacement itself is
    // known to 2e-16 only, which is why ε stops at 1e-8.
    const State fold = pull_off_at_fixed_grips(lens);
    for (const double epsilon : {1e-4, 1e-6, 1e-8}) {
        const double d = fold.displacement * (1.0 - epsilon);
        const double outside = contact_radius_at_displacement(d, lens) / fold.contact_radius - 1.0;
        const double inside = 1.0 - contact_radius_at_displacement(d, lens, Branch::inner) / fold.contact_radius;
        EXPECT_NEAR(outside / std::sqrt(2.0 * epsilon), 1.0, std::sqrt(epsilon));
        EXPECT_NEAR(inside / std::sqrt(2.0 * epsilon), 1.0, std::sqrt(epsilon));
    }
}

TEST(JkrRadius, IsUndefinedBeyondTheFolds) {
    const double force_fold = pull_off_at_fixed_load(lens).force;
    const double displacement_fold = pull_off_at_fixed_grips(lens).displacement;
    EXPECT_TRUE(std::isnan(contact_radius_at_force(force_fold * (1.0 + 1e-12), lens)));
    EXPECT_TRUE(std::isnan(contact_radius_at_displacement(displacement_fold * (1.0 + 1e-12), lens)));
    EXPECT_TRUE(std::isnan(force_at_displacement(displacement_fold * 1.1, lens)));
    EXPECT_TRUE(std::isnan(displacement_at_force(force_fold * 1.1, lens)));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(1e-6, lens, Branch::inner)));
    EXPECT_TRUE(std::isnan(contact_radius_at_displacement(1e-9, lens, Branch::inner)));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(undefined, lens)));
}

TEST(JkrRadius, WithoutAdhesionIsHertz) {
    const Contact dry{.radius = 2.0, .contact_modulus = 3.0, .work_of_adhesion = 0.0};
    const SphereOnFlat sphere{.radius = 2.0, .contact_modulus = 3.0};
    EXPECT_DOUBLE_EQ(contact_radius_at_force(0.7, dry), hertz::contact_radius(0.7, sphere));
    EXPECT_DOUBLE_EQ(contact_radius_at_displacement(0.7, dry), std::sqrt(1.4));
    EXPECT_DOUBLE_EQ(force_at_displacement(0.7, dry), hertz::force(0.7, sphere));
}

TEST(JkrRadius, TendsToHertzAsAdhesionVanishes) {
    const SphereOnFlat sphere{.radius = 2.0, .contact_modulus = 3.0};
    const Contact weak{.radius = 2.0, .contact_modulus = 3.0, .work_of_adhesion = 1e-300};
    EXPECT_NEAR(contact_radius_at_force(0.7, weak), hertz::contact_radius(0.7, sphere), 1e-14);
    EXPECT_NEAR(contact_radius_at_displacement(0.7, weak), std::sqrt(1.4), 1e-14);
}

TEST(JkrRadius, OfSeriesEqualsThatOfEachValue) {
    const Array1D displacements = Array1D::LinSpaced(7, -1e-7, 4e-6);
    const Array1D radii = contact_radius_at_displacement(displacements, lens);
    const Array1D forces = force_at_displacement(displacements, lens);
    for (Index i = 0; i < displacements.size(); ++i) {
        EXPECT_EQ(radii[i], contact_radius_at_displacement(displacements[i], lens));
        EXPECT_EQ(forces[i], force_at_displacement(displacements[i], lens));
    }
    const Array1D loads = Array1D::LinSpaced(5, -1e-4, 1e-3);
    EXPECT_EQ(contact_radius_at_force(loads, lens)[2], contact_radius_at_force(loads[2], lens));
    EXPECT_EQ(displacement_at_force(loads, lens)[3], displacement_at_force(loads[3], lens));
}

TEST(JkrState, DeterminesTheRadiusWithoutWorkOfAdhesion) {
    const double fold = pull_off_at_fixed_grips(lens).contact_radius;
    for (const double factor : {0.3, 1.0, 1.7, 2.5, 3.0, 40.0}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at(force(a, lens), displacement(a, lens), bodies) / a, 1.0, 1e-9) << factor;
    }
    EXPECT_TRUE(std::isnan(contact_radius_at(1e-3, 0.0, bodies)));
    EXPECT_TRUE(std::isnan(contact_radius_at(1e-3, 1e-9, bodies)));
}

TEST(JkrEnergyReleaseRate, EqualsWorkOfAdhesionInEquilibrium) {
    for (const double a : {5e-6, 5e-5, 2e-4}) {
        EXPECT_NEAR(energy_release_rate_at_force(a, force(a, lens), bodies) / lens.work_of_adhesion, 1.0, 1e-9);
        EXPECT_NEAR(energy_release_rate_at_displacement(a, displacement(a, lens), bodies) / lens.work_of_adhesion, 1.0,
                    1e-9);
        EXPECT_NEAR(force_at(a, displacement(a, lens), bodies) / force(a, lens), 1.0, 1e-9);
    }
}

TEST(JkrEnergy, HasForceAndEnergyReleaseRateAsDerivatives) {
    const double a = 9e-5, d = 2e-6, step = 1e-4;
    const auto u = [&](double radius, double displacement) { return total_energy(radius, displacement, lens); };
    const double force_of_energy = (u(a, d * (1 + step)) - u(a, d * (1 - step))) / (2 * step * d);
    EXPECT_NEAR(force_of_energy / force_at(a, d, bodies), 1.0, 1e-7);
    const double release = -(u(a * (1 + step), d) - u(a * (1 - step), d)) / (2 * step * a) / (2.0 * pi * a);
    EXPECT_NEAR(release, lens.work_of_adhesion - energy_release_rate_at_displacement(a, d, bodies), 1e-7);
}

TEST(JkrPullOff, RecoversTheWorkOfAdhesionUnderEitherControl) {
    EXPECT_NEAR(work_of_adhesion_from_pull_off(pull_off_at_fixed_load(lens).force, lens.radius), 0.05, 1e-15);
    EXPECT_NEAR(work_of_adhesion_from_pull_off(pull_off_at_fixed_grips(lens).force, lens.radius, Control::fixed_grips),
                0.05, 1e-15);
}

TEST(JkrPullOff, LiesOnTheEquilibriumCurve) {
    for (const State& state :
         {pull_off_at_fixed_load(lens), pull_off_at_fixed_grips(lens), jump_in_at_fixed_grips(lens)}) {
        EXPECT_NEAR(force(state.contact_radius, lens) / state.force, 1.0, 1e-12);
        EXPECT_NEAR(displacement(state.contact_radius, lens), state.displacement, 1e-12 * 1e-6);
    }
}

TEST(JkrLoopLoss, IsTheEnergyReleasedInTheTwoJumps) {
    const LoopLoss loss = ideal_loop_loss(lens);
    const State in = jump_in_at_fixed_grips(lens);
    const State out = pull_off_at_fixed_grips(lens);
    EXPECT_NEAR(loss.jump_in / -total_energy(in.contact_radius, 0.0, lens), 1.0, 1e-12);
    EXPECT_NEAR(loss.jump_out / total_energy(out.contact_radius, out.displacement, lens), 1.0, 1e-12);
}

TEST(Jkr, RefusesValuesOutsideItsDomain) {
    EXPECT_THROW((void)force(-1.0, lens), InvalidArgument);
    EXPECT_THROW((void)displacement(-1.0, lens), InvalidArgument);
    EXPECT_THROW((void)force(1.0, {.radius = 1.0, .contact_modulus = 1.0, .work_of_adhesion = -1.0}), InvalidArgument);
    EXPECT_THROW((void)maugis_units({.radius = 1.0, .contact_modulus = 1.0, .work_of_adhesion = 0.0}), InvalidArgument);
    EXPECT_THROW((void)energy_release_rate_at_force(0.0, 1.0, bodies), InvalidArgument);
    EXPECT_THROW((void)tabor_parameter(lens, 0.0), InvalidArgument);
    EXPECT_THROW((void)work_of_adhesion_from_pull_off(1.0, 0.0), InvalidArgument);
}

TEST(Jkr, ErrorNamesWhatToCheck) {
    try {
        (void)force(std::nan(""), lens);
        ADD_FAILURE() << "a contact radius that is no number was taken";
    } catch (const InvalidArgument& error) {
        const std::string text = error.what();
        EXPECT_EQ(text.find("nan"), std::string::npos) << text;
        EXPECT_NE(text.find("contact radius cannot be computed; check the radius, forces"), std::string::npos) << text;
    }
}

TEST(TaborParameter, ScalesAsItsDefinition) {
    const Contact unit{.radius = 8.0, .contact_modulus = 1.0, .work_of_adhesion = 1.0};
    EXPECT_DOUBLE_EQ(tabor_parameter(unit, 0.5), 4.0);
}

}  // namespace
}  // namespace setae::contact::jkr::jkr_test
