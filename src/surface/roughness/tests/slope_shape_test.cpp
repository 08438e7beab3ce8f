// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/slope_shape.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::roughness::slope_shape_test {
namespace {

/// Many plane waves of sixteen to a hundred points, so slopes are Gaussian and differences are derivatives.
topography::HeightMap smooth_map(double stretch) {
    constexpr Index points = 256;
    constexpr int waves = 120;
    constexpr double pixel = 1e-9;
    std::mt19937_64 engine(7);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const Array1D place = Array1D::LinSpaced(points, 0.0, (points - 1) * pixel);
    topography::HeightMap map{Array2D::Zero(points, points), {points * pixel, points * pixel}, false, {}};
    for (int wave = 0; wave < waves; ++wave) {
        const double q = 2.0 * pi / (16.0 * pixel * std::pow(6.0, uniform(engine))), angle = pi * uniform(engine),
                     phase = 2.0 * pi * uniform(engine);
        const Array1D x = q * std::cos(angle) / stretch * place + phase, y = q * std::sin(angle) * place;
        const double amplitude = 1.0 / (q * std::sqrt(static_cast<double>(waves)));
        map.heights +=
            amplitude *
            (x.cos().matrix() * y.cos().matrix().transpose() - x.sin().matrix() * y.sin().matrix().transpose()).array();
    }
    return map;
}

TEST(SlopeShape, OfGaussianSlopesGivesTheGaussianArea) {
    const auto shape = slope_shape(smooth_map(1.0), {1});
    EXPECT_NEAR(shape.share.sum(), 1.0, 1e-12);
    EXPECT_NEAR((shape.share * shape.square).sum(), 1.0, 1e-9);
    for (const double slope : {0.1, 0.5, 1.0, 3.0})
        EXPECT_NEAR((shape.area_ratio(slope) - 1.0) / (gaussian_area_ratio(slope) - 1.0), 1.0, 0.01) << slope;
}

TEST(SlopeShape, GivesTheTriangulatedAreaAtTheMeasuredSlope) {
    auto map = smooth_map(2.0);
    map.heights = (map.heights / 4e-9).exp() * 4e-9;  // log-normal
    const auto area = triangulated_area(map, {1});
    const auto shape = slope_shape(map, {1});
    EXPECT_NEAR((shape.area_ratio(area.rms_slope) - 1.0) / (area.area_ratio - 1.0), 1.0, 1e-4);
    // and that of the surface stretched in height
    map.heights *= 3.0;
    const auto higher = triangulated_area(map, {1});
    EXPECT_NEAR((shape.area_ratio(higher.rms_slope) - 1.0) / (higher.area_ratio - 1.0), 1.0, 1e-4);
    EXPECT_GT(std::abs(gaussian_area_ratio(higher.rms_slope) / higher.area_ratio - 1.0), 0.02) << "(9) would do";
}

TEST(SlopeShape, HasTheSameBytesForAnyThreadsAndIgnoresGaps) {
    auto map = smooth_map(1.0);
    map.heights(10, 10) = undefined;
    const auto one = slope_shape(map, {1}), four = slope_shape(map, {4});
    EXPECT_TRUE((one.share == four.share).all());
    EXPECT_TRUE((one.square == four.square).all());
    const auto stretched = slope_shape(smooth_map(3.0), {1});
    EXPECT_NEAR(mean_shape({{one, 1.0}, {one, 2.0}}).area_ratio(1.0), one.area_ratio(1.0), 1e-12);
    EXPECT_NEAR(mean_shape({{one, 1.0}, {stretched, 3.0}}).area_ratio(1.0),
                0.25 * one.area_ratio(1.0) + 0.75 * stretched.area_ratio(1.0), 1e-5);
    map.heights.setZero();
    EXPECT_THROW((void)slope_shape(map, {1}), UndefinedDataError);
    EXPECT_THROW((void)mean_shape({}), InvalidArgument);
}

}  // namespace
}  // namespace setae::roughness::slope_shape_test
