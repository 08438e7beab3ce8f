// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/texture/material_ratio.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"

namespace setae::texture::material_ratio_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

LineScan line(std::initializer_list<double> heights, bool periodic = false) {
    const std::vector<double> values(heights);
    return {Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size())),
            static_cast<double>(values.size()),
            periodic,
            {}};
}

Array1D numbers(std::initializer_list<double> list) {
    Array1D values(static_cast<Index>(list.size()));
    std::copy(list.begin(), list.end(), values.begin());
    return values;
}

void expect_all_near(const Array1D& values, const Array1D& expected, double tolerance) {
    ASSERT_EQ(values.size(), expected.size());
    for (Index k = 0; k < values.size(); ++k) EXPECT_NEAR(values[k], expected[k], tolerance) << "entry " << k;
}

/// Share above h of a triangle by dividing it into strips between sorted corners: independent of the formulas of the
/// library.
double share_by_quadrature(double a, double b, double c, double height) {
    constexpr int n = 400;
    int above = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n - i; ++j) {
            const double u = (i + 1.0 / 3.0) / n, v = (j + 1.0 / 3.0) / n;
            above += a + u * (b - a) + v * (c - a) >= height ? 1 : 0;
        }
    return 2.0 * above / (n * (n + 1.0));
}

TEST(BearingArea, PlateausCountAsMaterial) {
    expect_all_near(bearing_area(line({0.0, 0.0, 1.0, 1.0}), numbers({-0.1, 0.0, 0.25, 0.5, 1.0, 1.1})),
                    numbers({1.0, 1.0, 1.75 / 3, 0.5, 1.0 / 3, 0.0}), 1e-15);
    const HeightMap step{(Array2D(3, 2) << 0, 0, 0, 0, 1, 1).finished(), {3.0, 2.0}};
    expect_all_near(bearing_area(step, numbers({0.0, 0.5, 1.0})), numbers({1.0, 0.25, 0.0}), 1e-15);
}

TEST(BearingArea, OfAQuantisedLineIsDefinedAtEveryLevel) {
    LineScan scan{tests::random_heights(500), 500.0};
    scan.heights = (scan.heights * 3.0).round() / 3.0;
    const auto ratio = bearing_area(scan, scan.heights);
    EXPECT_TRUE((ratio >= 0.0).all() && (ratio <= 1.0).all());
}

TEST(BearingArea, OfOnePixelEqualsThatOfItsTwoTriangles) {
    const HeightMap map{(Array2D(2, 2) << 0.3, 1.7, -0.4, 0.9).finished(), {2.0, 2.0}};
    for (const double h : {-0.3, 0.0, 0.31, 0.8, 1.0, 1.6}) {
        const double expected = 0.5 * (share_by_quadrature(0.3, -0.4, 1.7, h) + share_by_quadrature(0.9, -0.4, 1.7, h));
        EXPECT_NEAR(bearing_area(map, numbers({h}))[0], expected, 3e-3) << h;
    }
}

TEST(BearingArea, OfATiltedPlaneIsLinear) {
    HeightMap map{Array2D(21, 33), {21.0, 33.0}};
    for (Index i = 0; i < 21; ++i) map.heights.row(i).setConstant(static_cast<double>(i));
    const Array1D heights = Array1D::LinSpaced(97, 0.0, 20.0);
    expect_all_near(bearing_area(map, heights), 1.0 - heights / 20.0, 1e-14);
}

TEST(BearingArea, AcceptsHeightsInAnyOrderAndPropagatesNaN) {
    const HeightMap map{tests::random_map(20, 30), {1.0, 1.0}};
    const Array1D heights = numbers({0.5, undefined, -2.0, 0.5, 7.0, -std::numeric_limits<double>::infinity(),
                                     std::numeric_limits<double>::infinity()});
    const auto ratio = bearing_area(map, heights);
    EXPECT_EQ(ratio[0], ratio[3]);
    EXPECT_TRUE(std::isnan(ratio[1]));
    EXPECT_GT(ratio[2], ratio[0]);
    EXPECT_EQ(ratio[4], 0.0);
    EXPECT_EQ(ratio[5], 1.0);
    EXPECT_EQ(ratio[6], 0.0);
    EXPECT_EQ(ratio[0], bearing_area(map, numbers({0.5}))[0]);
}

TEST(BearingArea, IsTheSameForClusteredAndSpreadHeights) {
    const HeightMap map{tests::random_map(40, 30), {1.0, 1.0}};
    Array1D clustered(201);
    clustered.head(200) = Array1D::LinSpaced(200, 0.1, 0.1 + 1e-9);
    clustered[200] = 1e3;
    const auto ratio = bearing_area(map, clustered);
    for (const Index k : {Index{0}, Index{77}, Index{199}})
        EXPECT_NEAR(ratio[k], bearing_area(map, numbers({clustered[k]}))[0], 1e-13);
    EXPECT_TRUE((ratio.head(199) >= ratio.segment(1, 199)).all());
}

