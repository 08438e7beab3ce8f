// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/elasticity.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "setae/core/errors.hpp"

namespace setae::contact::elasticity_test {
namespace {

constexpr ElasticSolid diamond{.youngs_modulus = 1100e9, .poisson_ratio = 0.06};

TEST(ContactModulus, OfRubberOnARigidBodyIsFourThirdsOfYoungsModulus) {
    const ElasticSolid rigid{.youngs_modulus = std::numeric_limits<double>::infinity()};
    EXPECT_DOUBLE_EQ(contact_modulus({.youngs_modulus = 3e6, .poisson_ratio = 0.5}, rigid), 4e6);
}

TEST(ContactModulus, IsSymmetricInTheTwoBodies) {
    const ElasticSolid rubber{.youngs_modulus = 1e6, .poisson_ratio = 0.49};
    EXPECT_DOUBLE_EQ(contact_modulus(rubber, diamond), contact_modulus(diamond, rubber));
}

TEST(YoungsModulusFrom, InvertsContactModulus) {
    const ElasticSolid glass{.youngs_modulus = 71e9, .poisson_ratio = 0.17};
    for (const double modulus : {1e3, 1e6, 10e9}) {
        const double combined = contact_modulus({.youngs_modulus = modulus, .poisson_ratio = 0.4}, glass);
        EXPECT_NEAR(youngs_modulus_from(combined, 0.4, glass) / modulus, 1.0, 1e-14);
    }
}

TEST(YoungsModulusFrom, RefusesAContactStifferThanItsCounterBody) {
    try {
        (void)youngs_modulus_from(2e12, 0.5, diamond);
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("counter-body"), std::string::npos);
    }
}

TEST(ContactModulus, RefusesImpossibleSolids) {
    EXPECT_THROW((void)contact_modulus({.youngs_modulus = 0.0}, diamond), InvalidArgument);
    EXPECT_THROW((void)contact_modulus({.youngs_modulus = 1e6, .poisson_ratio = 0.51}, diamond), InvalidArgument);
    EXPECT_THROW((void)contact_modulus({.youngs_modulus = 1e6, .poisson_ratio = -1.0}, diamond), InvalidArgument);
    const ElasticSolid rigid{.youngs_modulus = std::numeric_limits<double>::infinity()};
    EXPECT_THROW((void)contact_modulus(rigid, rigid), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::elasticity_test
