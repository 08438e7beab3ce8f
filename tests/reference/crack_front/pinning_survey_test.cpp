// SPDX-License-Identifier: GPL-3.0-or-later
#include "pinning_survey.hpp"

#include <gtest/gtest.h>

namespace pinning_survey_test {

// the long fronts are in docs/measured/crack-front.md
TEST(PinningSurvey, AFrontBelowItsLarkinLengthHardlyLoses) {
    const auto weak = pinning_survey::run({.energy_share = 0.01, .way = 128, .width = 64}, 1.0);
    EXPECT_TRUE(weak.converged);
    EXPECT_LT(weak.larkin_lengths, 0.3);
    EXPECT_LT(weak.pinning_coefficient, 0.5);
}

TEST(PinningSurvey, ALongFrontLosesTwiceKTimesTheStoredEnergy) {
    const auto strong = pinning_survey::run({.energy_share = 0.1, .way = 256, .width = 512}, 1.0);
    EXPECT_TRUE(strong.converged);
    EXPECT_GT(strong.larkin_lengths, 5.0);
    EXPECT_NEAR(strong.pinning_coefficient, 2.02, 0.4);
}

TEST(PinningSurvey, TwoBandsAfterEachOtherLoseAboutWhatTheyDoTogether) {
    const auto result = pinning_survey::run_in_bands({.energy_share = 0.1, .way = 256, .width = 512}, 1.0);
    EXPECT_TRUE(result.together.converged && result.apart.converged);
    EXPECT_GT(result.fine_share, 0.2);
    EXPECT_LT(result.fine_share, 0.5);
    EXPECT_NEAR(result.apart.pinning_coefficient / result.together.pinning_coefficient, 1.0, 0.35);
}

}  // namespace pinning_survey_test
