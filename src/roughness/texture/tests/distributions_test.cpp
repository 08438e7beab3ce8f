// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/distributions.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/texture/height_parameters.hpp"

namespace setae::texture {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

double width(const Distribution& d) { return d.centre[1] - d.centre[0]; }

TEST(DistributionOf, GaussianHeightsIsTheirGaussian) {
    constexpr Index n = 100001;
    LineScan scan{Array1D(n), 1.0};
    for (Index k = 0; k < n; ++k)
        scan.heights[k] = 2.0 + 3.0 * normal_quantile((static_cast<double>((k * 7919) % n) + 0.5) / n);
    const auto d = distribution(scan, Counted::height, 64);
    EXPECT_NEAR(d.mean, 2.0, 1e-10);
    EXPECT_NEAR(d.rms, 3.0, 1e-3);
    EXPECT_NEAR(d.median, 2.0, 1e-10);
    EXPECT_NEAR(d.mad, 3.0, 1e-3);
    EXPECT_NEAR(d.interquartile_range, 6.0 * normal_quantile(0.75), 1e-3);
    EXPECT_NEAR(d.kurtosis, 3.0, 0.01);
    EXPECT_NEAR(d.robust_skewness, 0.0, 1e-9);
    EXPECT_LT(d.gaussian_distance, 1e-3);
    EXPECT_LT((d.density - d.gaussian).abs().maxCoeff(), 2e-3 * d.gaussian.maxCoeff());
    EXPECT_NEAR(d.density.sum() * width(d), 1.0, 1e-12);
}

TEST(DistributionOf, ExponentialHeightsIsSkewed) {
    constexpr Index n = 20001;
    LineScan scan{Array1D(n), 1.0};
    for (Index k = 0; k < n; ++k) scan.heights[k] = -std::log1p(-(static_cast<double>(k) + 0.5) / n);
    const auto d = distribution(scan, Counted::height);
    EXPECT_NEAR(d.median, std::log(2.0), 1e-4);
    EXPECT_NEAR(d.interquartile_range, std::log(3.0), 1e-3);
    EXPECT_NEAR(d.robust_skewness, (std::log(4.0) + std::log(4.0 / 3.0) - 2.0 * std::log(2.0)) / std::log(3.0), 1e-3);
    EXPECT_NEAR(d.skewness, 2.0, 0.02);
    EXPECT_GT(d.gaussian_distance, 0.1);
    EXPECT_LE(d.centre.size(), 512);
}

TEST(DistributionOf, APolylineIsThatOfItsSegments) {
    Profile ramp{Array1D(3), Array1D(3), {}};
    ramp.positions << 0.0, 1.0, 10.0;
    ramp.heights << 0.0, 0.1, 1.0;
    const auto d = distribution(ramp, Counted::height, 10);
    EXPECT_LT((d.density - 1.0).abs().maxCoeff(), 1e-12);
    EXPECT_NEAR(d.median, 0.5, 1e-12);
    EXPECT_NEAR(d.mad, 1.482602218505602 * 0.25, 1e-12);
    EXPECT_NEAR(d.interquartile_range, 0.5, 1e-12);
    EXPECT_NEAR(d.rms, 1.0 / std::sqrt(12.0), 1e-12);
}

TEST(DistributionOf, SlopesOfAPolylineCountsTheirLength) {
    Profile bend{Array1D(3), Array1D(3), {}};
    bend.positions << 0.0, 1.0, 4.0;
    bend.heights << 0.0, 1.0, 1.0;
    const auto d = distribution(bend, Counted::slope_x, 2);
    EXPECT_NEAR(d.mean, 0.25, 1e-15);
    EXPECT_NEAR(d.density[0] * 0.5, 0.75, 1e-15);
    EXPECT_NEAR(d.density[1] * 0.5, 0.25, 1e-15);
}

TEST(DistributionOf, CurvatureOfAParabolaIsOneValue) {
    LineScan scan{Array1D::LinSpaced(50, 0.0, 49.0).square() * 1.5, 50.0};
    const auto line = distribution(scan, Counted::curvature, 8);
    EXPECT_NEAR(line.mean, 3.0, 1e-12);
    EXPECT_NEAR(line.rms, 0.0, 1e-9);
    HeightMap map{Array2D(20, 30), {20.0, 30.0}};
    for (Index i = 0; i < 20; ++i)
        for (Index j = 0; j < 30; ++j) map.heights(i, j) = static_cast<double>(i * i + 2 * j * j);
    const auto area = distribution(map, Counted::curvature, 8);
    EXPECT_NEAR(area.mean, 3.0, 1e-12);
    EXPECT_EQ(area.values, 18 * 28);
    EXPECT_EQ(distribution(map, Counted::slope_x).values, 19 * 30);
    EXPECT_EQ(distribution(map, Counted::slope_y).values, 20 * 29);
}

TEST(DistributionOf, AMapLeavesOutUndefinedValuesAndDifferences) {
    HeightMap map{tests::random_map(30, 20), {1.0, 1.0}};
    map.heights(4, 4) = undefined;
    EXPECT_EQ(distribution(map, Counted::height).values, 599);
    EXPECT_EQ(distribution(map, Counted::slope_x).values, 29 * 20 - 2);
    EXPECT_EQ(distribution(map, Counted::curvature).values, 28 * 18 - 5);
    map.periodic = true;
    EXPECT_EQ(distribution(map, Counted::slope_x).values, 30 * 20 - 2);
}

TEST(DistributionOf, OneOutlierMovesMomentsButNotRanks) {
    LineScan scan{tests::random_heights(2001), 1.0};
    const auto plain = distribution(scan, Counted::height);
    scan.heights[7] = 1e4;
    const auto hit = distribution(scan, Counted::height);
    EXPECT_GT(hit.rms, 100.0 * plain.rms);
    EXPECT_NEAR(hit.mad, plain.mad, 0.01);
    EXPECT_NEAR(hit.median, plain.median, 0.01);
}

TEST(DistributionOf, AConstantHasNoShapeAndTooFewValuesAreRefused) {
    const auto d = distribution(LineScan{Array1D::Constant(10, 0.1), 1.0}, Counted::height);
    EXPECT_NEAR(d.rms, 0.0, 1e-16);
    EXPECT_EQ(d.robust_skewness, 0.0);
    EXPECT_NEAR(d.density.sum() * width(d), 1.0, 1e-12);
    EXPECT_THROW((void)distribution(LineScan{Array1D::Zero(2), 1.0}, Counted::curvature), UndefinedDataError);
    EXPECT_THROW((void)distribution(LineScan{Array1D::Zero(9), 1.0}, Counted::slope_y), InvalidArgument);
    EXPECT_THROW((void)distribution(LineScan{Array1D::Zero(9), 1.0}, Counted::height, -1), InvalidArgument);
}

TEST(CentralMoment, OfATriangleWaveIsAPowerOfItsHeight) {
    Profile triangle{Array1D(3), Array1D(3), {}};
    triangle.positions << 0.0, 1.0, 2.0;
    triangle.heights << 4.0, 6.0, 4.0;
    for (int k = 1; k <= 8; ++k) EXPECT_NEAR(central_moment(triangle, k), k % 2 == 0 ? 1.0 / (k + 1) : 0.0, 1e-14) << k;
    EXPECT_THROW((void)central_moment(triangle, 0), InvalidArgument);
    EXPECT_THROW((void)central_moment(triangle, 9), InvalidArgument);
}

TEST(CentralMoment, AgreesWithTheParametersMadeOfThem) {
    const HeightMap map{tests::random_map(30, 40), {1.0, 1.0}};
    const auto heights = height_parameters(map);
    EXPECT_NEAR(central_moment(map, 2), heights.Sq * heights.Sq, 1e-12);
    EXPECT_NEAR(central_moment(map, 4), heights.Sku * std::pow(heights.Sq, 4), 1e-12);
}

}  // namespace
}  // namespace setae::texture
