// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/maugis_dugdale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "setae/contact/dmt.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::maugis_dugdale::maugis_dugdale_test {
namespace {

constexpr AdhesiveContact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.05};

Contact with(double lambda) {
    return {.radius = lens.radius,
            .contact_modulus = lens.contact_modulus,
            .work_of_adhesion = lens.work_of_adhesion,
            .cohesive_stress = cohesive_stress(lambda, lens)};
}

constexpr double lambdas[] = {0.01, 0.1, 0.5, 0.9, 0.95, 1.0, 2.0, 5.0, 100.0};

TEST(MaugisDugdale, SatisfiesBothEquationsOfMaugis) {
    // the first equation as Maugis writes it; λ and A where it does not cancel
    for (const double lambda : {0.05, 0.5, 2.0})
        for (const double a : {0.2, 1.0, 2.5}) {
            const ReducedState state = reduced_state(a, lambda);
            const double m = state.zone_ratio, s = std::sqrt(m * m - 1.0);
            const double first = 0.5 * lambda * a * a * (s + (m * m - 2.0) * std::atan(s)) +
                                 4.0 / 3.0 * lambda * lambda * a * (s * std::atan(s) - m + 1.0);
            EXPECT_NEAR(first, 1.0, 1e-10);
            EXPECT_NEAR(state.force, a * a * a - lambda * a * a * (s + m * m * std::atan(s)), 1e-10);
            EXPECT_NEAR(state.displacement, a * a - 4.0 / 3.0 * lambda * a * s, 1e-10);
        }
}

TEST(MaugisDugdaleRadius, AtForceInvertsForceOnBothBranches) {
    for (const double lambda : lambdas) {
        const Contact contact = with(lambda);
        const double fold = pull_off_at_fixed_load(contact).contact_radius;
        for (const double factor : {1.01, 1.5, 3.0, 30.0}) {
            const double a = fold * factor;
            EXPECT_NEAR(contact_radius_at_force(force(a, contact), contact) / a, 1.0, lambda < 0.1 ? 1e-6 : 1e-10)
                << lambda << ' ' << factor;
        }
        if (lambda < 0.1) continue;  // the inner branch spans 1e-5 of the force there
        for (const double factor : {0.3, 0.5, 0.9, 0.99}) {
            const double a = fold * factor;
            EXPECT_NEAR(contact_radius_at_force(force(a, contact), contact, Branch::inner) / a, 1.0, 1e-10)
                << lambda << ' ' << factor;
        }
    }
}

TEST(MaugisDugdaleRadius, AtDisplacementInvertsDisplacementOnBothBranches) {
    for (const double lambda : lambdas) {
        const Contact contact = with(lambda);
        const double unit = jkr::maugis_units(lens).length;
        const double fold = pull_off_at_fixed_grips(contact).contact_radius;
        for (const double step : {0.05, 0.3, 1.0, 10.0}) {
            const double a = fold + step * unit;
            EXPECT_NEAR(contact_radius_at_displacement(displacement(a, contact), contact) / a, 1.0, 1e-10)
                << lambda << ' ' << step;
        }
        if (fold < 0.1 * unit) continue;  // too flat for ten digits
        for (const double factor : {0.3, 0.5, 0.9, 0.99}) {
            const double a = fold * factor;
            EXPECT_NEAR(contact_radius_at_displacement(displacement(a, contact), contact, Branch::inner) / a, 1.0,
                        1e-10)
                << lambda << ' ' << factor;
        }
    }
}

TEST(MaugisDugdaleRadius, IsUndefinedWhereThereIsNoEquilibrium) {
    for (const double lambda : lambdas) {
        const Contact contact = with(lambda);
        const State load = pull_off_at_fixed_load(contact), grips = pull_off_at_fixed_grips(contact);
        EXPECT_TRUE(std::isnan(contact_radius_at_force(load.force * (1.0 + 1e-12), contact)));
        EXPECT_TRUE(std::isnan(contact_radius_at_displacement(grips.displacement * (1.0 + 1e-12), contact)));
        EXPECT_TRUE(std::isnan(displacement_at_force(load.force * 1.1, contact)));
        EXPECT_TRUE(std::isnan(force_at_displacement(grips.displacement * 1.1, contact)));
        EXPECT_TRUE(std::isnan(contact_radius_at_force(1e-6, contact, Branch::inner)));
        EXPECT_TRUE(std::isnan(contact_radius_at_displacement(1e-9, contact, Branch::inner)));
        EXPECT_TRUE(std::isnan(contact_radius_at_force(undefined, contact)));
    }
    // without a fold there is no inner branch at all
    const Contact long_range = with(0.5);
    EXPECT_TRUE(std::isnan(contact_radius_at_displacement(0.99 * pull_off_at_fixed_grips(long_range).displacement,
                                                          long_range, Branch::inner)));
}

