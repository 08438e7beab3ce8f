// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/tabor.hpp"

#include <gtest/gtest.h>

#include "setae/contact/jkr.hpp"
#include "setae/contact/maugis_dugdale.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::tabor::tabor_test {
namespace {

constexpr AdhesiveContact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.05};
constexpr AdhesiveContact tip{.radius = 20e-9, .contact_modulus = 60e9, .work_of_adhesion = 0.1};
constexpr double atomic_range = 0.3e-9;

TEST(Tabor, GivesTheMaugisParameterByThePublishedFactor) { EXPECT_NEAR(transition_parameter(1.0), 1.1570, 5e-5); }

TEST(Tabor, AgreesWithTheCohesiveStressOfALennardJonesLaw) {
    const maugis_dugdale::Contact dugdale{.radius = tip.radius,
                                          .contact_modulus = tip.contact_modulus,
                                          .work_of_adhesion = tip.work_of_adhesion,
                                          .cohesive_stress = lennard_jones_stress(tip.work_of_adhesion, atomic_range)};
    EXPECT_NEAR(
        maugis_dugdale::transition_parameter(dugdale) / transition_parameter(jkr::tabor_parameter(tip, atomic_range)),
        1.0, 1e-14);
    // Maugis: the zone reaches over 0.97 z0
    EXPECT_NEAR(dugdale.work_of_adhesion / dugdale.cohesive_stress / atomic_range, 0.974, 5e-4);
}

TEST(TaborVerdict, FindsEachRegimeOfTheMap) {
    const double pull = 2.0 * pi * tip.radius * tip.work_of_adhesion;
    EXPECT_EQ(which_model(0.0, lens, atomic_range).regime, Regime::jkr);
    EXPECT_EQ(which_model(0.0, tip, atomic_range).regime, Regime::maugis_dugdale);
    EXPECT_EQ(which_model(5.0 * pull, tip, 5e-10).regime, Regime::dmt);
    EXPECT_EQ(which_model(0.0, tip, 1e-8).regime, Regime::rigid);
    EXPECT_EQ(which_model(100.0 * pull, tip, atomic_range).regime, Regime::hertz);
    EXPECT_NE(which_model(-100.0 * pull, tip, atomic_range).regime, Regime::hertz);
}

TEST(TaborVerdict, NamesTheApplicableModel) {
    const Verdict verdict = which_model(0.0, lens, atomic_range);
    EXPECT_NE(verdict.sentence.find("JKR"), std::string::npos) << verdict.sentence;
    EXPECT_NE(verdict.sentence.find("Tabor parameter"), std::string::npos);
    EXPECT_DOUBLE_EQ(verdict.tabor_parameter, jkr::tabor_parameter(lens, atomic_range));
    EXPECT_NEAR(verdict.transition_parameter / verdict.tabor_parameter, 1.1570, 5e-5);
}

TEST(TaborVerdict, AtItsBoundsPullOffIsWithinFivePercentOfTheLimits) {
    const double below = maugis_dugdale::reduced_pull_off_at_fixed_load(transition_parameter(0.1)).force;
    const double above = maugis_dugdale::reduced_pull_off_at_fixed_load(transition_parameter(5.0)).force;
    EXPECT_LT(below / -2.0, 1.0);
    EXPECT_GT(below / -2.0, 0.95);
    EXPECT_GT(above / -1.5, 1.0);
    EXPECT_LT(above / -1.5, 1.005);
}

TEST(Tabor, RefusesValuesOutsideItsDomain) {
    EXPECT_THROW((void)transition_parameter(0.0), InvalidArgument);
    EXPECT_THROW((void)lennard_jones_stress(-1.0, 1e-9), InvalidArgument);
    EXPECT_THROW((void)lennard_jones_stress(1.0, 0.0), InvalidArgument);
    EXPECT_THROW((void)which_model(undefined, lens, atomic_range), InvalidArgument);
    EXPECT_THROW((void)which_model(0.0, lens, 0.0), InvalidArgument);
    EXPECT_THROW((void)which_model(0.0, {.radius = -1.0, .contact_modulus = 1.0, .work_of_adhesion = 1.0}, 1e-9),
                 InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::tabor::tabor_test