TEST(BearingArea, KeepsPrecisionAtAnOffset) {
    HeightMap map{tests::random_map(30, 31), {1.0, 1.0}};
    map.heights = (map.heights * 1024.0).round() / 1024.0;  // so that adding 2^24 is exact
    const Array1D heights = Array1D::LinSpaced(65, -2.0, 2.0);
    auto lifted = map;
    lifted.heights += 16777216.0;
    expect_all_near(bearing_area(lifted, heights + 16777216.0), bearing_area(map, heights), 1e-14);
    EXPECT_NEAR(mad_height(lifted), mad_height(map), 1e-8);
}

TEST(BearingArea, IgnoresTrianglesWithAnUndefinedCorner) {
    HeightMap map{Array2D::Zero(3, 3), {3.0, 3.0}};
    map.heights(2, 2) = undefined;  // one triangle of eight
    map.heights(0, 0) = 1.0;        // one more, the share of which above 1/2 is 1/4
    EXPECT_NEAR(bearing_area(map, numbers({0.5}))[0], 0.25 / 7.0, 1e-15);
    map.heights.setConstant(undefined);
    map.heights(1, 1) = 2.0;
    EXPECT_THROW((void)bearing_area(map, numbers({0.5})), UndefinedDataError);
    EXPECT_NEAR(bearing_area(map, numbers({0.5}), Between::nothing)[0], 1.0, 0.0);
}

TEST(BearingArea, OfAPolylineDoesNotDependOnCollinearPoints) {
    const Profile coarse{numbers({0.0, 1.0, 3.0, 4.0}), numbers({0.0, 2.0, -1.0, 0.5}), {}};
    const Profile fine{
        numbers({0.0, 0.25, 1.0, 1.5, 3.0, 3.1, 4.0}), numbers({0.0, 0.5, 2.0, 1.25, -1.0, -0.85, 0.5}), {}};
    const Array1D heights = Array1D::LinSpaced(31, -1.0, 2.0);
    expect_all_near(bearing_area(fine, heights), bearing_area(coarse, heights), 1e-14);
    EXPECT_NEAR(median_height(fine), median_height(coarse), 1e-14);
    EXPECT_NEAR(mad_height(fine), mad_height(coarse), 1e-14);
}

TEST(BearingArea, RefusesAReentrantPolyline) {
    Profile profile{numbers({0.0, 1.0, 0.5, 2.0}), numbers({0.0, 1.0, 2.0, 3.0}), {}};
    EXPECT_THROW((void)bearing_area(profile, numbers({0.5})), InvalidArgument);
    EXPECT_THROW((void)median_height(profile), InvalidArgument);
    EXPECT_THROW((void)mad_height(profile), InvalidArgument);
    profile.positions = numbers({0.0, 1.0, 1.5, 2.0});
    EXPECT_THROW((void)bearing_area(profile, numbers({0.5}), Between::nothing), InvalidArgument);
}

TEST(BearingArea, OfAMapIsTheSameForAnyNumberOfThreads) {
    const HeightMap map{tests::random_map(301, 77), {1.0, 1.0}};
    const Array1D heights = Array1D::LinSpaced(101, -4.0, 4.0);
    const auto one = bearing_area(map, heights, Between::linear, {1});
    for (const int threads : {2, 5}) {
        EXPECT_TRUE((bearing_area(map, heights, Between::linear, {threads}) == one).all());
        EXPECT_EQ(mad_height(map, 0.5, Between::linear, {threads}), mad_height(map, 0.5, Between::linear, {1}));
    }
}

TEST(BearingArea, IsInvariantUnderTranspositionAndReversal) {
    const HeightMap map{tests::random_map(20, 14), {2.0, 1.4}};
    const HeightMap transposed{map.heights.transpose(), {1.4, 2.0}};
    const HeightMap reversed{map.heights.reverse(), {2.0, 1.4}};
    const Array1D heights = Array1D::LinSpaced(21, -2.0, 2.0);
    expect_all_near(bearing_area(transposed, heights), bearing_area(map, heights), 1e-13);
    expect_all_near(bearing_area(reversed, heights), bearing_area(map, heights), 1e-13);
}

TEST(MaterialRatioCurve, VolumeIsTheIntegralOfTheRatio) {
    const HeightMap map{tests::random_map(12, 9), {1.0, 1.0}};
    const Array1D heights = Array1D::LinSpaced(20001, -4.0, 4.0);
    const auto curve = material_ratio_curve(map, heights);
    const double step = heights[1] - heights[0];
    double integral = 0.0;
    for (Index k = 20000; k > 0; --k) {
        integral += 0.5 * step * (curve.ratio[k] + curve.ratio[k - 1]);
        if (k % 1000 == 0) {
            EXPECT_NEAR(curve.volume[k - 1], integral, 1e-6);
        }
    }
    EXPECT_NEAR(curve.volume[0], curve.mean + 4.0, 1e-12);
    EXPECT_THROW((void)material_ratio_curve(map, numbers({1.0, 1.0})), InvalidArgument);
}

