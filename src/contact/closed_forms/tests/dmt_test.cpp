// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/dmt.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/contact/hertz.hpp"
#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::dmt::dmt_test {
namespace {

/// An AFM's tip on a stiff solid.
constexpr AdhesiveContact tip{.radius = 20e-9, .contact_modulus = 60e9, .work_of_adhesion = 0.1};

TEST(Dmt, IsHertzUnderLoadPlusAttraction) {
    const SphereOnFlat bodies{.radius = tip.radius, .contact_modulus = tip.contact_modulus};
    const double attraction = 2.0 * pi * 20e-9 * 0.1;
    for (const double load : {0.0, 1e-9, 1e-6}) {
        EXPECT_DOUBLE_EQ(contact_radius_at_force(load, tip), hertz::contact_radius(load + attraction, bodies));
        EXPECT_NEAR(displacement_at_force(load, tip) / hertz::penetration(load + attraction, bodies), 1.0, 1e-14);
    }
    EXPECT_NEAR(force_at_displacement(1e-10, tip), hertz::force(1e-10, bodies) - attraction, 1e-14 * attraction);
}

TEST(Dmt, InversesRecoverForceAndDisplacement) {
    for (const double a : {1e-10, 1e-9, 5e-9}) {
        EXPECT_NEAR(contact_radius_at_displacement(displacement(a, tip), tip) / a, 1.0, 1e-14);
        EXPECT_NEAR(force_at_displacement(displacement(a, tip), tip) / force(a, tip), 1.0, 1e-13);
    }
    // below, the load is lost in the rounding of the attraction
    for (const double a : {1e-9, 5e-9}) EXPECT_NEAR(contact_radius_at_force(force(a, tip), tip) / a, 1.0, 1e-10);
}

TEST(Dmt, PullsOffAtTwoPiRadiusWork) {
    const ContactState state = pull_off(tip);
    EXPECT_DOUBLE_EQ(state.force, -2.0 * pi * 20e-9 * 0.1);
    EXPECT_EQ(contact_radius_at_force(state.force, tip), 0.0);
    EXPECT_EQ(state.contact_radius, 0.0);
    EXPECT_EQ(state.displacement, 0.0);
    EXPECT_NEAR(work_of_adhesion_from_pull_off(state.force, tip.radius), 0.1, 1e-16);
}

TEST(Dmt, IsUndefinedBeyondPullOff) {
    EXPECT_TRUE(std::isnan(contact_radius_at_force(1.001 * pull_off(tip).force, tip)));
    EXPECT_TRUE(std::isnan(displacement_at_force(1.001 * pull_off(tip).force, tip)));
    EXPECT_TRUE(std::isnan(contact_radius_at_displacement(-1e-12, tip)));
    EXPECT_TRUE(std::isnan(force_at_displacement(-1e-12, tip)));
    EXPECT_TRUE(std::isnan(contact_radius_at_force(undefined, tip)));
}

TEST(Dmt, OfSeriesEqualsThatOfEachValue) {
    const Array1D loads = Array1D::LinSpaced(5, -2e-8, 1e-7);
    const Array1D displacements = Array1D::LinSpaced(5, -1e-11, 1e-9);
    EXPECT_EQ(contact_radius_at_force(loads, tip)[3], contact_radius_at_force(loads[3], tip));
    EXPECT_EQ(displacement_at_force(loads, tip)[4], displacement_at_force(loads[4], tip));
    EXPECT_EQ(contact_radius_at_displacement(displacements, tip)[2],
              contact_radius_at_displacement(displacements[2], tip));
    EXPECT_EQ(force_at_displacement(displacements, tip)[1], force_at_displacement(displacements[1], tip));
    EXPECT_TRUE(std::isnan(force_at_displacement(displacements, tip)[0]));
}

TEST(Dmt, RefusesValuesOutsideItsDomain) {
    AdhesiveContact bad = tip;
    bad.radius = -1.0;
    EXPECT_THROW((void)force(1e-9, bad), InvalidArgument);
    bad = tip;
    bad.work_of_adhesion = -0.1;
    EXPECT_THROW((void)contact_radius_at_force(0.0, bad), InvalidArgument);
    bad.work_of_adhesion = undefined;
    EXPECT_THROW((void)pull_off(bad), InvalidArgument);
    EXPECT_THROW((void)force(-1e-9, tip), InvalidArgument);
    EXPECT_THROW((void)displacement(undefined, tip), InvalidArgument);
    EXPECT_THROW((void)work_of_adhesion_from_pull_off(undefined, 1.0), InvalidArgument);
    EXPECT_THROW((void)work_of_adhesion_from_pull_off(1.0, 0.0), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::dmt::dmt_test
