// SPDX-License-Identifier: GPL-3.0-or-later
// The survey of docs/concepts/self-affine-fit.md, shortened.
#include "survey.hpp"

#include <gtest/gtest.h>

namespace setae::reference::survey_test {
namespace {

TEST(SelfAffineSurvey, RecoversHurstExponentsOfSyntheticSurfaces) {
    const auto survey = survey_twins(2);
    EXPECT_LT(survey.rms_error, 0.02);
    EXPECT_GE(survey.hurst_covered, 1);
}

}  // namespace
}  // namespace setae::reference::survey_test
