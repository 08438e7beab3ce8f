// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/hertz.hpp"

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::contact::hertz::hertz_test {
namespace {

constexpr SphereOnFlat contact{.radius = 4.0, .contact_modulus = 5.0};

TEST(Hertz, ForceInvertsPenetration) { EXPECT_NEAR(force(penetration(7.0, contact), contact), 7.0, 1e-14); }

TEST(Hertz, EnergyIsTheWorkOfTheForce) {
    // dU/dd = F: central difference, error O(h²)
    const double d = 0.3, h = 1e-5;
    EXPECT_NEAR((energy(d + h, contact) - energy(d - h, contact)) / (2.0 * h), force(d, contact), 1e-9);
}

TEST(Hertz, IsZeroWithoutForce) { EXPECT_EQ(contact_radius(0.0, contact), 0.0); }

TEST(Hertz, RefusesTensionAndImpossibleSpheres) {
    EXPECT_THROW((void)contact_radius(-1.0, contact), InvalidArgument);
    EXPECT_THROW((void)force(-1.0, contact), InvalidArgument);
    EXPECT_THROW((void)force(1.0, {.radius = 0.0, .contact_modulus = 1.0}), InvalidArgument);
    EXPECT_THROW((void)force(1.0, {.radius = 1.0, .contact_modulus = 0.0}), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::hertz::hertz_test
