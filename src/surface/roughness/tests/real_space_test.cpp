// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/real_space.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::roughness::real_space_test {
namespace {

/// h = A cos(q_x x) + B cos(q_y y) with whole periods.
topography::HeightMap waves(Index nx, Index ny, bool periodic) {
    topography::HeightMap map{Array2D(nx, ny), {2.0, 3.0}, periodic};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            map.heights(i, j) = 0.2 * std::cos(2.0 * pi * 3.0 * static_cast<double>(i) / static_cast<double>(nx)) +
                                0.1 * std::cos(2.0 * pi * 5.0 * static_cast<double>(j) / static_cast<double>(ny));
    return map;
}

/// Symbol of a forward difference: rms of (cos(q(x+d)) − cos(qx))/d is √2 sin(qd/2)/d.
double slope_of_wave(double amplitude, double periods, double size, Index n) {
    const double d = size / static_cast<double>(n), q = 2.0 * pi * periods / size;
    return amplitude * std::sqrt(2.0) * std::sin(0.5 * q * d) / d;
}

TEST(RealSpaceParameters, OfCosinesMatchTheSymbolsOfDifferences) {
    const auto p = real_space_parameters(waves(64, 90, true));
    EXPECT_NEAR(p.rms_height, std::sqrt(0.5 * (0.04 + 0.01)), 1e-14);
    EXPECT_NEAR(p.rms_height_of_lines, 0.2 * std::sqrt(0.5), 1e-14);
    const double sx = slope_of_wave(0.2, 3.0, 2.0, 64), sy = slope_of_wave(0.1, 5.0, 3.0, 90);
    EXPECT_NEAR(p.rms_slope_x, sx, 1e-13);
    EXPECT_NEAR(p.rms_slope_y, sy, 1e-13);
    EXPECT_NEAR(p.rms_slope, std::hypot(sx, sy), 1e-13);
    // second difference of a cosine: its symbol is the square of the first's
    const double cx = sx * sx / 0.2 * std::sqrt(2.0), cy = sy * sy / 0.1 * std::sqrt(2.0);
    EXPECT_NEAR(p.rms_curvature, 0.5 * std::hypot(cx, cy), 1e-11);
    EXPECT_NEAR(p.mean_height, 0.0, 1e-14);
}

TEST(RealSpaceParameters, OfAParaboloidHaveItsCurvatureUpToTheBorders) {
    topography::HeightMap map{Array2D(40, 30), {4.0, 3.0}};
    for (Index i = 0; i < 40; ++i)
        for (Index j = 0; j < 30; ++j)
            map.heights(i, j) = 1e4 + 0.5 * (0.03 * static_cast<double>(i * i) + 0.02 * static_cast<double>(j * j));
    EXPECT_NEAR(real_space_parameters(map).rms_curvature, 0.5 * (3.0 + 2.0), 1e-8);
}

TEST(RealSpaceParameters, ExcludeDifferencesThatUseAHole) {
    // one hole removes 2 differences along x, 2 along y and 5 Laplacians: the slopes of the plane remain exact
    topography::HeightMap map{Array2D(10, 12), {1.0, 1.2}};
    for (Index i = 0; i < 10; ++i)
        for (Index j = 0; j < 12; ++j)
            map.heights(i, j) = 0.1 * (2.0 * static_cast<double>(i) - static_cast<double>(j));
    map.heights(4, 5) = undefined;
    const auto p = real_space_parameters(map);
    EXPECT_EQ(p.defined, 119);
    EXPECT_NEAR(p.rms_slope_x, 2.0, 1e-13);
    EXPECT_NEAR(p.rms_slope_y, 1.0, 1e-13);
    EXPECT_NEAR(p.rms_curvature, 0.0, 1e-12);
}

TEST(RealSpaceParameters, AreTheSameForAnyNumberOfThreads) {
    topography::HeightMap map{Array2D::Random(300, 77), {1.0, 1.0}};
    map.heights(7, 8) = undefined;
    const auto one = real_space_parameters(map, {1}), four = real_space_parameters(map, {4});
    EXPECT_EQ(one.rms_height, four.rms_height);
    EXPECT_EQ(one.rms_slope, four.rms_slope);
    EXPECT_EQ(one.rms_curvature, four.rms_curvature);
    EXPECT_EQ(one.rms_height_of_lines, four.rms_height_of_lines);
}

TEST(RealSpaceParameters, OfAMapAgreeWithThoseOfItsLines) {
    topography::HeightMap map{Array2D::Random(50, 9), {1.0, 1.0}};
    map.heights(20, 3) = undefined;
    double slope2 = 0.0, points = 0.0, variance = 0.0, defined = 0.0;
    for (Index j = 0; j < 9; ++j) {
        const auto line = real_space_parameters(topography::LineScan{map.heights.col(j), 1.0});
        const double differences = j == 3 ? 47.0 : 49.0;
        slope2 += line.rms_slope * line.rms_slope * differences;
        points += differences;
        variance += line.rms_height * line.rms_height * static_cast<double>(line.defined);
        defined += static_cast<double>(line.defined);
    }
    const auto p = real_space_parameters(map);
    EXPECT_NEAR(p.rms_slope_x, std::sqrt(slope2 / points), 1e-12);
    EXPECT_NEAR(p.rms_height_of_lines, std::sqrt(variance / defined), 1e-13);
}

TEST(RealSpaceParameters, OfATrianglePolylineAreExact) {
    topography::Profile triangle{Array1D(3), Array1D(3)};
    triangle.positions << 0.0, 1.0, 3.0;
    triangle.heights << 0.0, 1.0, 0.0;
    const auto p = real_space_parameters(triangle);
    EXPECT_NEAR(p.mean_height, 0.5, 1e-15);
    EXPECT_NEAR(p.rms_height, std::sqrt(1.0 / 12.0), 1e-15);
    EXPECT_NEAR(p.rms_slope, std::sqrt((1.0 + 0.5) / 3.0), 1e-15);
}

TEST(RealSpaceParameters, AreUnaffectedByAHugeOffset) {
    topography::LineScan scan{Array1D::Random(1000), 1.0};
    const auto truth = real_space_parameters(scan);
    scan.heights += 1e6;
    EXPECT_NEAR(real_space_parameters(scan).rms_height / truth.rms_height, 1.0, 1e-9);
}

TEST(RealSpaceParameters, RefuseAMapWithoutAHeight) {
    EXPECT_THROW((void)real_space_parameters(topography::HeightMap{Array2D::Constant(4, 4, undefined), {1.0, 1.0}}),
                 UndefinedDataError);
}

TEST(RealSpaceParameters, OfAMapByBandsEqualThoseOfTheWholeMap) {
    auto map = waves(130, 61, false);
    map.heights += 1e4;
    map.heights(5, 7) = undefined;
    map.heights.col(0).setConstant(undefined);
    const auto whole = real_space_parameters(map);
    for (const Index lines : {1, 2, 20, 61, 100}) {
        const auto tiled = real_space_parameters(topography::tiled(map), lines);
        EXPECT_EQ(tiled.defined, whole.defined);
        EXPECT_NEAR(tiled.rms_height, whole.rms_height, 1e-10 * whole.rms_height);
        EXPECT_NEAR(tiled.rms_height_of_lines, whole.rms_height_of_lines, 1e-10 * whole.rms_height);
        EXPECT_NEAR(tiled.rms_slope_x, whole.rms_slope_x, 1e-12 * whole.rms_slope_x);
        EXPECT_NEAR(tiled.rms_slope_y, whole.rms_slope_y, 1e-12 * whole.rms_slope_y);
        EXPECT_NEAR(tiled.rms_curvature, whole.rms_curvature, 1e-12 * whole.rms_curvature);
        EXPECT_NEAR(tiled.mean_height, whole.mean_height, 1e-10);
    }
}

TEST(RealSpaceParameters, OfAPeriodicMapByBandsWrapRound) {
    const auto map = waves(24, 30, true);
    EXPECT_DOUBLE_EQ(real_space_parameters(topography::tiled(map), 4).rms_slope, real_space_parameters(map).rms_slope);
}

}  // namespace
}  // namespace setae::roughness::real_space_test
