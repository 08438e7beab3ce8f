// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/large_strain.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::large_strain::large_strain_test {
namespace {

/// A soft gel: W/(E*R) = 0.1, pull-off at more than half the radius.
constexpr Contact gel{.radius = 50e-6, .contact_modulus = 10e3, .work_of_adhesion = 0.05};
constexpr Contact dry{.radius = 2.0, .contact_modulus = 3.0, .work_of_adhesion = 0.0};

TEST(LargeStrain, WithoutAdhesionIsSneddonsSphere) {
    for (const double a : {0.3, 1.0, 1.9}) {
        const double log = std::log((2.0 + a) / (2.0 - a));
        EXPECT_NEAR(force(a, dry) / (3.0 * (0.5 * (a * a + 4.0) * log - 2.0 * a)), 1.0, 1e-12);
        EXPECT_NEAR(displacement(a, dry) / (0.5 * a * log), 1.0, 1e-14);
    }
}

TEST(LargeStrain, IsContinuousWhereSeriesAndClosedFormMeet) {
    const double a = 0.25 * dry.radius;
    EXPECT_NEAR(force(a * (1.0 + 1e-15), dry) / force(a, dry), 1.0, 1e-13);
}

TEST(LargeStrain, TendsToJkrWithTheSquareOfTheRadius) {
    for (const double x : {1e-2, 1e-3}) {
        const double a = x * dry.radius;
        EXPECT_NEAR((force(a, dry) / jkr::force(a, dry) - 1.0) / (x * x), 0.4, 2e-2 * x + 1e-9);
        EXPECT_NEAR((displacement(a, dry) / jkr::displacement(a, dry) - 1.0) / (x * x), 1.0 / 3.0, 2e-2 * x + 1e-9);
    }
    // a stiff lens: W/(E*R) = 4e-8
    const Contact stiff{.radius = 1.25e-3, .contact_modulus = 1e9, .work_of_adhesion = 0.05};
    EXPECT_NEAR(pull_off_at_fixed_load(stiff).force / jkr::pull_off_at_fixed_load(stiff).force, 1.0, 1e-4);
    EXPECT_NEAR(pull_off_at_fixed_grips(stiff).displacement / jkr::pull_off_at_fixed_grips(stiff).displacement, 1.0,
                1e-4);
}

TEST(LargeStrainRadius, AtForceInvertsForceOnBothBranches) {
    const double fold = pull_off_at_fixed_load(gel).contact_radius;
    for (const double factor : {1.01, 1.2, 1.5, 1.7}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_force(force(a, gel), gel) / a, 1.0, 1e-10) << factor;
    }
    for (const double factor : {0.01, 0.3, 0.9, 0.99}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_force(force(a, gel), gel, Branch::inner) / a, 1.0, 1e-10) << factor;
    }
}

TEST(LargeStrainRadius, AtDisplacementInvertsDisplacementOnBothBranches) {
    const double fold = pull_off_at_fixed_grips(gel).contact_radius;
    for (const double factor : {1.01, 1.5, 3.0}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_displacement(displacement(a, gel), gel) / a, 1.0, 1e-10) << factor;
        EXPECT_NEAR(force_at_displacement(displacement(a, gel), gel) / force(a, gel), 1.0, 1e-9) << factor;
    }
    for (const double factor : {0.01, 0.3, 0.9, 0.99}) {
        const double a = fold * factor;
        EXPECT_NEAR(contact_radius_at_displacement(displacement(a, gel), gel, Branch::inner) / a, 1.0, 1e-10) << factor;
    }
}

TEST(LargeStrainRadius, IsBelowTheSphereRadius) {
    const double unit = gel.contact_modulus * gel.radius * gel.radius;
    EXPECT_LT(contact_radius_at_force(10.0 * unit, gel), gel.radius);
    EXPECT_TRUE(std::isnan(contact_radius_at_force(100.0 * unit, gel)));
    EXPECT_TRUE(std::isnan(contact_radius_at_displacement(20.0 * gel.radius, gel)));
}

