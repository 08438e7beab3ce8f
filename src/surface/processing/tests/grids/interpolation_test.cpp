// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/processing/interpolation.hpp"

namespace setae::processing::interpolation_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

constexpr double undefined_height = std::numeric_limits<double>::quiet_NaN();

Array2D noise(Index nx, Index ny) {
    std::mt19937 generator(1);
    std::normal_distribution<double> normal;
    return Array2D::NullaryExpr(nx, ny, [&] { return normal(generator); });
}

/// Heights of a function at the points of a map.
template <class Function>
HeightMap sampled(Index nx, Index ny, std::array<double, 2> size, bool periodic, const Function& height) {
    HeightMap map{Array2D(nx, ny), size, periodic, {}};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            map.heights(i, j) = height(static_cast<double>(i) * size[0] / static_cast<double>(nx),
                                       static_cast<double>(j) * size[1] / static_cast<double>(ny));
    return map;
}

double plane(double x, double y) { return 3.0 + 0.5 * x - 2.0 * y; }
double paraboloid(double x, double y) { return plane(x, y) + 0.25 * x * x - 0.5 * y * y; }

TEST(LinearInterpolation, IsExactOnPlanesAndAtThePoints) {
    const HeightMap map = sampled(9, 7, {4.5, 7.0}, false, plane);
    const LinearInterpolator height(map);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {4.0, 6.0}, {1.23, 4.56}, {3.9, 0.1}})
        EXPECT_NEAR(height(x, y), plane(x, y), 1e-14);
    const HeightMap rough{noise(5, 6), {5.0, 6.0}, true, {}};
    EXPECT_EQ(LinearInterpolator(rough)(3.0, 4.0), rough.heights(3, 4));
}

TEST(LinearInterpolation, DividesPixelsAlongTheDiagonalFromXToY) {
    HeightMap map{Array2D::Zero(3, 3), {3.0, 3.0}, false, {}};
    map.heights(1, 1) = 1.0;
    const LinearInterpolator height(map);
    EXPECT_NEAR(height(0.75, 0.5), 0.25, 1e-15);  // upper triangle of the first pixel
    EXPECT_EQ(height(0.5, 0.25), 0.0);            // lower triangle
    EXPECT_NEAR(height(1.5, 1.25), 0.25, 1e-15);  // lower triangle of the next
}

TEST(LinearInterpolation, WrapsOnPeriodicMapsAndEndsOnOthers) {
    HeightMap map{noise(4, 5), {4.0, 5.0}, true, {}};
    EXPECT_NEAR(LinearInterpolator(map)(3.5, 2.0), 0.5 * (map.heights(3, 2) + map.heights(0, 2)), 1e-15);
    EXPECT_NEAR(LinearInterpolator(map)(-0.5, -3.0), 0.5 * (map.heights(3, 2) + map.heights(0, 2)), 1e-15);
    EXPECT_NEAR(LinearInterpolator(map)(7.5, 12.0), 0.5 * (map.heights(3, 2) + map.heights(0, 2)), 1e-15);
    map.periodic = false;
    EXPECT_TRUE(std::isnan(LinearInterpolator(map)(3.5, 2.0)));
    EXPECT_TRUE(std::isnan(LinearInterpolator(map)(1.0, -0.1)));
    EXPECT_EQ(LinearInterpolator(map)(3.0, 4.0), map.heights(3, 4));
    const LineScan scan{Array1D{{1.0, 3.0, -1.0}}, 3.0, true, {}};
    EXPECT_NEAR(LinearLineInterpolator(scan)(2.25), -0.5, 1e-15);
}

