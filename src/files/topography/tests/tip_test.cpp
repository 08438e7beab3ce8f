// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/tip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography::tip_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

ArrayTip roof() {
    ArrayTip tip{Array2D(3, 3), {2.0, 1.0}, 1, 1};
    tip.heights << 4, 3, 4,  //
        1, 0, 1,             //
        infinite, 5, infinite;
    return tip;
}

TEST(TipHeight, OfASphereIsTheLowerHemisphere) {
    EXPECT_EQ(tip_height(SphereTip{5.0}, 0.0), 0.0);
    EXPECT_DOUBLE_EQ(tip_height(SphereTip{5.0}, 3.0), 1.0);
    EXPECT_DOUBLE_EQ(tip_height(SphereTip{5.0}, 5.0), 5.0);
    EXPECT_EQ(tip_height(SphereTip{5.0}, 5.1), infinite);
    // r²/(2R) at small distances, where R − √(R² − r²) cancels
    EXPECT_NEAR(tip_height(SphereTip{1.0}, 1e-9), 0.5e-18, 1e-33);
}

TEST(TipHeight, OfAConeContinuesTheSphereWithEqualSlope) {
    const ConeTip cone{pi / 6.0, 2.0};
    const double end = 2.0 * std::cos(pi / 6.0), step = 1e-6;
    EXPECT_NEAR(tip_height(cone, end), 1.0, 1e-12);  // R (1 − sin 30°)
    const double below = (tip_height(cone, end) - tip_height(cone, end - step)) / step;
    const double above = (tip_height(cone, end + step) - tip_height(cone, end)) / step;
    EXPECT_NEAR(above, 1.0 / std::tan(pi / 6.0), 1e-8);
    EXPECT_NEAR(below, above, 1e-5);  // half the step times t'' = 8/R
    EXPECT_DOUBLE_EQ(tip_height(ConeTip{pi / 4.0, 0.0}, 3.0), 3.0);
}

TEST(TipHeight, OfAParaboloidIsQuadratic) { EXPECT_DOUBLE_EQ(tip_height(ParabolicTip{4.0}, 2.0), 0.5); }

TEST(TipReach, InvertsTheProfile) {
    for (const Tip& tip : {Tip(SphereTip{3.0}), Tip(ConeTip{0.5, 1.0}), Tip(ConeTip{0.7, 0.0}), Tip(ParabolicTip{2.0})})
        for (const double distance : {0.0, 0.1, 0.6, 1.3, 2.5})
            EXPECT_NEAR(tip_reach(tip, tip_height(tip, distance)), distance, 1e-12);
    EXPECT_EQ(tip_reach(SphereTip{3.0}, 100.0), 3.0);
}

TEST(TipReach, OfAnArrayIsItsFarthestPointBelowTheHeight) {
    EXPECT_EQ(tip_reach(roof(), 0.5), 0.0);
    EXPECT_EQ(tip_reach(roof(), 1.0), 1.0);
    EXPECT_EQ(tip_reach(roof(), 3.5), 2.0);
    EXPECT_DOUBLE_EQ(tip_reach(roof(), infinite), std::sqrt(5.0));
}

TEST(TipImage, HasItsApexInTheMiddleAndTheProfileAround) {
    const auto image = tip_image(SphereTip{5.0}, 1.0, 2.0, 6.0);
    ASSERT_EQ(image.heights.rows(), 13);
    ASSERT_EQ(image.heights.cols(), 7);
    EXPECT_EQ(image.heights(image.centre_x, image.centre_y), 0.0);
    EXPECT_DOUBLE_EQ(image.heights(image.centre_x + 3, image.centre_y), 1.0);
    EXPECT_DOUBLE_EQ(image.heights(image.centre_x, image.centre_y - 2), 2.0);
    EXPECT_EQ(image.heights(0, 0), infinite);
}

TEST(TipImage, OfAnArrayOnItsOwnPixelsIsTheArray) {
    const auto tip = roof();
    const auto image = tip_image(tip, 2.0, 1.0, tip_reach(tip, infinite));
    EXPECT_TRUE((image.heights.block(image.centre_x - 1, image.centre_y - 1, 3, 3) == tip.heights).all());
    EXPECT_EQ(image.heights(image.centre_x, image.centre_y + 2), infinite);
}

TEST(TipImage, OfAnArrayOnFinerPixelsIsInterpolated) {
    const auto image = tip_image(roof(), 1.0, 0.5, 1.0);
    EXPECT_DOUBLE_EQ(image.heights(image.centre_x - 1, image.centre_y), 1.5);
    EXPECT_DOUBLE_EQ(image.heights(image.centre_x - 1, image.centre_y + 1), 2.0);  // mean of 3, 4, 0, 1
    EXPECT_EQ(image.heights(image.centre_x + 1, image.centre_y + 1), infinite);
    EXPECT_DOUBLE_EQ(image.heights(image.centre_x + 1, image.centre_y), 2.5);
}

TEST(Tip, OutsideItsDomainIsRefused) {
    EXPECT_THROW(validate(SphereTip{0.0}), InvalidArgument);
    EXPECT_THROW(validate(SphereTip{undefined}), InvalidArgument);
    EXPECT_THROW(validate(ParabolicTip{-1.0}), InvalidArgument);
    EXPECT_THROW(validate(ConeTip{0.0, 1.0}), InvalidArgument);
    EXPECT_THROW(validate(ConeTip{pi / 2.0, 1.0}), InvalidArgument);
    EXPECT_THROW(validate(ConeTip{0.5, -1.0}), InvalidArgument);
    auto tip = roof();
    tip.centre_x = 3;
    EXPECT_THROW(validate(tip), InvalidArgument);
    tip = roof();
    tip.heights(0, 0) = -1.0;
    EXPECT_THROW(validate(tip), InvalidArgument);
    tip = roof();
    tip.heights(1, 1) = 0.5;
    EXPECT_THROW(validate(tip), InvalidArgument);
    EXPECT_THROW((void)tip_height(roof(), 1.0), InvalidArgument);
    EXPECT_THROW((void)tip_height(SphereTip{1.0}, -1.0), InvalidArgument);
    EXPECT_THROW((void)tip_image(SphereTip{1.0}, 0.0, 1.0, 1.0), InvalidArgument);
    EXPECT_THROW((void)tip_image(SphereTip{1.0}, 1.0, 1.0, infinite), InvalidArgument);
    try {
        validate(ConeTip{3.0, 1.0});
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("half angle"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace setae::topography::tip_test
