// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/processing/rotate.hpp"

namespace setae::processing::rotate_test {
namespace {

using topography::HeightMap;

constexpr double degree = std::numbers::pi / 180.0;

/// Heights about the middle point of a map.
template <class Function>
HeightMap about_middle(Index nx, Index ny, std::array<double, 2> pixel, const Function& height) {
    HeightMap map{Array2D(nx, ny), {pixel[0] * static_cast<double>(nx), pixel[1] * static_cast<double>(ny)}, false, {}};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            map.heights(i, j) = height(pixel[0] * (static_cast<double>(i) - 0.5 * static_cast<double>(nx - 1)),
                                       pixel[1] * (static_cast<double>(j) - 0.5 * static_cast<double>(ny - 1)));
    return map;
}

TEST(Rotate, RotatesFromXTowardsY) {
    const auto slope_x = [](double x, double) { return 2.0 * x; };
    const HeightMap map = about_middle(41, 31, {0.5, 0.25}, slope_x);
    for (const Rotation method : {Rotation::linear, Rotation::bicubic}) {
        const HeightMap turned = rotated(map, Rotate{.angle = 30.0 * degree, .method = method, .crop = true});
        const HeightMap expected = about_middle(
            turned.heights.rows(), turned.heights.cols(), {0.5, 0.25},
            [](double x, double y) { return 2.0 * (std::cos(30.0 * degree) * x + std::sin(30.0 * degree) * y); });
        EXPECT_FALSE(turned.heights.isNaN().any());
        EXPECT_LT((turned.heights - expected.heights).abs().maxCoeff(), 1e-12);
    }
}

TEST(Rotate, ByQuartersMovesPointsWithoutInterpolation) {
    HeightMap map{Array2D::Random(5, 3), {5.0, 6.0}, true, {}};
    const HeightMap turned = rotated(map, Rotate{.angle = 90.0 * degree});
    EXPECT_EQ(turned.shape(), (std::array<Index, 2>{3, 5}));
    EXPECT_EQ(turned.size, (std::array<double, 2>{6.0, 5.0}));
    EXPECT_TRUE(turned.periodic);
    EXPECT_EQ(turned.heights(2, 4), map.heights(4, 0));  // the end of the x-axis has become the end of the y-axis
    HeightMap around = map;
    for (int k = 0; k < 4; ++k) around = rotated(around, Rotate{.angle = 90.0 * degree});
    EXPECT_TRUE((around.heights == map.heights).all());
    EXPECT_TRUE(
        (rotated(map, Rotate{.angle = -90.0 * degree}).heights == rotated(map, Rotate{.angle = 270.0 * degree}).heights)
            .all());
    EXPECT_TRUE(
        (rotated(rotated(map, Rotate{.angle = 180.0 * degree}), Rotate{.angle = 180.0 * degree}).heights == map.heights)
            .all());
    EXPECT_TRUE((rotated(map, Rotate{.angle = 8.0 * std::numbers::pi}).heights == map.heights).all());
    // close to a quarter, interpolation gives nearly the same: the direction agrees
    map = about_middle(21, 21, {1.0, 1.0}, [](double x, double y) { return std::sin(0.2 * x) + 0.1 * y; });
    const Array2D quarter = rotated(map, Rotate{.angle = 90.0 * degree}).heights,
                  nearly = rotated(map, Rotate{.angle = 90.001 * degree}).heights;
    EXPECT_LT((quarter - nearly).block(1, 1, 19, 19).abs().maxCoeff(), 1e-3);
}

TEST(Rotate, PointsOutsideAreUndefinedUnlessCropped) {
    const HeightMap map = about_middle(40, 24, {1.0, 1.0}, [](double x, double y) { return x * y; });
    const HeightMap whole = rotated(map, Rotate{.angle = 20.0 * degree});
    EXPECT_EQ(whole.shape(), map.shape());
    EXPECT_TRUE(std::isnan(whole.heights(0, 0)));
    for (double angle = 1.0; angle < 90.0; angle += 7.0) {
        const HeightMap cropped = rotated(map, Rotate{.angle = angle * degree, .crop = true});
        EXPECT_FALSE(cropped.heights.isNaN().any()) << angle;
        EXPECT_GT(cropped.heights.size(), 100) << angle;
        EXPECT_NEAR(cropped.pixel_size()[0], 1.0, 1e-15);
    }
}

TEST(Rotate, ForwardAndBackReturnsSmoothHeights) {
    const HeightMap map =
        about_middle(120, 120, {1.0, 1.0}, [](double x, double y) { return std::cos(0.15 * x + 0.05 * y); });
    const HeightMap back = rotated(rotated(map, Rotate{.angle = 0.3, .method = Rotation::bicubic}),
                                   Rotate{.angle = -0.3, .method = Rotation::bicubic});
    EXPECT_LT((back.heights - map.heights).block(45, 45, 30, 30).abs().maxCoeff(), 1e-3);
}

TEST(Rotate, RefusesLinesAndInvalidAngles) {
    EXPECT_THROW((void)rotated(HeightMap{Array2D::Zero(3, 3), {1.0, 1.0}, false, {}},
                               Rotate{.angle = std::numeric_limits<double>::infinity()}),
                 InvalidArgument);
    EXPECT_THROW(
        (void)rotated(HeightMap{Array2D::Zero(40, 2), {40.0, 2.0}, false, {}}, Rotate{.angle = 0.5, .crop = true}),
        InvalidArgument);
    EXPECT_THROW((void)apply(Rotate{.angle = 0.1}, topography::LineScan{Array1D::Zero(4), 1.0, false, {}}),
                 InvalidArgument);
    EXPECT_GT(apply(Rotate{.angle = 0.3}, HeightMap{Array2D::Zero(9, 9), {1.0, 1.0}, false, {}})
                  .record.numbers.at(0)
                  .estimate.value,
              0.0);
}

TEST(Rotate, GivesTheSameBytesForAnyNumberOfThreads) {
    const HeightMap map{Array2D::Random(50, 60), {5.0, 6.0}, false, {}};
    const Array2D one = rotated(map, Rotate{.angle = 0.7, .crop = true}, {1}).heights,
                  three = rotated(map, Rotate{.angle = 0.7, .crop = true}, {3}).heights;
    EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
}

}  // namespace
}  // namespace setae::processing::rotate_test