TEST(Interpolation, IsUndefinedOnlyWhereUndefinedHeightsContribute) {
    HeightMap map{noise(8, 8), {8.0, 8.0}, true, {}};
    map.heights(4, 4) = undefined_height;
    const LinearInterpolator linear(map);
    EXPECT_TRUE(std::isnan(linear(3.6, 3.6)));
    EXPECT_FALSE(std::isnan(linear(3.4, 3.4)));
    EXPECT_FALSE(std::isnan(linear(3.0, 4.0)));
    const BicubicInterpolator bicubic(map);
    EXPECT_TRUE(std::isnan(bicubic(3.1, 3.1)));
    EXPECT_FALSE(std::isnan(bicubic(3.0, 3.5)));
    EXPECT_FALSE(std::isnan(bicubic(2.9, 2.9)));
    EXPECT_THROW((void)fourier_interpolated(map, 16, 16), UndefinedDataError);
    LineScan scan{Array1D{{1.0, undefined_height, 2.0, 3.0, 5.0}}, 5.0, false, {}};
    EXPECT_TRUE(std::isnan(CubicLineInterpolator(scan)(0.5)));
    EXPECT_EQ(CubicLineInterpolator(scan)(2.0), 2.0);
    EXPECT_NEAR(CubicLineInterpolator(scan)(2.5), 2.5 - 0.125, 1e-15);  // slopes 0.5 (three points) and 1.5
}

TEST(BicubicInterpolation, IsExactOnParaboloidsUpToTheBorder) {
    const HeightMap map = sampled(9, 7, {4.5, 7.0}, false, paraboloid);
    const BicubicInterpolator height(map);
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {4.0, 6.0}, {1.23, 4.56}, {3.9, 0.1}}) {
        const SurfacePoint point = height.at(x, y);
        EXPECT_NEAR(point.height, paraboloid(x, y), 1e-13);
        EXPECT_NEAR(point.slope_x, 0.5 + 0.5 * x, 1e-13);
        EXPECT_NEAR(point.slope_y, -2.0 - y, 1e-13);
    }
}

TEST(BicubicInterpolation, OfPeriodicMapsConvergesWithTheFourthPowerOfTheStep) {
    const auto wave = [](double x, double y) {
        return std::cos(2.0 * std::numbers::pi * x) * (1.0 + 0.0 * y) + std::sin(2.0 * std::numbers::pi * y);
    };
    double before = 0.0;
    for (const Index n : {16, 32}) {
        const HeightMap map = sampled(n, n, {1.0, 1.0}, true, wave);
        const BicubicInterpolator height(map, {2});
        double worst = 0.0;
        for (Index k = 0; k < 200; ++k) {
            const double x = std::fmod(0.6180339887 * static_cast<double>(k), 1.0),
                         y = std::fmod(0.7548776662 * static_cast<double>(k), 1.0);
            worst = std::max(worst, std::abs(height(x, y) - wave(x, y)));
        }
        EXPECT_TRUE(before == 0.0 || std::abs(before / worst - 16.0) < 2.0) << before / worst;
        before = worst;
    }
}

TEST(BicubicInterpolation, HasContinuousSlopes) {
    const HeightMap map{noise(8, 8), {8.0, 8.0}, true, {}};
    const BicubicInterpolator height(map);
    const SurfacePoint left = height.at(3.0 - 1e-9, 2.3), right = height.at(3.0 + 1e-9, 2.3);
    EXPECT_NEAR(left.slope_x, right.slope_x, 1e-7);
    EXPECT_NEAR(left.slope_y, right.slope_y, 1e-7);
    EXPECT_NEAR((height(3.4 + 1e-5, 2.3) - height(3.4 - 1e-5, 2.3)) / 2e-5, height.at(3.4, 2.3).slope_x, 1e-8);
    EXPECT_NEAR((height(3.4, 2.3 + 1e-5) - height(3.4, 2.3 - 1e-5)) / 2e-5, height.at(3.4, 2.3).slope_y, 1e-8);
}

