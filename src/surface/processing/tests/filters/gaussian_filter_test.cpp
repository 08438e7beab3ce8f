// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "setae/core/errors.hpp"
#include "setae/processing/iso_filter.hpp"

namespace setae::processing::gaussian_filter_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

constexpr double undefined_height = std::numeric_limits<double>::quiet_NaN();

Array2D noise(Index nx, Index ny, unsigned seed = 1) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    return Array2D::NullaryExpr(nx, ny, [&] { return normal(generator); });
}

/// exp(−π (x/(α λc))²) by the definition.
double weight(double distance, double cutoff) {
    const double alpha = std::sqrt(std::numbers::ln2 / std::numbers::pi);
    return std::exp(-std::numbers::pi * distance * distance / (alpha * alpha * cutoff * cutoff));
}

/// The weighted mean or local plane over all defined points, one point after the other; images of periodic maps out to
/// 3 sizes.
double by_definition(const HeightMap& map, double cutoff, Index order, Index at_i, Index at_j) {
    const auto pixel = map.pixel_size();
    const Index nx = map.heights.rows(), ny = map.heights.cols(), images = map.periodic ? 3 : 0;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (Index i = -images * nx; i < (images + 1) * nx; ++i)
        for (Index j = -images * ny; j < (images + 1) * ny; ++j) {
            const double height = map.heights(((i % nx) + nx) % nx, ((j % ny) + ny) % ny);
            if (std::isnan(height)) continue;
            const double x = static_cast<double>(i - at_i) * pixel[0], y = static_cast<double>(j - at_j) * pixel[1];
            const double s = weight(x, cutoff) * weight(y, cutoff);
            const Eigen::Vector3d basis(1.0, x / cutoff, y / cutoff);
            normal += s * basis * basis.transpose();
            right += s * height * basis;
        }
    if (order == 0) return right[0] / normal(0, 0);
    return normal.ldlt().solve(right)[0];
}

double by_definition(const LineScan& scan, double cutoff, Index order, Index at) {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    const Index n = scan.heights.size(), images = scan.periodic ? 3 : 0;
    for (Index i = -images * n; i < (images + 1) * n; ++i) {
        const double height = scan.heights[((i % n) + n) % n];
        if (std::isnan(height)) continue;
        const double x = static_cast<double>(i - at) * scan.pixel_size();
        const Eigen::Vector2d basis(1.0, x / cutoff);
        normal += weight(x, cutoff) * basis * basis.transpose();
        right += weight(x, cutoff) * height * basis;
    }
    if (order == 0) return right[0] / normal(0, 0);
    return normal.ldlt().solve(right)[0];
}

void expect_definition(const HeightMap& map, double cutoff, Index order) {
    const HeightMap smooth = filtered(map, GaussianFilter{.cutoff = cutoff, .order = order});
    const double range = (map.heights.isNaN().select(0.0, map.heights)).abs().maxCoeff();
    for (Index i = 0; i < map.heights.rows(); i += 9)
        for (Index j = 0; j < map.heights.cols(); j += 7) {
            if (std::isnan(map.heights(i, j))) {
                EXPECT_TRUE(std::isnan(smooth.heights(i, j)));
                continue;
            }
            EXPECT_NEAR(smooth.heights(i, j), by_definition(map, cutoff, order, i, j), 3e-7 * range)
                << i << ", " << j << ", λc " << cutoff << ", order " << order;
        }
}

TEST(GaussianFilter, OfMapsIsTheWeightedMeanOfAllPoints) {
    for (const bool periodic : {false, true})
        for (const double cutoff : {1.7, 5.0, 12.0})
            expect_definition({noise(29, 22), {29.0, 15.4}, periodic, {}}, cutoff, 0);
    expect_definition({noise(60, 40), {60.0, 40.0}, false, {}}, 100.0, 0);
}

TEST(GaussianFilter, OfOrderOneIsTheWeightedLocalPlane) {
    for (const double cutoff : {5.0, 18.0}) expect_definition({noise(33, 28), {33.0, 19.6}, false, {}}, cutoff, 1);
}

TEST(GaussianFilter, IgnoresUndefinedPoints) {
    HeightMap map{noise(33, 28), {33.0, 19.6}, false, {}};
    map.heights.block(4, 5, 9, 8).setConstant(undefined_height);
    map.heights.row(21).setConstant(undefined_height);
    map.heights(0, 0) = undefined_height;
    for (const Index order : {0, 1})
        for (const double cutoff : {4.0, 14.0, 25.0}) expect_definition(map, cutoff, order);
    map.periodic = true;
    expect_definition(map, 9.0, 0);
}