TEST(MaugisDugdaleRadius, ReachesZeroWhileTheCohesiveZoneActs) {
    for (const double lambda : {0.1, 0.5, 2.0}) {
        const ReducedState vanished = reduced_state(0.0, lambda);
        const ReducedState small = reduced_state(1e-6, lambda);
        // both change with A²
        EXPECT_NEAR(small.force, vanished.force, 1e-10);
        EXPECT_NEAR(small.displacement, vanished.displacement, 1e-10);
        EXPECT_TRUE(std::isinf(vanished.zone_ratio));
        EXPECT_LT(vanished.force, 0.0);
    }
}

TEST(MaugisDugdalePullOff, IsTheMinimumOfTheCurve) {
    for (const double lambda : lambdas) {
        const ReducedState load = reduced_pull_off_at_fixed_load(lambda);
        const ReducedState grips = reduced_pull_off_at_fixed_grips(lambda);
        for (double a = 0.005; a < 3.0; a += 0.005) {
            const ReducedState state = reduced_state(a, lambda);
            EXPECT_GE(state.force, load.force);
            EXPECT_GE(state.displacement, grips.displacement);
        }
    }
}

TEST(MaugisDugdalePullOff, AtFixedGripsHasAFoldOnlyForShortRanges) {
    EXPECT_EQ(reduced_pull_off_at_fixed_grips(0.93).contact_radius, 0.0);
    EXPECT_GT(reduced_pull_off_at_fixed_grips(0.95).contact_radius, 0.0);
    EXPECT_NEAR(reduced_pull_off_at_fixed_grips(0.95).contact_radius, 0.02, 0.005);  // it opens as a square root
}

TEST(MaugisDugdalePullOff, IsIndependentOfTheSizeOfTheSphere) {
    for (const double lambda : {0.3, 3.0}) {
        const State state = pull_off_at_fixed_load(with(lambda));
        const jkr::MaugisUnits units = jkr::maugis_units(lens);
        const ReducedState reduced = reduced_pull_off_at_fixed_load(lambda);
        EXPECT_NEAR(state.force / units.force, reduced.force, 1e-12);
        EXPECT_NEAR(state.displacement / units.height, reduced.displacement, 1e-7);
        EXPECT_NEAR(state.contact_radius / units.length, reduced.contact_radius, 1e-7);
    }
}

double observed_order(double error_before, double error_after, double ratio) {
    return std::log(error_before / error_after) / std::log(ratio);
}

TEST(MaugisDugdaleLimit, TendsToJkrWithTheSquareOfTheRange) {
    const auto jkr_force = [](double a) { return a * a * a - std::sqrt(6.0 * a * a * a); };
    const auto jkr_displacement = [](double a) { return a * a - 2.0 / 3.0 * std::sqrt(6.0 * a); };
    for (const double a : {0.6, 1.2, 3.0}) {
        EXPECT_NEAR(observed_order(reduced_state(a, 100.0).force - jkr_force(a),
                                   reduced_state(a, 400.0).force - jkr_force(a), 4.0),
                    2.0, 0.02);
        EXPECT_NEAR(observed_order(reduced_state(a, 100.0).displacement - jkr_displacement(a),
                                   reduced_state(a, 400.0).displacement - jkr_displacement(a), 4.0),
                    2.0, 0.02);
        EXPECT_NEAR(reduced_state(a, 1e5).force, jkr_force(a), 1e-8);
    }
    EXPECT_NEAR(observed_order(-1.5 - reduced_pull_off_at_fixed_load(50.0).force,
                               -1.5 - reduced_pull_off_at_fixed_load(200.0).force, 4.0),
                2.0, 0.02);
    EXPECT_NEAR(reduced_pull_off_at_fixed_grips(1e4).force, -5.0 / 6.0, 1e-5);
    // the textbook state of zero load
    EXPECT_NEAR(contact_radius_at_force(0.0, with(1e5)) / jkr::maugis_units(lens).length, 1.817120592832, 1e-8);
}

