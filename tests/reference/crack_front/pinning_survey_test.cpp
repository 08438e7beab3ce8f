// SPDX-License-Identifier: GPL-3.0-or-later
#include "pinning_survey.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "round_contacts.hpp"
#include "setae/crack_front/pinning.hpp"
#include "setae/hysteresis/pinning_law.hpp"

namespace pinning_survey_test {

// the long fronts are in docs/validation/crack-front.md
TEST(PinningSurvey, FrontBelowItsLarkinLengthHasAlmostNoLoss) {
    const auto weak = pinning_survey::run({.energy_share = 0.01, .way = 128, .width = 64}, 1.0);
    EXPECT_TRUE(weak.converged);
    EXPECT_LT(weak.larkin_lengths, 0.3);
    EXPECT_LT(weak.pinning_coefficient, 0.5);
}

TEST(PinningSurvey, LongFrontLosesTwiceKTimesTheStoredEnergy) {
    const auto strong = pinning_survey::run({.energy_share = 0.1, .way = 256, .width = 512}, 1.0);
    EXPECT_TRUE(strong.converged);
    EXPECT_GT(strong.larkin_lengths, 5.0);
    EXPECT_NEAR(strong.pinning_coefficient, 2.02, 0.4);
}

// the program's table against fronts four times as wide as their springs let them bend, three seeds
TEST(PinningSurvey, StaticFrontsHaveThePinningCoefficientsOfBothBranches) {
    struct Front {
        double energy_share, spring_length;
    };
    for (const auto& front : {Front{0.3, 128.0}, Front{0.1, 128.0}, Front{0.03, 144.0}}) {
        double approach = 0.0, retraction = 0.0, squares = 0.0, lengths = 0.0;
        constexpr int seeds = 3;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const auto result = pinning_survey::run({.energy_share = front.energy_share,
                                                     .way = 256,
                                                     .width = 512,
                                                     .spring_length = front.spring_length,
                                                     .seed = seed},
                                                    2.0);
            EXPECT_TRUE(result.converged);
            approach -= result.approach / seeds;
            retraction += result.retraction / seeds;
            squares += (result.approach * result.approach + result.retraction * result.retraction) / (2 * seeds);
            lengths += result.larkin_lengths / seeds;
        }
        const auto k = setae::hysteresis::pinning_constants(front.energy_share, lengths);
        EXPECT_TRUE(k.measured);
        const double mean = 0.5 * (approach + retraction);
        const double error = std::hypot(k.approach.standard_error, std::sqrt((squares - mean * mean) / (seeds - 1)));
        EXPECT_NEAR(approach, k.approach.value, 2.0 * error) << front.energy_share;
        EXPECT_NEAR(retraction, k.retraction.value, 2.0 * error) << front.energy_share;
    }
}

// loops of round contacts, not the formula: U and the spectrum give k, and k and either branch give W
TEST(PinningSurvey, EitherBranchOfARoundContactRecoversTheTrueWork) {
    using namespace setae;
    const contact::AdhesiveContact sphere{round_contacts::radius, round_contacts::contact_modulus,
                                          round_contacts::work_of_adhesion};
    for (const auto& edge : round_contacts::edge_works) {
        double larkin_length = 0.0;
        for (const auto& loop : round_contacts::fitted_works)
            if (loop.seed == edge.seed && std::abs(loop.energy_share - edge.energy_share) < 1e-3)
                larkin_length = loop.larkin_length;
        const double length = crack_front::free_length(edge.contact_radius, sphere) / larkin_length;
        EXPECT_NEAR(length / edge.larkin_lengths, 1.0, 0.1);
        const auto k = hysteresis::pinning_constants(edge.energy_share, length).approach;
        const double stored = edge.energy_share * round_contacts::work_of_adhesion;
        const double found = edge.work + (edge.approach ? 1.0 : -1.0) * k.value * stored;
        EXPECT_NEAR(found, round_contacts::work_of_adhesion, 2.0 * k.standard_error * stored)
            << edge.energy_share << ' ' << edge.seed << ' ' << edge.contact_radius;
    }
}

TEST(PinningSurvey, SeparateBandsLoseAboutAsMuchAsBothTogether) {
    const auto result = pinning_survey::run_in_bands({.energy_share = 0.1, .way = 256, .width = 512}, 1.0);
    EXPECT_TRUE(result.together.converged && result.apart.converged);
    EXPECT_GT(result.fine_share, 0.2);
    EXPECT_LT(result.fine_share, 0.5);
    EXPECT_NEAR(result.apart.pinning_coefficient / result.together.pinning_coefficient, 1.0, 0.35);
}

}  // namespace pinning_survey_test
