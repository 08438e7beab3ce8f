// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/turn.hpp"

#include <gtest/gtest.h>

#include "record_number.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing::turn_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

HeightMap two_by_three() {
    HeightMap map{Array2D(2, 3), {2.0, 30.0}, true};
    map.heights << 1.0, 2.0, 3.0,  //
        4.0, 5.0, 6.0;
    return map;
}

TEST(Transpose, ExchangesAxesAndSizes) {
    const auto map = map_of(apply(Transpose{}, two_by_three()));
    ASSERT_EQ(map.heights.rows(), 3);
    EXPECT_EQ(map.heights(2, 0), 3.0);
    EXPECT_EQ(map.heights(0, 1), 4.0);
    EXPECT_EQ(map.size[0], 30.0);
    EXPECT_TRUE(map.periodic);
}

TEST(Flip, ReversesOneDirection) {
    EXPECT_EQ(map_of(apply(Flip{}, two_by_three())).heights(0, 0), 4.0);
    EXPECT_EQ(map_of(apply(Flip{Direction::y}, two_by_three())).heights(0, 0), 3.0);
    EXPECT_EQ(line_of(apply(Flip{}, LineScan{Array1D::LinSpaced(3, 0.0, 2.0), 3.0})).heights[0], 2.0);
    Profile profile{Array1D(3), Array1D(3), {}};
    profile.positions << 1.0, 2.0, 5.0;
    profile.heights << 7.0, 8.0, 9.0;
    const auto turned = profile_of(apply(Flip{}, profile));
    EXPECT_EQ(turned.positions[1], 4.0);
    EXPECT_EQ(turned.heights[0], 9.0);
    EXPECT_THROW((void)apply(Flip{Direction::y}, profile), InvalidArgument);
}

TEST(QuarterTurns, RotateXTowardsY) {
    HeightMap map{Array2D::Zero(5, 4), {5.0, 4.0}};
    map.heights(4, 0) = 1.0;  // at the end of x
    const auto once = map_of(apply(QuarterTurns{}, map));
    ASSERT_EQ(once.heights.rows(), 4);
    EXPECT_EQ(once.heights(3, 4), 1.0);  // the end of x is the end of y now, the beginning of y the end of x
    EXPECT_EQ(map_of(apply(QuarterTurns{2}, map)).heights(0, 3), 1.0);
    EXPECT_EQ(map_of(apply(QuarterTurns{3}, map)).heights(0, 0), 1.0);
    EXPECT_TRUE((map_of(apply(QuarterTurns{-1}, map)).heights == map_of(apply(QuarterTurns{3}, map)).heights).all());
    EXPECT_TRUE((map_of(apply(QuarterTurns{4}, map)).heights == map.heights).all());
    EXPECT_TRUE((map_of(apply(QuarterTurns{-3}, once)).heights == map_of(apply(QuarterTurns{2}, map)).heights).all());
}

TEST(QuarterTurns, RequireAMapAsDoesTranspose) {
    const LineScan scan{Array1D::Zero(5), 1.0};
    EXPECT_THROW((void)apply(QuarterTurns{}, scan), InvalidArgument);
    EXPECT_THROW((void)apply(Transpose{}, scan), InvalidArgument);
}

}  // namespace
}  // namespace setae::processing::turn_test