TEST(MaugisDugdaleLimit, TendsToDmtWithThePowerThreeHalves) {
    EXPECT_NEAR(observed_order(2.0 + reduced_pull_off_at_fixed_load(1e-3).force,
                               2.0 + reduced_pull_off_at_fixed_load(1e-4).force, 10.0),
                1.5, 0.02);
    for (const double a : {0.5, 1.0, 2.0}) {
        EXPECT_NEAR(reduced_state(a, 1e-12).force, a * a * a - 2.0, 1e-5);
        EXPECT_NEAR(reduced_state(a, 1e-12).displacement, a * a, 1e-5);
    }
    EXPECT_NEAR(reduced_pull_off_at_fixed_load(1e-9).force, -2.0, 1e-12);
    const Contact contact = with(1e-6);
    EXPECT_NEAR(contact_radius_at_force(1e-4, contact) / dmt::contact_radius_at_force(1e-4, lens), 1.0, 1e-5);
}

TEST(MaugisDugdale, IsCorrectAtTheEndsOfItsDomain) {
    for (const double lambda : {1e-30, 1e30}) {
        const double limit = lambda < 1.0 ? -2.0 : -1.5;
        EXPECT_NEAR(reduced_pull_off_at_fixed_load(lambda).force, limit, 1e-12);
        EXPECT_NEAR(reduced_pull_off_at_fixed_grips(lambda).displacement, lambda < 1.0 ? 0.0 : -0.908560296416, 1e-10);
        for (const double a : {1e-6, 1.0, 1e6})
            EXPECT_NEAR(reduced_state(a, lambda).displacement,
                        lambda < 1.0 ? a * a : a * a - 2.0 / 3.0 * std::sqrt(6.0 * a), 1e-14 * (1.0 + a * a));
        EXPECT_TRUE(std::isnan(contact_radius_at_force(std::numeric_limits<double>::infinity(), with(lambda))));
    }
    // the radius at pull-off is resolved down to λ = 1e-5, where it is 2.09 λ as at 1e-3 and 1e-4
    EXPECT_NEAR(reduced_pull_off_at_fixed_load(1e-5).contact_radius / 2.09e-5, 1.0, 0.02);
}

TEST(MaugisDugdale, ConvertsBetweenStressRangeAndTransitionParameter) {
    const Contact contact = with(0.7);
    EXPECT_NEAR(transition_parameter(contact), 0.7, 1e-15);
    // the definition itself: λ = 2σ0 (R/(πWK²))^(1/3)
    const double k = 4.0 / 3.0 * lens.contact_modulus;
    EXPECT_NEAR(transition_parameter(contact),
                2.0 * contact.cohesive_stress * std::cbrt(lens.radius / (pi * lens.work_of_adhesion * k * k)), 1e-14);
}

TEST(MaugisDugdale, GapAtTheEndOfTheZoneEqualsTheRange) {
    // gap at c, in metres: that of the parabola pressed flat up to a, and what the cohesive stress adds
    for (const double lambda : {0.3, 2.0}) {
        const Contact contact = with(lambda);
        const double a = pull_off_at_fixed_load(contact).contact_radius,
                     c = a * reduced_pull_off_at_fixed_load(lambda).zone_ratio;
        const double angle = std::acos(a / c);
        const double parabola = ((c * c - 2.0 * a * a) * angle + a * std::sqrt(c * c - a * a)) / (pi * contact.radius);
        const double opened =
            4.0 * contact.cohesive_stress / (pi * contact.contact_modulus) * (std::sqrt(c * c - a * a) * angle - c + a);
        EXPECT_NEAR((parabola + opened) * contact.cohesive_stress / contact.work_of_adhesion, 1.0, 1e-10);
    }
}

