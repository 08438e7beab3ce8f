// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/true_area.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::roughness::true_area_test {
namespace {

TEST(GaussianAreaRatio, OfAFlatSurfaceIsOne) {
    EXPECT_EQ(gaussian_area_ratio(0.0), 1.0);
    EXPECT_EQ(area_excess_factor(0.0), 1.0);
}

TEST(GaussianAreaRatio, HasTheLimitsOfSmallAndLargeSlopes) {
    EXPECT_NEAR((gaussian_area_ratio(1e-3) - 1.0) / (small_slope_area_ratio(1e-3) - 1.0), 1.0, 1e-6);
    EXPECT_NEAR(gaussian_area_ratio(1e6) / (0.5 * std::sqrt(pi) * 1e6), 1.0, 2e-6);
    EXPECT_NEAR(area_excess_factor(1.0), 0.7579, 5e-5);  // THEORY §6
}

TEST(GaussianAreaRatio, IsTheMeanOverAGaussianDistributionOfGradients) {
    // ∫ sqrt(1 + s²) 2s/h'² exp(−s²/h'²) ds by the midpoint rule, an independent route
    for (const double slope : {0.1, 0.39, 1.0, 1.46, 5.0}) {
        double mean = 0.0;
        const int n = 200000;
        for (int i = 0; i < n; ++i) {
            const double p = (i + 0.5) / n;  // quantiles of s²/h'² are −log p
            mean += std::sqrt(1.0 - slope * slope * std::log(p)) / n;
        }
        EXPECT_NEAR(gaussian_area_ratio(slope), mean, 2e-5 * mean) << slope;
    }
}

TEST(GaussianAreaRatio, RefusesANegativeSlope) { EXPECT_THROW((void)gaussian_area_ratio(-1.0), InvalidArgument); }

topography::HeightMap plane(double slope_x, double slope_y) {
    topography::HeightMap map{Array2D(20, 30), {4.0, 3.0}};
    const auto [dx, dy] = map.pixel_size();
    for (Index i = 0; i < 20; ++i)
        for (Index j = 0; j < 30; ++j)
            map.heights(i, j) = slope_x * static_cast<double>(i) * dx + slope_y * static_cast<double>(j) * dy;
    return map;
}

TEST(TriangulatedArea, OfAPlaneIsExact) {
    const auto area = triangulated_area(plane(0.3, -1.2));
    EXPECT_NEAR(area.area_ratio, std::sqrt(1.0 + 0.09 + 1.44), 1e-13);
    EXPECT_NEAR(area.rms_slope, std::hypot(0.3, 1.2), 1e-13);
    EXPECT_EQ(area.cells, 19 * 29);
}

TEST(TriangulatedArea, SkipsCellsWithUndefinedCorners) {
    auto map = plane(1.0, 0.0);
    map.heights(5, 5) = undefined;
    const auto area = triangulated_area(map);
    EXPECT_EQ(area.cells, 19 * 29 - 4);
    EXPECT_NEAR(area.area_ratio, std::sqrt(2.0), 1e-13);
    map.heights.setConstant(undefined);
    EXPECT_THROW((void)triangulated_area(map), UndefinedDataError);
}

TEST(TriangulatedArea, IsTheSameForAnyNumberOfThreads) {
    topography::HeightMap map{Array2D::Random(257, 129), {1.0, 1.0}};
    const auto one = triangulated_area(map, {1}), three = triangulated_area(map, {3});
    EXPECT_EQ(one.area_ratio, three.area_ratio);
    EXPECT_EQ(one.rms_slope, three.rms_slope);
}

}  // namespace
}  // namespace setae::roughness::true_area_test
