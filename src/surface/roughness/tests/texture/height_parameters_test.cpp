// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/height_parameters.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/roughness/real_space.hpp"
#include "texture/hybrid_parameters.hpp"

namespace setae::texture::height_parameters_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

TEST(HeightParameters, OfASineMatchClosedForms) {
    constexpr Index n = 1000;
    const Array1D heights = (Array1D::LinSpaced(n, 0.0, n - 1.0) * (2.0 * pi / n) + 0.3).sin() * 2.0 + 5.0;
    const auto result = height_parameters(LineScan{heights, 1.0});
    EXPECT_NEAR(result.mean, 5.0, 1e-13);
    EXPECT_NEAR(result.Sq, std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(result.Ssk, 0.0, 1e-12);
    EXPECT_NEAR(result.Sku, 1.5, 1e-12);
    EXPECT_NEAR(result.Sa, 4.0 / pi, 1e-4);
    EXPECT_NEAR(result.Sz, 4.0, 1e-4);
    EXPECT_EQ(result.Sp + result.Sv, result.Sz);
    EXPECT_EQ(result.defined, n);
}

TEST(HeightParameters, OfATriangleWaveAsPolylineAreExact) {
    Profile profile{Array1D(4), Array1D(4), {}};
    profile.positions << 0.0, 1.0, 3.0, 4.0;
    profile.heights << 10.0, 12.0, 8.0, 10.0;
    const auto result = height_parameters(profile);
    EXPECT_NEAR(result.mean, 10.0, 1e-15);
    EXPECT_NEAR(result.Sq, 2.0 / std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(result.Sa, 1.0, 1e-14);  // the middle segment is split at the mean line
    EXPECT_NEAR(result.Ssk, 0.0, 1e-14);
    EXPECT_NEAR(result.Sku, 9.0 / 5.0, 1e-14);
    EXPECT_NEAR(result.Sp, 2.0, 1e-15);
    EXPECT_NEAR(result.Sv, 2.0, 1e-15);
}

TEST(HeightParameters, OfAParabolaHaveTheExpectedSkewness) {
    // x² on −1 … 1: mean 1/3, variance 4/45, Sku 15/7
    constexpr Index n = 4001;
    Profile profile{Array1D::LinSpaced(n, -1.0, 1.0), Array1D(n), {}};
    profile.heights = profile.positions.square();
    const auto result = height_parameters(profile);
    EXPECT_NEAR(result.mean, 1.0 / 3.0, 1e-6);
    EXPECT_NEAR(result.Ssk, 16.0 / 945.0 / std::pow(4.0 / 45.0, 1.5), 1e-5);
    EXPECT_NEAR(result.Sku, 15.0 / 7.0, 1e-5);
}

TEST(HeightParameters, OfAPolylineDoNotDependOnCollinearPoints) {
    auto coarse = tests::random_profile(50);
    Profile fine{Array1D(99), Array1D(99), {}};
    for (Index k = 0; k < 50; ++k) {
        fine.positions[2 * k] = coarse.positions[k];
        fine.heights[2 * k] = coarse.heights[k];
        if (k == 49) break;
        fine.positions[2 * k + 1] = 0.3 * coarse.positions[k] + 0.7 * coarse.positions[k + 1];
        fine.heights[2 * k + 1] = 0.3 * coarse.heights[k] + 0.7 * coarse.heights[k + 1];
    }
    const auto a = height_parameters(coarse), b = height_parameters(fine);
    EXPECT_NEAR(a.Sq, b.Sq, 1e-12);
    EXPECT_NEAR(a.Sa, b.Sa, 1e-12);
    EXPECT_NEAR(a.Ssk, b.Ssk, 1e-11);
    EXPECT_NEAR(a.Sku, b.Sku, 1e-11);
}

TEST(HeightParameters, OfATwoLevelStepFollowFromItsShare) {
    // share a at height 1, the rest at 0: Sq² = a(1 − a), Ssk = (1 − 2a)/Sq, Sku = 1/(a(1 − a)) − 3, Sa = 2a(1 − a)
    HeightMap map{Array2D::Zero(8, 5), {1.0, 1.0}};
    map.heights.topRows(2).setOnes();
    const auto result = height_parameters(map);
    const double a = 0.25, v = a * (1.0 - a);
    EXPECT_NEAR(result.Sq, std::sqrt(v), 1e-15);
    EXPECT_NEAR(result.Ssk, (1.0 - 2.0 * a) / std::sqrt(v), 1e-13);
    EXPECT_NEAR(result.Sku, 1.0 / v - 3.0, 1e-13);
    EXPECT_NEAR(result.Sa, 2.0 * v, 1e-15);
}

TEST(HeightParameters, OfAMaskedMapUseDefinedPoints) {
    HeightMap map{tests::random_map(30, 20), {1.0, 1.0}};
    map.heights(3, 4) = undefined;
    map.heights.col(7).setConstant(undefined);
    const auto result = height_parameters(map);
    const auto expected = roughness::real_space_parameters(map);
    EXPECT_NEAR(result.Sq, expected.rms_height, 1e-14);
    EXPECT_NEAR(result.mean, expected.mean_height, 1e-14);
    EXPECT_EQ(result.defined, 30 * 19 - 1);
}

TEST(HeightParameters, KeepPrecisionAtAnOffset) {
    LineScan scan{tests::random_heights(1000), 1.0};
    scan.heights = (scan.heights * 1024.0).round() / 1024.0;
    const auto plain = height_parameters(scan);
    scan.heights += 16777216.0;
    const auto lifted = height_parameters(scan);
    EXPECT_NEAR(lifted.Sq, plain.Sq, 1e-8);
    EXPECT_NEAR(lifted.Ssk, plain.Ssk, 1e-8);
    EXPECT_NEAR(lifted.Sku, plain.Sku, 1e-8);
    EXPECT_NEAR(lifted.Sa, plain.Sa, 1e-8);
}

TEST(HeightParameters, OfAConstantSurfaceHaveNoShape) {
    const auto result = height_parameters(HeightMap{Array2D::Constant(3, 3, 0.1), {1.0, 1.0}});
    EXPECT_EQ(result.Sq, 0.0);
    EXPECT_EQ(result.Sz, 0.0);
    EXPECT_EQ(result.mean, 0.1);
    EXPECT_TRUE(std::isnan(result.Ssk) && std::isnan(result.Sku));
    EXPECT_THROW((void)height_parameters(HeightMap{Array2D::Constant(3, 3, undefined), {1.0, 1.0}}),
                 UndefinedDataError);
}

TEST(HeightParameters, AreTheSameForAnyNumberOfThreads) {
    const HeightMap map{tests::random_map(400, 300), {1.0, 1.0}};
    const auto one = height_parameters(map, {1}), four = height_parameters(map, {4});
    EXPECT_EQ(one.Sq, four.Sq);
    EXPECT_EQ(one.Ssk, four.Ssk);
    EXPECT_EQ(one.Sa, four.Sa);
}

TEST(HeightParameters, RefuseAReentrantPolyline) {
    Profile profile{Array1D(3), Array1D::Zero(3), {}};
    profile.positions << 0.0, 2.0, 1.0;
    EXPECT_THROW((void)height_parameters(profile), InvalidArgument);
}

TEST(HybridParameters, OfAPlaneAreItsSlopeAndArea) {
    HeightMap map{Array2D(9, 7), {9.0, 14.0}};
    for (Index i = 0; i < 9; ++i)
        for (Index j = 0; j < 7; ++j)
            map.heights(i, j) = 0.75 * static_cast<double>(i) + 1.0 * 2.0 * static_cast<double>(j);
    const auto result = hybrid_parameters(map);
    EXPECT_NEAR(result.Sdq, 1.25, 1e-14);
    EXPECT_NEAR(result.Sdq_central, 1.25, 1e-14);
    EXPECT_NEAR(result.Sdr, std::sqrt(1.0 + 1.5625) - 1.0, 1e-14);
    EXPECT_NEAR(result.Sdr_central, std::sqrt(1.0 + 1.5625) - 1.0, 1e-14);
}

TEST(HybridParameters, OfACosineMatchTheSymbolsOfDifferences) {
    constexpr Index n = 64;
    HeightMap map{Array2D(n, 4), {static_cast<double>(n), 4.0}, true};
    const double q = 2.0 * pi * 5.0 / n;
    for (Index i = 0; i < n; ++i) map.heights.row(i).setConstant(std::cos(q * static_cast<double>(i)));
    const auto result = hybrid_parameters(map);
    EXPECT_NEAR(result.Sdq, 2.0 * std::sin(0.5 * q) / std::sqrt(2.0), 1e-13);
    EXPECT_NEAR(result.Sdq_central, std::sin(q) / std::sqrt(2.0), 1e-13);
    EXPECT_GT(result.Sdr, result.Sdr_central);
}

TEST(HybridParameters, OfAMapTwoRowsWideHaveNoCentralDifference) {
    const auto result = hybrid_parameters(HeightMap{tests::random_map(2, 5), {1.0, 1.0}});
    EXPECT_TRUE(std::isnan(result.Sdq_central));
    EXPECT_GT(result.Sdr, 0.0);
}

}  // namespace
}  // namespace setae::texture::height_parameters_test