TEST(MaugisDugdale, OfSeriesEqualsThatOfEachValue) {
    const Contact contact = with(1.3);
    const Array1D displacements = Array1D::LinSpaced(6, -1e-6, 4e-6);
    const Array1D radii = contact_radius_at_displacement(displacements, contact);
    const Array1D forces = force_at_displacement(displacements, contact);
    for (Index i = 0; i < displacements.size(); ++i) {
        const double a = contact_radius_at_displacement(displacements[i], contact);
        EXPECT_TRUE(radii[i] == a || (std::isnan(radii[i]) && std::isnan(a)));
        const double f = force_at_displacement(displacements[i], contact);
        EXPECT_TRUE(forces[i] == f || (std::isnan(forces[i]) && std::isnan(f)));
    }
    const Array1D loads = Array1D::LinSpaced(4, -2e-4, 1e-3);
    EXPECT_EQ(contact_radius_at_force(loads, contact)[3], contact_radius_at_force(loads[3], contact));
    EXPECT_EQ(displacement_at_force(loads, contact)[2], displacement_at_force(loads[2], contact));
    const Array1D at = Array1D::LinSpaced(3, 0.0, 1e-4);
    EXPECT_EQ(force(at, contact)[2], force(at[2], contact));
    EXPECT_EQ(displacement(at, contact)[0], displacement(0.0, contact));
}

TEST(MaugisDugdale, RefusesValuesOutsideItsDomain) {
    Contact bad = with(1.0);
    bad.radius = -1.0;
    EXPECT_THROW((void)force(1e-5, bad), InvalidArgument);
    bad = with(1.0);
    bad.work_of_adhesion = 0.0;
    EXPECT_THROW((void)transition_parameter(bad), InvalidArgument);
    bad = with(1.0);
    bad.cohesive_stress = undefined;
    EXPECT_THROW((void)contact_radius_at_force(0.0, bad), InvalidArgument);
    bad.cohesive_stress = 0.0;
    EXPECT_THROW((void)transition_parameter(bad), InvalidArgument);
    EXPECT_THROW((void)force(-1e-6, with(1.0)), InvalidArgument);
    EXPECT_THROW((void)displacement(undefined, with(1.0)), InvalidArgument);
    EXPECT_THROW((void)reduced_state(1.0, 0.0), InvalidArgument);
    EXPECT_THROW((void)reduced_state(1.0, 1e40), InvalidArgument);
    EXPECT_THROW((void)reduced_state(std::numeric_limits<double>::infinity(), 1.0), InvalidArgument);
    EXPECT_THROW((void)reduced_pull_off_at_fixed_load(-1.0), InvalidArgument);
    EXPECT_THROW((void)cohesive_stress(0.0, lens), InvalidArgument);
}

TEST(MaugisDugdale, SlopesAreDerivativesOfTheStates) {
    for (const double lambda : {0.1, 0.7, 5.0})
        for (const double radius : {0.3, 1.0, 3.0}) {
            const ReducedSlopes slopes = reduced_slopes(radius, lambda);
            const double da = 1e-4 * radius, dl = 1e-4 * lambda;
            const ReducedState right = reduced_state(radius + da, lambda), left = reduced_state(radius - da, lambda);
            const ReducedState above = reduced_state(radius, lambda + dl), below = reduced_state(radius, lambda - dl);
            EXPECT_DOUBLE_EQ(slopes.state.force, reduced_state(radius, lambda).force);
            // central differences err by their step squared
            const double scale = 1e-6 * (1.0 + radius * radius + 1.0 / lambda);
            EXPECT_NEAR(slopes.force_by_radius, (right.force - left.force) / (2.0 * da), scale);
            EXPECT_NEAR(slopes.displacement_by_radius, (right.displacement - left.displacement) / (2.0 * da), scale);
            EXPECT_NEAR(slopes.force_by_transition, (above.force - below.force) / (2.0 * dl), scale);
            EXPECT_NEAR(slopes.displacement_by_transition, (above.displacement - below.displacement) / (2.0 * dl),
                        scale);
        }
    EXPECT_THROW((void)reduced_slopes(0.0, 1.0), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::maugis_dugdale::maugis_dugdale_test
