// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/detrend.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography::detrend_test {
namespace {

HeightMap paraboloid(Index nx, Index ny, double offset) {
    HeightMap map{Array2D(nx, ny), {3.0, 2.0}};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            const double x = 3.0 * static_cast<double>(i) / static_cast<double>(nx),
                         y = 2.0 * static_cast<double>(j) / static_cast<double>(ny);
            map.heights(i, j) = offset + 0.3 * x - 0.7 * y + 0.05 * x * x + 0.02 * y * y - 0.04 * x * y;
        }
    return map;
}

TEST(Detrend, RemovesAPlaneFromANonSquareMap) {
    auto map = paraboloid(17, 33, 0.0);
    HeightMap plane{Array2D(17, 33), {3.0, 2.0}};
    for (Index i = 0; i < 17; ++i)
        for (Index j = 0; j < 33; ++j)
            plane.heights(i, j) = 1.0 + 2.0 * static_cast<double>(i) - 3.0 * static_cast<double>(j);
    EXPECT_LT(detrended(plane, Trend::tilt).heights.abs().maxCoeff(), 1e-12);
    EXPECT_GT(detrended(map, Trend::tilt).heights.abs().maxCoeff(), 1e-3);
}

TEST(Detrend, RemovesAParaboloidAtAnyOffset) {
    EXPECT_LT(detrended(paraboloid(17, 33, 0.0), Trend::parabola).heights.abs().maxCoeff(), 1e-13);
    // 1e6 loses the digits lost by the input, no more
    EXPECT_LT(detrended(paraboloid(17, 33, 1e6), Trend::parabola).heights.abs().maxCoeff(), 1e-9);
}

TEST(Detrend, UsesDefinedHeightsAndKeepsUndefinedOnes) {
    auto map = paraboloid(20, 20, 5.0);
    map.heights(3, 4) = undefined;
    const auto level = detrended(map, Trend::parabola);
    EXPECT_TRUE(std::isnan(level.heights(3, 4)));
    map.heights(3, 4) = 0.0;
    EXPECT_LT(level.heights.isNaN().select(0.0, level.heights).abs().maxCoeff(), 1e-13);
}

TEST(Detrend, OfALineLeavesTheResidualOrthogonalToThePolynomial) {
    LineScan scan{Array1D::Random(101), 7.0};
    const auto level = detrended(scan, Trend::parabola);
    const Array1D x = Array1D::LinSpaced(101, -1.0, 1.0);
    EXPECT_NEAR(level.heights.sum(), 0.0, 1e-12);
    EXPECT_NEAR((level.heights * x).sum(), 0.0, 1e-12);
    EXPECT_NEAR((level.heights * x * x).sum(), 0.0, 1e-12);
}

TEST(Detrend, OfAPolylineIgnoresCollinearPointsAndTheOriginOfX) {
    Profile coarse{Array1D(4), Array1D(4)};
    coarse.positions << 0.0, 1.0, 3.0, 4.5;
    coarse.heights << 0.0, 2.0, -1.0, 0.5;
    Profile fine{Array1D(5), Array1D(5)};
    fine.positions << 1e6, 1e6 + 1.0, 1e6 + 2.0, 1e6 + 3.0, 1e6 + 4.5;
    fine.heights << 0.0, 2.0, 0.5, -1.0, 0.5;
    const auto a = detrended(coarse, Trend::parabola), b = detrended(fine, Trend::parabola);
    EXPECT_NEAR(a.heights[0], b.heights[0], 1e-9);
    EXPECT_NEAR(a.heights[1], b.heights[1], 1e-9);
    EXPECT_NEAR(a.heights[2], b.heights[3], 1e-9);
    EXPECT_NEAR(a.heights[3], b.heights[4], 1e-9);
}

TEST(Detrend, RefusesTooFewDefinedHeights) {
    LineScan scan{Array1D::Constant(10, undefined), 1.0};
    scan.heights[2] = 1.0;
    EXPECT_THROW((void)detrended(scan, Trend::tilt), UndefinedDataError);
}

TEST(TrendNames, ConvertToTrendsAndBack) {
    for (const auto trend : {Trend::none, Trend::mean, Trend::tilt, Trend::parabola})
        EXPECT_EQ(trend_from_name(name(trend)), trend);
    EXPECT_EQ(trend_from_name("level_mean"), Trend::mean);
    EXPECT_EQ(trend_from_name("level_plane"), Trend::tilt);
    EXPECT_EQ(trend_from_name("level_polynomial"), Trend::parabola);
    EXPECT_THROW((void)trend_from_name("plane"), InvalidArgument);
}

TEST(Detrend, OfAMapByBandsEqualsThatOfTheWholeMap) {
    auto map = paraboloid(37, 50, 1e3);
    for (Index i = 0; i < 37; ++i)
        for (Index j = 0; j < 50; ++j) map.heights(i, j) += 0.01 * std::sin(static_cast<double>(7 * i + 13 * j * j));
    map.heights(3, 4) = undefined;
    map.heights.col(20).setConstant(undefined);
    for (const auto trend : {Trend::mean, Trend::tilt, Trend::parabola}) {
        const Array2D whole = detrended(map, trend).heights;
        for (const Index lines : {1, 7, 50}) {
            const auto tiled = detrended(topography::tiled(map), trend, lines);
            const Array2D band = tiled.lines(11, 25), difference = band - whole.middleCols(11, 25);
            EXPECT_LT(difference.isNaN().select(0.0, difference.abs()).maxCoeff(), 1e-12);
            EXPECT_TRUE((band.isNaN() == whole.middleCols(11, 25).isNaN()).all());
        }
    }
}

TEST(Detrend, OfAMapIsTheSameForAnyNumberOfThreads) {
    const auto map = paraboloid(200, 30, 5.0);
    EXPECT_TRUE((detrended(map, Trend::parabola, parallel::Threads{1}).heights ==
                 detrended(map, Trend::parabola, parallel::Threads{3}).heights)
                    .all());
}

TEST(Detrend, OfAMapWithoutDefinedHeightsIsRefused) {
    HeightMap map{Array2D::Constant(4, 5, undefined), {1.0, 1.0}};
    EXPECT_THROW((void)detrended(map, Trend::mean), UndefinedDataError);
}

}  // namespace
}  // namespace setae::topography::detrend_test