TEST(LargeStrainRadius, IsUndefinedBeyondTheFolds) {
    EXPECT_TRUE(std::isnan(contact_radius_at_force(pull_off_at_fixed_load(gel).force * (1.0 + 1e-12), gel)));
    EXPECT_TRUE(
        std::isnan(contact_radius_at_displacement(pull_off_at_fixed_grips(gel).displacement * (1.0 + 1e-12), gel)));
    EXPECT_TRUE(std::isnan(force_at_displacement(pull_off_at_fixed_grips(gel).displacement * 1.1, gel)));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(1e-9, gel, Branch::inner)));
    EXPECT_TRUE(std::isnan(contact_radius_at_displacement(1e-9, gel, Branch::inner)));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(undefined, gel)));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(-1e-9, dry)));
}

TEST(LargeStrainPullOff, IsTheMinimumOfTheCurve) {
    for (const double w : {1e-6, 1e-2, 1.0, 100.0, 1e6}) {
        const Contact contact{.radius = 2.0, .contact_modulus = 3.0, .work_of_adhesion = 6.0 * w};
        const State load = pull_off_at_fixed_load(contact), grips = pull_off_at_fixed_grips(contact);
        for (double x = 1e-3; x < 1.0; x += 1e-2) {
            EXPECT_GE(force(2.0 * x, contact), load.force);
            EXPECT_GE(displacement(2.0 * x, contact), grips.displacement);
        }
        EXPECT_NEAR(force(load.contact_radius, contact) / load.force, 1.0, 1e-12);
        EXPECT_NEAR(displacement(grips.contact_radius, contact) / grips.displacement, 1.0, 1e-12);
    }
}

TEST(LargeStrainEnergyReleaseRate, EqualsWorkOfAdhesionInEquilibrium) {
    for (const double x : {0.05, 0.4, 0.95}) {
        const double a = x * gel.radius;
        EXPECT_NEAR(energy_release_rate_at_force(a, force(a, gel), {gel.radius, gel.contact_modulus}) / 0.05, 1.0,
                    1e-10);
    }
}

TEST(LargeStrain, ForceIsTheWorkOfDisplacementWithTheEdgeHeld) {
    // along equilibrium dF/da = (dF/dδ at fixed a) dδ/da + ..., and without adhesion dF = 2aE* dδ (the edge is regular)
    const double a = 1.3, step = 1e-5;
    const double slope =
        (force(a + step, dry) - force(a - step, dry)) / (displacement(a + step, dry) - displacement(a - step, dry));
    EXPECT_NEAR(slope / (2.0 * a * dry.contact_modulus), 1.0, 1e-8);
}

TEST(LargeStrain, OfSeriesEqualsThatOfEachValue) {
    const Array1D loads = Array1D::LinSpaced(5, -2e-6, 1e-5);
    const Array1D displacements = Array1D::LinSpaced(5, -1e-5, 5e-5);
    EXPECT_EQ(contact_radius_at_force(loads, gel)[4], contact_radius_at_force(loads[4], gel));
    EXPECT_EQ(contact_radius_at_displacement(displacements, gel)[3],
              contact_radius_at_displacement(displacements[3], gel));
    EXPECT_EQ(force_at_displacement(displacements, gel)[3], force_at_displacement(displacements[3], gel));
}

TEST(LargeStrain, RefusesValuesOutsideItsDomain) {
    EXPECT_THROW((void)force(gel.radius, gel), InvalidArgument);
    EXPECT_THROW((void)displacement(2.0 * gel.radius, gel), InvalidArgument);
    EXPECT_THROW((void)force(-1e-6, gel), InvalidArgument);
    EXPECT_THROW((void)force(undefined, gel), InvalidArgument);
    EXPECT_THROW((void)energy_release_rate_at_force(gel.radius, 0.0, {gel.radius, gel.contact_modulus}),
                 InvalidArgument);
    for (const Contact& bad :
         {Contact{.radius = -1.0, .contact_modulus = 1.0}, Contact{.radius = 1.0, .contact_modulus = 0.0},
          Contact{.radius = 1.0, .contact_modulus = 1.0, .work_of_adhesion = -1.0},
          Contact{.radius = 1.0, .contact_modulus = 1.0, .work_of_adhesion = undefined},
          Contact{.radius = 1.0, .contact_modulus = 1.0, .work_of_adhesion = 1e7}})
        EXPECT_THROW((void)contact_radius_at_force(0.0, bad), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::large_strain::large_strain_test
