// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/blind_tip.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/dilation.hpp"

namespace setae::topography::blind_tip_test {
namespace {

HeightMap spikes(bool periodic) {
    HeightMap surface{Array2D::Zero(60, 60), {60.0, 60.0}, periodic};
    surface.heights(20, 22) = 30.0;
    surface.heights(42, 40) = 25.0;
    return surface;
}

/// A paraboloid that ends at an edge.
ArrayTip paraboloid(double radius, Index reach_x, Index reach_y) {
    ArrayTip tip{Array2D(2 * reach_x + 1, 2 * reach_y + 1), {1.0, 1.0}, reach_x, reach_y};
    for (Index i = -reach_x; i <= reach_x; ++i)
        for (Index j = -reach_y; j <= reach_y; ++j)
            tip.heights(i + reach_x, j + reach_y) = static_cast<double>(i * i + j * j) / (2.0 * radius);
    return tip;
}

TEST(BlindTip, OfSpikesEqualsTheTip) {
    for (const bool periodic : {false, true}) {
        const auto tip = paraboloid(3.0, 5, 4);
        const auto blind = blind_tip(dilated(spikes(periodic), tip), {.points_x = 11, .points_y = 9});
        EXPECT_TRUE(blind.converged);
        EXPECT_EQ(blind.tip.heights.rows(), 11);
        EXPECT_EQ(blind.tip.heights.cols(), 9);
        EXPECT_LT((blind.tip.heights - tip.heights).abs().maxCoeff(), 1e-10);
    }
}

TEST(BlindTip, OfSpikesRecoversAnAsymmetricTip) {
    ArrayTip tip{Array2D(5, 5), {1.0, 1.0}, 2, 2};
    for (Index i = 0; i < 5; ++i)
        for (Index j = 0; j < 5; ++j)
            tip.heights(i, j) =
                (i < 2 ? 3.0 : 1.0) * std::abs(static_cast<double>(i - 2)) + 0.5 * std::abs(static_cast<double>(j - 2));
    const auto blind = blind_tip(dilated(spikes(false), tip), {.points_x = 5, .points_y = 5});
    EXPECT_LT((blind.tip.heights - tip.heights).abs().maxCoeff(), 1e-10);
}

TEST(BlindTip, IsNeverSharperThanTheTipAndReproducesTheImage) {
    const auto tip = paraboloid(2.0, 5, 5);
    for (const unsigned seed : {1u, 2u, 3u}) {
        const HeightMap surface{tests::random_map(50, 50, seed), {50.0, 50.0}, true};
        const auto image = dilated(surface, tip);
        const auto blind = blind_tip(image, {.points_x = 11, .points_y = 11});
        EXPECT_TRUE(blind.converged);
        EXPECT_LT((blind.tip.heights - tip.heights).maxCoeff(), 1e-12);
        EXPECT_GT(blind.tip.heights(4, 5), 0.2);  // of 0.25: rough enough to determine the apex
        const auto opened = dilated(eroded(image, blind.tip), blind.tip);
        EXPECT_LT((image.heights - opened.heights).maxCoeff(), 1e-10);
    }
}

TEST(BlindTip, IsNotSharpenedByNoiseForAThresholdOfTwiceTheNoise) {
    const auto tip = paraboloid(2.0, 4, 4);
    auto image = dilated(HeightMap{tests::random_map(50, 50, 5), {50.0, 50.0}, true}, tip);
    const Array2D noise = 0.02 * tests::random_map(50, 50, 6).max(-1.0).min(1.0);
    image.heights += noise;
    const auto blind = blind_tip(image, {.points_x = 9, .points_y = 9, .noise_threshold = 0.04});
    EXPECT_LT((blind.tip.heights - tip.heights).maxCoeff(), 1e-12);
    EXPECT_GT(blind.tip.heights(0, 0), 1.0);
    const auto fooled = blind_tip(image, {.points_x = 9, .points_y = 9});
    EXPECT_GT((fooled.tip.heights - tip.heights).maxCoeff(), 0.0);
}

TEST(BlindTip, OfAFlatImageIsFlat) {
    const auto blind = blind_tip(HeightMap{Array2D::Zero(30, 30), {30.0, 30.0}}, {.points_x = 7, .points_y = 7});
    EXPECT_EQ(blind.tip.heights.maxCoeff(), 0.0);
    EXPECT_TRUE(blind.converged);
}

TEST(BlindTip, IgnoresPointsNearUndefinedHeights) {
    auto image = dilated(spikes(false), paraboloid(3.0, 2, 2));
    image.heights(30, 30) = undefined;
    const auto blind = blind_tip(image, {.points_x = 5, .points_y = 5});
    EXPECT_LT((blind.tip.heights - paraboloid(3.0, 2, 2).heights).abs().maxCoeff(), 1e-10);
    image.heights.block(5, 5, 50, 50).setConstant(undefined);
    EXPECT_THROW((void)blind_tip(image, {.points_x = 5, .points_y = 5}), UndefinedDataError);
}

TEST(BlindTip, IsTheSameForAnyNumberOfThreads) {
    const auto image = dilated(HeightMap{tests::random_map(50, 60, 9), {50.0, 60.0}}, SphereTip{3.0});
    const auto one = blind_tip(image, {.points_x = 7, .points_y = 7, .threads = {1}});
    const auto three = blind_tip(image, {.points_x = 7, .points_y = 7, .threads = {3}});
    EXPECT_TRUE((one.tip.heights == three.tip.heights).all());
    EXPECT_EQ(one.rounds, three.rounds);
}

TEST(BlindTip, RefusesExtentsThatAreEvenOrTooLarge) {
    const HeightMap map{Array2D::Zero(30, 30), {30.0, 30.0}};
    EXPECT_THROW((void)blind_tip(map, {.points_x = 6}), InvalidArgument);
    EXPECT_THROW((void)blind_tip(map, {.points_x = 17, .points_y = 17}), InvalidArgument);
    EXPECT_THROW((void)blind_tip(map, {.points_x = 3, .points_y = 3, .noise_threshold = -1.0}), InvalidArgument);
    EXPECT_THROW((void)blind_tip(map, {.points_x = 3, .points_y = 3, .rounds = 0}), InvalidArgument);
}

}  // namespace
}  // namespace setae::topography::blind_tip_test
