// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/processing/fourier_cut.hpp"

namespace setae::processing::fourier_cut_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

/// cos(2π (a i/nx + b j/ny))
HeightMap grating(Index nx, Index ny, Index a, Index b) {
    const double turn = 2.0 * std::numbers::pi;
    return {Array2D::NullaryExpr(nx, ny,
                                 [=](Index i, Index j) {
                                     return std::cos(turn * (static_cast<double>(a * i) / static_cast<double>(nx) +
                                                             static_cast<double>(b * j) / static_cast<double>(ny)));
                                 }),
            {1.0, 1.0},
            true,
            {}};
}

TEST(FourierCut, KeepsAxialGratingsLongerThanTheCutoff) {
    // SurfaceTopography's 'square step' removes a grating along an axis at any wavelength
    for (const auto& [a, b] : {std::pair<Index, Index>{0, 4}, {4, 0}}) {
        const HeightMap map = grating(32, 48, a, b);
        EXPECT_LT((cut(map, FourierCut{.shortest = 0.2}).heights - map.heights).abs().maxCoeff(), 1e-14);
        EXPECT_LT((cut(map, FourierCut{.longest = 0.3}).heights - map.heights).abs().maxCoeff(), 1e-14);
        EXPECT_LT(cut(map, FourierCut{.shortest = 0.26}).heights.abs().maxCoeff(), 1e-14);
        EXPECT_LT(cut(map, FourierCut{.longest = 0.24}).heights.abs().maxCoeff(), 1e-14);
    }
}

TEST(FourierCut, IsIsotropic) {
    const HeightMap diagonal = grating(32, 32, 3, 4);  // |q| = 2π 5
    EXPECT_LT(cut(diagonal, FourierCut{.shortest = 0.21}).heights.abs().maxCoeff(), 1e-14);
    EXPECT_LT((cut(diagonal, FourierCut{.shortest = 0.2, .longest = 0.2}).heights - diagonal.heights).abs().maxCoeff(),
              1e-14);
    EXPECT_LT((cut(diagonal, FourierCut{.shortest = 0.19}).heights - diagonal.heights).abs().maxCoeff(), 1e-14);
}

TEST(FourierCut, KeepsTheMeanAndTheShapeOfOddMaps) {
    HeightMap map = grating(31, 27, 2, 1);
    map.heights += 1e7;
    const HeightMap short_waves = cut(map, FourierCut{.longest = 0.01});
    EXPECT_EQ(short_waves.shape(), map.shape());
    EXPECT_LT((short_waves.heights - map.heights.mean()).abs().maxCoeff(), 1e-8);
    EXPECT_LT((cut(map, FourierCut{.shortest = 0.1}).heights - map.heights).abs().maxCoeff(), 1e-8);
}

TEST(FourierCut, SplitsIntoShortLongAndMean) {
    std::mt19937 generator(1);
    std::normal_distribution<double> normal;
    for (const Index ny : {20, 21}) {
        const HeightMap map{Array2D::NullaryExpr(18, ny, [&] { return normal(generator); }), {1.8, 1.1}, true, {}};
        const double wavelength = 0.2345;
        const Array2D sum = cut(map, FourierCut{.shortest = wavelength}).heights +
                            cut(map, FourierCut{.longest = wavelength}).heights - map.heights.mean();
        EXPECT_LT((sum - map.heights).abs().maxCoeff(), 1e-14);
        const Array2D one = cut(map, FourierCut{.shortest = wavelength}, {1}).heights,
                      three = cut(map, FourierCut{.shortest = wavelength}, {3}).heights;
        EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
    }
}

TEST(FourierCut, HandlesLines) {
    const Index n = 45;
    LineScan scan{
        Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * (2.0 * std::numbers::pi / 45.0), 9.0, true, {}};
    const Array1D phase = scan.heights;
    scan.heights = 3.0 + (2.0 * phase).sin() + (9.0 * phase).cos();
    EXPECT_LT((cut(scan, FourierCut{.shortest = 2.0}).heights - 3.0 - (2.0 * phase).sin()).abs().maxCoeff(), 1e-14);
    EXPECT_LT((cut(scan, FourierCut{.longest = 1.0}).heights - 3.0 - (9.0 * phase).cos()).abs().maxCoeff(), 1e-14);
}

TEST(FourierCut, RefusesUndefinedAndNonPeriodicData) {
    HeightMap map = grating(16, 16, 1, 1);
    map.heights(3, 3) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)cut(map, FourierCut{.shortest = 0.2}), UndefinedDataError);
    map = grating(16, 16, 1, 1);
    EXPECT_THROW((void)cut(map, FourierCut{}), InvalidArgument);
    EXPECT_THROW((void)cut(map, FourierCut{.shortest = -1.0}), InvalidArgument);
    EXPECT_THROW((void)cut(map, FourierCut{.shortest = 0.5, .longest = 0.2}), InvalidArgument);
    map.periodic = false;
    try {
        (void)cut(map, FourierCut{.shortest = 0.2});
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("ISO 16610"), std::string::npos) << error.what();
    }
    EXPECT_THROW(
        (void)apply(FourierCut{.shortest = 0.2}, topography::Profile{Array1D{{0.0, 1.0}}, Array1D{{0.0, 1.0}}, {}}),
        InvalidArgument);
}

}  // namespace
}  // namespace setae::processing::fourier_cut_test
