// SPDX-License-Identifier: GPL-3.0-or-later
#include "contours/mask_outline.hpp"

#include <gtest/gtest.h>

namespace setae::imaging::mask_outline_test {
namespace {

/// The area to the right of a closed curve, by the shoelace formula with y downwards: positive around the sample.
double area(const PlaneCurve& curve) {
    double sum = 0;
    for (Index i = 0; i < curve.size(); ++i) {
        const Index next = curve.at(i + 1);
        sum += curve.x[i] * curve.y[next] - curve.x[next] * curve.y[i];
    }
    return 0.5 * sum;
}

TEST(MaskOutline, OfOnePixelIsASquareAroundItsCentre) {
    PixelMask mask = PixelMask::Zero(5, 6);
    mask(2, 3) = 1;
    const auto found = outlines(mask);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].closed);
    EXPECT_EQ(found[0].size(), 4);
    EXPECT_DOUBLE_EQ(found[0].x.mean(), 3);
    EXPECT_DOUBLE_EQ(found[0].y.mean(), 2);
    EXPECT_DOUBLE_EQ(area(found[0]), 1);
    EXPECT_DOUBLE_EQ(found[0].length(), 4);
}

TEST(MaskOutline, RunsAroundHolesInTheOppositeDirection) {
    PixelMask mask = PixelMask::Zero(9, 9);
    mask.block(2, 2, 5, 5) = 1;
    mask(4, 4) = 0;
    const auto found = outlines(mask);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_DOUBLE_EQ(area(found[0]), 25);
    EXPECT_DOUBLE_EQ(area(found[1]), -1);
}

TEST(MaskOutline, RunsFromSideToSideWithVacuumOnTheLeft) {
    PixelMask mask = PixelMask::Zero(6, 8);
    mask.bottomRows(3) = 1;
    const auto found = outlines(mask);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].closed);
    EXPECT_DOUBLE_EQ(found[0].x[0], -0.5);
    EXPECT_DOUBLE_EQ(found[0].x[found[0].size() - 1], 7.5);
    EXPECT_DOUBLE_EQ(found[0].y[0], 2.5);
    mask = 1 - mask;
    EXPECT_DOUBLE_EQ(outlines(mask)[0].x[0], 7.5);
}

TEST(MaskOutline, SeparatesPartsThatTouchAtACorner) {
    PixelMask mask = PixelMask::Zero(5, 5);
    mask(1, 1) = mask(2, 2) = 1;
    EXPECT_EQ(outlines(mask).size(), 2U);
}

TEST(MaskOutline, OfAUniformMaskIsEmpty) {
    EXPECT_TRUE(outlines(PixelMask::Zero(4, 4)).empty());
    EXPECT_TRUE(outlines(PixelMask::Ones(4, 4)).empty());
}

}  // namespace
}  // namespace setae::imaging::mask_outline_test
