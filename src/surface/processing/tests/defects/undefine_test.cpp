// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/undefine.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "record_number.hpp"
#include "setae/core/errors.hpp"
#include "setae/processing/step_text.hpp"

namespace setae::processing::undefine_test {
namespace {

topography::LineScan line_with_marks() {
    topography::LineScan scan{Array1D::LinSpaced(10, 0.0, 9e-6), 10e-6, false, {}};
    scan.heights[3] = scan.heights[7] = -9999.0 * 1e-6;
    return scan;
}

TEST(Undefine, RemovesHeightsOfAValue) {
    const auto processed = apply(Undefine{.value = -9999e-6}, line_with_marks());
    EXPECT_TRUE(std::isnan(line_of(processed).heights[3]));
    EXPECT_TRUE(std::isnan(line_of(processed).heights[7]));
    EXPECT_EQ(line_of(processed).heights.isNaN().count(), 2);
    EXPECT_EQ(number_of(processed.record, "undefined_points"), 2.0);
    EXPECT_DOUBLE_EQ(number_of(processed.record, "undefined_share"), 0.2);
}

TEST(Undefine, MatchesAValueRoundedToSinglePrecision) {
    auto scan = line_with_marks();
    scan.heights[3] = static_cast<double>(999.999f) * 1e-6;
    EXPECT_EQ(line_of(apply(Undefine{.value = 999.999e-6}, scan)).heights.isNaN().count(), 1);
}

TEST(Undefine, ZeroMatchesExactZeroOnly) {
    EXPECT_EQ(line_of(apply(Undefine{.value = 0.0}, line_with_marks())).heights.isNaN().count(), 1);
}

TEST(Undefine, RemovesHeightsBeyondLimits) {
    const auto left = line_of(apply(Undefine{.above = 7.5e-6, .below = 0.5e-6}, line_with_marks())).heights;
    EXPECT_EQ(left.isNaN().count(), 5);  // 0, 8, 9 µm and the two marks
    EXPECT_DOUBLE_EQ(left[1], 1e-6);
    EXPECT_DOUBLE_EQ(left[6], 6e-6);
}

TEST(Undefine, RemovesPointsOfAPolyline) {
    const topography::Profile profile{Array1D{{0.0, 1.0, 3.0, 4.0}}, Array1D{{1.0, -9999.0, 2.0, 3.0}}, {}};
    EXPECT_EQ(profile_of(apply(Undefine{.value = -9999.0}, profile)).positions.size(), 3);
}

TEST(Undefine, RefusesToRemoveNothingOrEverything) {
    EXPECT_THROW((void)apply(Undefine{}, line_with_marks()), InvalidArgument);
    EXPECT_THROW((void)apply(Undefine{.below = 1.0}, line_with_marks()), UndefinedDataError);
}

TEST(Undefine, IsWrittenAsTyped) {
    const auto step = step_from_text("undefine value=\"-9999 um\" above=\"1 mm\"");
    EXPECT_EQ(text(step), "undefine value=\"-9999 um\" above=\"1 mm\"");
    EXPECT_EQ(*std::get<Undefine>(step).value, -9999.0 * 1e-6);
}

}  // namespace
}  // namespace setae::processing::undefine_test