TEST(GaussianFilter, OfLinesIsTheWeightedMeanOfAllPoints) {
    for (const bool periodic : {false, true})
        for (const bool holes : {false, true})
            for (const double cutoff : {2.0, 8.0, 40.0})
                for (const Index order : {0, 1}) {
                    LineScan scan{Array1D(noise(1, 57).row(0)), 28.5, periodic, {}};
                    if (holes) scan.heights.segment(11, 6).setConstant(undefined_height);
                    const LineScan smooth = filtered(scan, GaussianFilter{.cutoff = cutoff, .order = order});
                    for (Index i = 0; i < 57; ++i) {
                        if (std::isnan(scan.heights[i])) continue;
                        EXPECT_NEAR(smooth.heights[i], by_definition(scan, cutoff, order, i), 3e-7)
                            << i << ", λc " << cutoff;
                    }
                }
}

TEST(GaussianFilter, TransmitsHalfOfASineAtItsCutoff) {
    for (const double cutoff : {8.0, 20.0, 64.0, 160.0}) {
        const Index n = 640 * 3;
        LineScan scan{Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)), static_cast<double>(n), true, {}};
        scan.heights = (scan.heights * (2.0 * std::numbers::pi / cutoff)).sin();
        const LineScan smooth = filtered(scan, GaussianFilter{.cutoff = cutoff});
        EXPECT_LT((smooth.heights - 0.5 * scan.heights).abs().maxCoeff(), 1e-7) << cutoff;
        const LineScan longer = filtered(scan, GaussianFilter{.cutoff = 2.0 * cutoff});
        EXPECT_LT((longer.heights - std::exp2(-4.0) * scan.heights).abs().maxCoeff(), 1e-7) << cutoff;
    }
}

TEST(GaussianFilter, TransmitsHalfOfAMapsSineInEveryDirection) {
    const Index n = 96;
    const double q = 2.0 * std::numbers::pi / 96.0;
    for (const auto& mode : {std::array<double, 2>{0, 6}, {6, 0}, {4, 3}}) {
        HeightMap map{Array2D::NullaryExpr(n, n,
                                           [&](Index i, Index j) {
                                               return std::cos(q * (mode[0] * static_cast<double>(i) +
                                                                    mode[1] * static_cast<double>(j)));
                                           }),
                      {96.0, 96.0},
                      true,
                      {}};
        const double cutoff = 96.0 / std::hypot(mode[0], mode[1]);
        const HeightMap smooth = filtered(map, GaussianFilter{.cutoff = cutoff});
        EXPECT_LT((smooth.heights - 0.5 * map.heights).abs().maxCoeff(), 1e-7);
    }
}

TEST(GaussianFilter, OfOrderOneKeepsPlanesUpToTheBorder) {
    HeightMap map{Array2D::NullaryExpr(150, 90,
                                       [](Index i, Index j) {
                                           return 3.0 + 0.25 * static_cast<double>(i) - 0.5 * static_cast<double>(j);
                                       }),
                  {150.0, 45.0},
                  false,
                  {}};
    for (const double cutoff : {3.0, 20.0, 80.0}) {
        const HeightMap smooth = filtered(map, GaussianFilter{.cutoff = cutoff, .order = 1});
        EXPECT_LT((smooth.heights - map.heights).abs().maxCoeff(), 1e-10) << cutoff;
    }
    map.heights.block(30, 20, 40, 30).setConstant(undefined_height);
    const HeightMap smooth = filtered(map, GaussianFilter{.cutoff = 20.0, .keep = Kept::short_waves, .order = 1});
    EXPECT_LT(smooth.heights.isNaN().select(0.0, smooth.heights).abs().maxCoeff(), 1e-9);
    EXPECT_EQ(smooth.heights.isNaN().count(), 1200);
}

TEST(GaussianFilter, KeepsConstantsOfAnySize) {
    const HeightMap map{Array2D::Constant(40, 31, 1e7 + 0.125), {40.0, 31.0}, false, {}};
    EXPECT_TRUE((filtered(map, GaussianFilter{.cutoff = 9.0}).heights == map.heights).all());
    EXPECT_TRUE((filtered(map, GaussianFilter{.cutoff = 9.0, .keep = Kept::short_waves}).heights == 0.0).all());
}

TEST(GaussianFilter, IsUnaffectedByOffsetsOfTenMillionRms) {
    HeightMap map{noise(48, 40), {48.0, 40.0}, false, {}};
    const HeightMap plain = filtered(map, GaussianFilter{.cutoff = 17.0});
    map.heights += 1e7;
    const HeightMap shifted = filtered(map, GaussianFilter{.cutoff = 17.0});
    EXPECT_LT((shifted.heights - 1e7 - plain.heights).abs().maxCoeff(), 1e-8);
}

