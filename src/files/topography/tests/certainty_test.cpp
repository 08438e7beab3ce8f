// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/certainty.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography::certainty_test {
namespace {

HeightMap rough_map(Index nx, Index ny, bool periodic) {
    return {tests::random_map(nx, ny, 3), {static_cast<double>(nx), static_cast<double>(ny)}, periodic};
}

TEST(Certainty, CertainPointsEqualTheTrueSurface) {
    for (const bool periodic : {false, true}) {
        const auto surface = rough_map(60, 50, periodic);
        const Tip tip = ParabolicTip{1.0};
        const auto certainty = certainty_map(dilated(surface, tip), tip);
        EXPECT_GT(certainty.share, 0.1);
        EXPECT_LT(certainty.share, 0.9);
        for (Index i = 0; i < 60; ++i)
            for (Index j = 0; j < 50; ++j) {
                const double excess = certainty.reconstruction.heights(i, j) - surface.heights(i, j);
                EXPECT_GE(excess, -1e-12);
                if (certainty.certain(i, j)) {
                    EXPECT_LT(excess, 1e-8) << i << ' ' << j << ' ' << periodic;
                }
            }
    }
}

TEST(Certainty, ExcludesTheHiddenZoneAroundASpike) {
    HeightMap surface{Array2D::Zero(41, 41), {41.0, 41.0}, true};
    surface.heights(20, 20) = 3.0;
    const Tip tip = ParabolicTip{4.0};  // the hidden zone of the spike ends at √(2·4·3) = 4.9
    const auto certainty = certainty_map(dilated(surface, tip), tip);
    EXPECT_EQ(certainty.certain(20, 20), 1);
    EXPECT_EQ(certainty.certain(21, 20), 0);
    EXPECT_EQ(certainty.certain(20, 24), 0);
    EXPECT_EQ(certainty.certain(20, 26), 1);
    EXPECT_GT(certainty.reconstruction.heights(21, 20), 0.1);
}

TEST(Certainty, ExcludesPointsThatTheSurfaceOutsideCouldAffect) {
    // the map is a part of a larger one: surface outside lifts the tip inside
    const auto whole = rough_map(80, 80, false);
    const Tip tip = ParabolicTip{6.0};
    const auto image = dilated(whole, tip);
    const HeightMap part{image.heights.block(20, 20, 30, 40), {30.0, 40.0}};
    const auto certainty =
        certainty_map(part, tip, {.height_range = whole.heights.maxCoeff() - whole.heights.minCoeff()});
    EXPECT_GT(certainty.share, 0.01);
    for (Index i = 0; i < 30; ++i)
        for (Index j = 0; j < 40; ++j)
            if (certainty.certain(i, j)) {
                EXPECT_LT(certainty.reconstruction.heights(i, j) - whole.heights(20 + i, 20 + j), 1e-8);
            }
}

TEST(Certainty, ExcludesPointsThatAHoleCouldAffect) {
    const auto whole = rough_map(50, 50, true);
    const Tip tip = ParabolicTip{4.0};
    auto image = dilated(whole, tip);
    image.heights.block(20, 20, 8, 9).setConstant(undefined);
    const auto certainty = certainty_map(image, tip);
    EXPECT_EQ(certainty.reconstruction.heights.isNaN().count(), 72);
    for (Index i = 0; i < 50; ++i)
        for (Index j = 0; j < 50; ++j)
            if (certainty.certain(i, j)) {
                EXPECT_LT(certainty.reconstruction.heights(i, j) - whole.heights(i, j), 1e-8) << i << ' ' << j;
            }
}

TEST(Certainty, RefusesANegativeTolerance) {
    EXPECT_THROW((void)certainty_map(rough_map(20, 20, true), ParabolicTip{1.0}, {}, -1.0), InvalidArgument);
}

}  // namespace
}  // namespace setae::topography::certainty_test
