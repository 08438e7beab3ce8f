// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/partial_contact.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::adhesion::partial_contact_test {
namespace {

TEST(UnloadedContact, IsFullContactWithTheBalanceForSmallStoredEnergy) {
    for (const double e : {0.0, 0.03, 0.07, 0.1}) {
        EXPECT_NEAR(unloaded_contact(e).gain, 1.0 - e, 1e-6);
        EXPECT_NEAR(unloaded_contact(e).area_fraction, 1.0, 1e-3);
    }
}

// partial contact is a choice that full contact leaves open: it never gains less
TEST(UnloadedContact, GainIsAtLeastTheBalanceAndFallsWithStoredEnergy) {
    double last = 1.0, area = 1.0;
    for (double e = 0.01; e < 10.0; e *= 1.05) {
        const auto contact = unloaded_contact(e);
        EXPECT_GE(contact.gain, 1.0 - e - 1e-6) << e;
        EXPECT_LT(contact.gain, last) << e;
        EXPECT_LE(contact.area_fraction, area + 1e-9) << e;
        EXPECT_GT(contact.gain, 0.0);
        EXPECT_GE(contact.gain_error, 0.0);
        last = contact.gain;
        area = contact.area_fraction;
    }
}

// `setae lab conform`, docs/validation/conformity.md
TEST(UnloadedContact, MatchesSimulatedPatches) {
    EXPECT_NEAR(unloaded_contact(0.5).gain, 0.51, 0.01);
    EXPECT_NEAR(unloaded_contact(1.0).gain, 0.20, 0.01);
    EXPECT_NEAR(unloaded_contact(1.0).area_fraction, 0.56, 0.01);
}

TEST(UnloadedContact, ClosingPressureIncreasesWithStoredEnergy) {
    EXPECT_EQ(unloaded_contact(closing_energy_share).closing_pressure, 0.0);
    EXPECT_NEAR(unloaded_contact(closing_energy_share).area_fraction, 0.99, 1e-6);
    double last = 0.0;
    for (double e = 0.26; e < 1e3; e *= 1.1) {
        const double pressure = unloaded_contact(e).closing_pressure;
        EXPECT_GT(pressure, last) << e;
        EXPECT_LT(pressure, 7.0);
        last = pressure;
    }
}

TEST(PartialBalance, EqualsTheFullContactBalanceAndStaysPositive) {
    EXPECT_NEAR(partial_balance(0.04, 0.002), modified_balance(0.04, 0.0, {1.0, 0.002}).raw, 1e-9);
    EXPECT_GT(partial_balance(0.04, 0.05), 0.0);
    EXPECT_EQ(partial_balance(-0.01, 0.05), 0.0);
}

std::vector<PartialContactPoint> simulated_points(double work) {
    std::vector<PartialContactPoint> pairs;
    for (const double r : {1.1, 1.4, 1.7})
        for (const double stored : {0.004, 0.02, 0.05}) {
            PartialContactPoint pair;
            pair.gained.surface = std::to_string(r);
            pair.gained.elastomer = std::to_string(stored);
            pair.gained.slope = r;
            pair.gained.offset = 0.025 * (r - 1.0);
            pair.stored_energy = stored * r;
            pair.gained.measured.value = pair.prediction(work);
            pairs.push_back(pair);
        }
    return pairs;
}

TEST(ScorePartialContact, RecoversTheTrueWork) {
    for (const double work : {0.03, 0.05}) {
        const auto score = score_partial_contact(simulated_points(work));
        EXPECT_NEAR(score.work_of_adhesion, work, 1e-7);
        EXPECT_NEAR(score.r_squared, 1.0, 1e-9);
        EXPECT_NEAR(score.left_out_deviation, 0.0, 1e-8);
        EXPECT_EQ(score.n, 9);
    }
    EXPECT_THROW((void)score_partial_contact({}), InvalidArgument);
}

}  // namespace
}  // namespace setae::adhesion::partial_contact_test