TEST(HeightsAtRatio, InvertTheBearingArea) {
    const Array1D ratios = numbers({0.0, 1e-6, 0.025, 0.1, 0.5, 0.5, 0.8, 0.999, 1.0});
    const HeightMap map{tests::random_map(60, 45), {1.0, 1.0}};
    const LineScan scan{tests::random_heights(300), 300.0, true};
    const auto profile = tests::random_profile(200);
    for (const MeasurementView view : {MeasurementView(map), MeasurementView(scan), MeasurementView(profile)}) {
        const auto heights = heights_at_ratio(view, ratios);
        EXPECT_TRUE((heights.head(8) >= heights.tail(8)).all());
        const auto back = bearing_area(view, heights);
        for (Index k = 1; k < 8; ++k) EXPECT_NEAR(back[k], ratios[k], 1e-12) << k;
    }
    EXPECT_EQ(heights_at_ratio(map, numbers({0.0, 1.0}))[0], map.heights.maxCoeff());
    EXPECT_EQ(heights_at_ratio(map, numbers({0.0, 1.0}))[1], map.heights.minCoeff());
    EXPECT_THROW((void)heights_at_ratio(map, numbers({1.1})), InvalidArgument);
    EXPECT_THROW((void)heights_at_ratio(map, numbers({undefined})), InvalidArgument);
}

TEST(HeightsAtRatio, OfPointsAreOrderStatistics) {
    const LineScan scan = line({3.0, 1.0, 4.0, 1.5, 9.0});
    expect_all_near(heights_at_ratio(scan, numbers({0.2, 0.4, 0.6, 0.8, 1.0}), Between::nothing),
                    numbers({9.0, 4.0, 3.0, 1.5, 1.0}), 1e-12);
    EXPECT_EQ(bearing_area(scan, numbers({3.0}), Between::nothing)[0], 0.6);
}

TEST(MedianHeight, AndMadOfFlatSurfacesAreExact) {
    const HeightMap flat{Array2D::Constant(5, 4, 0.3), {1.0, 1.0}};
    EXPECT_EQ(median_height(flat), 0.3);
    EXPECT_EQ(mad_height(flat), 0.0);
    const auto level = line({0.3, 0.3, 0.3});
    EXPECT_EQ(median_height(level), 0.3);
    EXPECT_EQ(mad_height(level), 0.0);
    const Profile polyline{numbers({0.0, 1.0, 4.0}), numbers({0.3, 0.3, 0.3}), {}};
    EXPECT_EQ(median_height(polyline), 0.3);
    EXPECT_EQ(mad_height(polyline), 0.0);
}

TEST(MedianHeight, AndMadOfTwoPlateausMatchClosedForms) {
    // P(1/2 + m) = (4/3 − 2 (1/2 + m)... the flanks hold 1/3 of the length, so 68.27 % is reached on the plateaus
    // themselves
    const auto plateaus = line({0.0, 0.0, 1.0, 1.0});
    EXPECT_NEAR(median_height(plateaus), 0.5, 1e-14);
    EXPECT_NEAR(mad_height(plateaus), 0.5, 1e-14);
    EXPECT_NEAR(mad_height(plateaus, 0.2), 0.3, 1e-14);
    EXPECT_THROW((void)mad_height(plateaus, 1.0), InvalidArgument);
}

TEST(MedianHeight, OfASawtoothIsItsMean) {
    const auto ramp = line({0.0, 1.0, 2.0, 3.0, 4.0});
    EXPECT_NEAR(median_height(ramp), 2.0, 1e-14);
    EXPECT_NEAR(mad_height(ramp, 0.5), 1.0, 1e-14);
}

TEST(MadHeight, OfGaussianHeightsEqualsTheirRms) {
    // the quantiles of a Gaussian as points
    constexpr Index n = 200001;
    LineScan scan{Array1D(n), 1.0};
    for (Index k = 0; k < n; ++k) scan.heights[k] = 2.5 * normal_quantile((static_cast<double>(k) + 0.5) / n) + 7.0;
    EXPECT_NEAR(mad_height(scan, share_within_one_sigma, Between::nothing), 2.5, 1e-4);
    EXPECT_NEAR(median_height(scan, Between::nothing), 7.0, 1e-4);
    EXPECT_NEAR(mad_height(scan, 0.5), 2.5 * normal_quantile(0.75), 1e-4);
}

TEST(MadHeight, ScalesWithTheUnit) {
    auto map = HeightMap{tests::random_map(30, 40), {1.0, 1.0}};
    const double metres = mad_height(map), median = median_height(map);
    map.heights *= 1e-9;
    EXPECT_NEAR(mad_height(map) / metres, 1e-9, 1e-20);
    EXPECT_NEAR(median_height(map) / median, 1e-9, 1e-18);
}

}  // namespace
}  // namespace setae::texture::material_ratio_test