TEST(FourierInterpolation, KeepsHeightsOnAFinerGridAndReturnsToThem) {
    for (const auto& [nx, ny] : {std::pair<Index, Index>{8, 6}, {7, 5}, {8, 5}}) {
        const HeightMap map{noise(nx, ny), {2.0, 3.0}, true, {}};
        const HeightMap fine = fourier_interpolated(map, 3 * nx, 2 * ny);
        for (Index i = 0; i < nx; ++i)
            for (Index j = 0; j < ny; ++j) EXPECT_NEAR(fine.heights(3 * i, 2 * j), map.heights(i, j), 1e-13);
        EXPECT_EQ(fine.size, map.size);
        EXPECT_LT((fourier_interpolated(fine, nx, ny).heights - map.heights).abs().maxCoeff(), 1e-13)
            << "down again, " << nx << " x " << ny;
    }
}

TEST(FourierInterpolation, TreatsTheNyquistModeAsACosine) {
    const LineScan scan{Array1D{{1.0, -1.0, 1.0, -1.0}}, 4.0, true, {}};
    const Array1D fine = fourier_interpolated(scan, 8).heights;
    EXPECT_LT((fine - Array1D{{1.0, 0.0, -1.0, 0.0, 1.0, 0.0, -1.0, 0.0}}).abs().maxCoeff(), 1e-15);
    // a mode at the Nyquist wavevector of the coarser grid keeps its values at the points
    LineScan wave{Array1D::LinSpaced(12, 0.0, 11.0), 12.0, true, {}};
    wave.heights = (wave.heights * (std::numbers::pi / 2.0) + 0.3).cos();  // three periods
    const Array1D coarse = fourier_interpolated(wave, 6).heights;
    for (Index i = 0; i < 6; ++i)
        EXPECT_NEAR(coarse[i], std::cos(std::numbers::pi * static_cast<double>(i) + 0.3), 1e-14);
}

TEST(FourierInterpolation, CommutesWithTransposition) {
    const HeightMap map{noise(8, 6), {8.0, 6.0}, true, {}};
    const HeightMap turned{map.heights.transpose(), {6.0, 8.0}, true, {}};
    for (const auto& [nx, ny] : {std::pair<Index, Index>{12, 12}, {4, 10}, {5, 3}, {8, 9}})
        EXPECT_LT((fourier_interpolated(map, nx, ny).heights - fourier_interpolated(turned, ny, nx).heights.transpose())
                      .abs()
                      .maxCoeff(),
                  1e-13);
}

TEST(FourierInterpolation, HandlesLinesAndFewerPoints) {
    // SurfaceTopography 1.27.1 raises IndexError for lines and ValueError for fewer points
    const Index n = 15;
    LineScan scan{
        Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * (2.0 * std::numbers::pi / 15.0), 15.0, true, {}};
    scan.heights = 2.0 + scan.heights.sin() + (7.0 * scan.heights).cos();
    const LineScan coarse = fourier_interpolated(scan, 9);
    for (Index i = 0; i < 9; ++i)
        EXPECT_NEAR(coarse.heights[i], 2.0 + std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 9.0), 1e-14);
}

TEST(FourierInterpolation, RefusesNonPeriodicData) {
    EXPECT_THROW((void)fourier_interpolated(HeightMap{noise(8, 8), {8.0, 8.0}, false, {}}, 16, 16), InvalidArgument);
    EXPECT_THROW((void)fourier_interpolated(LineScan{Array1D::Ones(5), 5.0, false, {}}, 16), InvalidArgument);
    EXPECT_THROW((void)fourier_interpolated(LineScan{Array1D::Ones(5), 5.0, true, {}}, 0), InvalidArgument);
}

TEST(FourierInterpolation, GivesTheSameBytesForAnyNumberOfThreads) {
    const HeightMap map{noise(40, 50), {8.0, 8.0}, true, {}};
    const Array2D one = fourier_interpolated(map, 77, 33, {1}).heights,
                  three = fourier_interpolated(map, 77, 33, {3}).heights;
    EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
}

}  // namespace
}  // namespace setae::processing::interpolation_test