TEST(GaussianFilter, SplitsHeightsIntoLongAndShortWaves) {
    HeightMap map{noise(48, 41), {48.0, 41.0}, false, {}};
    map.heights(20, 20) = undefined_height;
    const Array2D sum = filtered(map, GaussianFilter{.cutoff = 11.0}).heights +
                        filtered(map, GaussianFilter{.cutoff = 11.0, .keep = Kept::short_waves}).heights;
    EXPECT_EQ(sum.isNaN().count(), 1);
    EXPECT_LT((sum - map.heights).isNaN().select(0.0, sum - map.heights).abs().maxCoeff(), 1e-14);
}

TEST(GaussianFilter, NeverUsesMaskedValues) {
    // SurfaceTopography's filters of masked maps use the hidden values; here holes are not used
    HeightMap map{noise(30, 30), {30.0, 30.0}, true, {}};
    HeightMap other = map;
    other.heights(10, 10) = 1e3;
    map.heights(10, 10) = other.heights(10, 10) = undefined_height;
    const Array2D a = filtered(map, GaussianFilter{.cutoff = 6.0}).heights,
                  b = filtered(other, GaussianFilter{.cutoff = 6.0}).heights;
    EXPECT_EQ(std::memcmp(a.data(), b.data(), sizeof(double) * 900), 0);
}

TEST(GaussianFilter, GivesTheSameBytesForAnyNumberOfThreads) {
    HeightMap map{noise(150, 301), {150.0, 301.0}, false, {}};
    for (const double cutoff : {6.0, 40.0})
        for (const Index order : {0, 1}) {
            const GaussianFilter filter{.cutoff = cutoff, .order = order};
            const Array2D one = filtered(map, filter, {1}).heights, three = filtered(map, filter, {3}).heights;
            EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
        }
}

TEST(GaussianFilter, HandlesTwoPointsAndSingleRows) {
    const LineScan two{Array1D{{1.0, 3.0}}, 2.0, false, {}};
    const double s = weight(1.0, 4.0);
    EXPECT_NEAR(filtered(two, GaussianFilter{.cutoff = 4.0}).heights[0], (1.0 + 3.0 * s) / (1.0 + s), 1e-7);
    const Array1D heights = noise(1, 50).row(0).transpose();
    const LineScan scan{heights, 50.0, false, {}};
    const HeightMap row{heights.transpose(), {1.0, 50.0}, false, {}}, column{heights, {50.0, 1.0}, false, {}};
    for (const Index order : {0, 1}) {
        const GaussianFilter filter{.cutoff = 21.0, .order = order};
        const Array1D expected = filtered(scan, filter).heights;
        EXPECT_LT((Array1D(filtered(row, filter).heights.row(0).transpose()) - expected).abs().maxCoeff(), 1e-12)
            << order;
        EXPECT_LT((Array1D(filtered(column, filter).heights.col(0)) - expected).abs().maxCoeff(), 1e-12) << order;
    }
}

TEST(GaussianFilter, RefusesInvalidParameters) {
    const LineScan scan{Array1D::Zero(10), 10.0, false, {}};
    EXPECT_THROW((void)filtered(scan, GaussianFilter{}), InvalidArgument);
    EXPECT_THROW((void)filtered(scan, GaussianFilter{.cutoff = -1.0}), InvalidArgument);
    EXPECT_THROW((void)filtered(scan, GaussianFilter{.cutoff = std::numeric_limits<double>::infinity()}),
                 InvalidArgument);
    EXPECT_THROW((void)filtered(scan, GaussianFilter{.cutoff = 3.0, .order = 2}), InvalidArgument);
    const topography::Profile profile{Array1D{{0.0, 1.0, 3.0}}, Array1D{{0.0, 1.0, 0.0}}, {}};
    EXPECT_THROW((void)apply(GaussianFilter{.cutoff = 1.0}, profile), InvalidArgument);
}

TEST(GaussianFilter, WarnsOfACutoffOutsideTheData) {
    const topography::HeightMap map{noise(30, 30), {30.0, 30.0}, false, {}};
    EXPECT_TRUE(apply(GaussianFilter{.cutoff = 8.0}, map).record.alerts.empty());
    ASSERT_EQ(apply(GaussianFilter{.cutoff = 1.0}, map).record.alerts.size(), 1u);
    EXPECT_EQ(apply(GaussianFilter{.cutoff = 100.0}, map).record.alerts.at(0).code, "FILTER_CUTOFF");
    EXPECT_EQ(apply(GaussianFilter{.cutoff = 8.0}, map).record.step, "gaussian_filter");
}

}  // namespace
}  // namespace setae::processing::gaussian_filter_test
