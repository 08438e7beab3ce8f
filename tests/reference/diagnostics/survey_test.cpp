// SPDX-License-Identifier: GPL-3.0-or-later
// The survey of docs/reference/diagnostics.md, shortened: what stands there is its 100 surfaces of each kind.
#include "survey.hpp"

#include <gtest/gtest.h>

namespace setae::reference::survey_test {
namespace {

TEST(DiagnosticsSurvey, FindsSpikesInMapsWithoutFalseWarnings) {
    const auto survey = survey_maps(12);
    EXPECT_LE(survey.alarmed, 1);
    EXPECT_GE(survey.found_share(), 0.95);
}

TEST(DiagnosticsSurvey, FindsSpikesInLinesWithoutFalseWarnings) {
    const auto survey = survey_lines(24);
    EXPECT_LE(survey.alarmed, 2);
    EXPECT_GE(survey.found_share(), 0.95);
}

}  // namespace
}  // namespace setae::reference::survey_test
