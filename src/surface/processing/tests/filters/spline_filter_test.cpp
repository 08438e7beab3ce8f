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

namespace setae::processing::spline_filter_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

constexpr double undefined_height = std::numeric_limits<double>::quiet_NaN();

Array1D noise(Index n) {
    std::mt19937 generator(5);
    std::normal_distribution<double> normal;
    return Array1D::NullaryExpr(n, [&] { return normal(generator); });
}

/// (W + β α² P + (1 − β) α⁴ Q) w = W h as a dense system, α = 1/(2 sin(π Δ/λc)).
Array1D by_definition(const LineScan& scan, const SplineFilter& filter) {
    const Index n = scan.heights.size();
    const double alpha = 0.5 / std::sin(std::numbers::pi * scan.pixel_size() / filter.cutoff);
    Eigen::MatrixXd first = Eigen::MatrixXd::Zero(n, n), second = Eigen::MatrixXd::Zero(n, n);
    for (Index i = 0; i < n; ++i) {
        if (scan.periodic || i > 0) first(i, (i + n - 1) % n) = -1.0, first(i, i) = 1.0;
        if (scan.periodic || (i > 0 && i + 1 < n))
            second(i, (i + n - 1) % n) = 1.0, second(i, i) = -2.0, second(i, (i + 1) % n) = 1.0;
    }
    const Eigen::VectorXd weights = scan.heights.isNaN().select(Array1D::Zero(n), Array1D::Ones(n)).matrix();
    const Eigen::VectorXd right = scan.heights.isNaN().select(0.0, scan.heights).matrix();
    const Eigen::MatrixXd whole = Eigen::MatrixXd(weights.asDiagonal()) +
                                  filter.tension * alpha * alpha * first.transpose() * first +
                                  (1.0 - filter.tension) * std::pow(alpha, 4.0) * second.transpose() * second;
    return whole.ldlt().solve(right).array();
}

TEST(SplineFilter, SolvesTheEquationOfTheStandard) {
    for (const bool periodic : {false, true})
        for (const bool holes : {false, true})
            for (const double tension : {0.0, 0.4, 1.0}) {
                LineScan scan{noise(31), 62.0, periodic, {}};
                if (holes) {
                    scan.heights.segment(0, 3).setConstant(undefined_height);
                    scan.heights[17] = undefined_height;
                }
                const SplineFilter filter{.cutoff = 21.0, .tension = tension};
                const Array1D smooth = filtered(scan, filter).heights, expected = by_definition(scan, filter);
                for (Index i = 0; i < 31; ++i) {
                    ASSERT_EQ(std::isnan(scan.heights[i]), std::isnan(smooth[i]));
                    if (std::isnan(smooth[i])) continue;
                    EXPECT_NEAR(smooth[i], expected[i], 1e-11) << i << ", β " << tension << ", periodic " << periodic;
                }
            }
}

TEST(SplineFilter, TransmitsAsItsFormula) {
    const Index n = 1200;
    LineScan scan{Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)), static_cast<double>(n), true, {}};
    const Array1D place = scan.heights;
    for (const double wavelength : {30.0, 100.0, 300.0})
        for (const double tension : {0.0, 0.3, 1.0}) {
            scan.heights = (place * (2.0 * std::numbers::pi / wavelength)).sin();
            const double alpha = 0.5 / std::sin(std::numbers::pi / 100.0),
                         sine = std::sin(std::numbers::pi / wavelength);
            const double expected = 1.0 / (1.0 + tension * std::pow(2.0 * alpha * sine, 2.0) +
                                           (1.0 - tension) * std::pow(2.0 * alpha * sine, 4.0));
            const Array1D smooth = filtered(scan, SplineFilter{.cutoff = 100.0, .tension = tension}).heights;
            EXPECT_LT((smooth - expected * scan.heights).abs().maxCoeff(), 1e-10) << wavelength << ", β " << tension;
            EXPECT_EQ(wavelength == 100.0, std::abs(expected - 0.5) < 1e-14);
        }
}

TEST(SplineFilter, KeepsStraightLinesAndPlanesWithoutTension) {
    const Index n = 3000;
    const LineScan line{Array1D::LinSpaced(n, -4.0, 9.0), static_cast<double>(n), false, {}};
    EXPECT_LT((filtered(line, SplineFilter{.cutoff = 2000.0}).heights - line.heights).abs().maxCoeff(), 1e-8);
    HeightMap plane{Array2D::NullaryExpr(
                        40, 50, [](Index i, Index j) { return 2.0 * static_cast<double>(i) - static_cast<double>(j); }),
                    {40.0, 50.0},
                    false,
                    {}};
    plane.heights.block(10, 10, 20, 9).setConstant(undefined_height);
    const Array2D left = filtered(plane, SplineFilter{.cutoff = 15.0, .keep = Kept::short_waves}).heights;
    EXPECT_EQ(left.isNaN().count(), 180);
    EXPECT_LT(left.isNaN().select(0.0, left).abs().maxCoeff(), 1e-9);
}

TEST(SplineFilter, IsUnaffectedByOffsetsOfTenMillionRms) {
    LineScan scan{noise(500), 500.0, false, {}};
    const Array1D plain = filtered(scan, SplineFilter{.cutoff = 60.0}).heights;
    scan.heights += 1e7;
    EXPECT_LT((filtered(scan, SplineFilter{.cutoff = 60.0}).heights - 1e7 - plain).abs().maxCoeff(), 1e-8);
}

TEST(SplineFilter, RobustIsUnaffectedByDeepGrooves) {
    const Index n = 2000;
    LineScan scan{Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)), static_cast<double>(n), false, {}};
    const Array1D waviness = (scan.heights * (2.0 * std::numbers::pi / 800.0)).sin();
    scan.heights = waviness + 0.02 * noise(n);
    for (Index groove = 100; groove < n; groove += 200) scan.heights.segment(groove, 12) -= 5.0;
    const Array1D robust = filtered(scan, SplineFilter{.cutoff = 200.0, .robust = true}).heights,
                  plain = filtered(scan, SplineFilter{.cutoff = 200.0}).heights;
    EXPECT_LT((robust - waviness).segment(50, n - 100).abs().maxCoeff(), 0.03);
    EXPECT_GT((plain - waviness).abs().maxCoeff(), 0.3);
    HeightMap map{Array2D::NullaryExpr(40, 60, [](Index i, Index j) { return 0.1 * static_cast<double>(i + j); }),
                  {40.0, 60.0},
                  false,
                  {}};
    const Array2D form = map.heights;
    map.heights.row(0) += 1e-3 * noise(60).transpose();
    map.heights.col(9) += 1e-3 * noise(40);
    map.heights.block(20, 20, 4, 4) -= 30.0;
    EXPECT_LT((filtered(map, SplineFilter{.cutoff = 25.0, .robust = true}).heights - form).abs().maxCoeff(), 1e-2);
}

TEST(SplineFilter, OfMapsFiltersBothDirectionsEqually) {
    const HeightMap map{noise(30 * 44).reshaped<Eigen::RowMajor>(30, 44), {30.0, 44.0}, false, {}};
    const HeightMap turned{map.heights.transpose(), {44.0, 30.0}, false, {}};
    const SplineFilter filter{.cutoff = 9.0};
    EXPECT_LT((filtered(map, filter).heights.transpose() - filtered(turned, filter).heights).abs().maxCoeff(), 1e-12);
    const Array2D three = filtered(map, filter, {3}).heights, one = filtered(map, filter, {1}).heights;
    EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
}

TEST(SplineFilter, HandlesShortLines) {
    for (const Index n : {2, 3, 4, 5})
        for (const bool periodic : {false, true}) {
            if (periodic && n < 3) continue;
            const LineScan scan{noise(n), static_cast<double>(n), periodic, {}};
            const SplineFilter filter{.cutoff = 3.0, .tension = 0.2};
            EXPECT_LT((filtered(scan, filter).heights - by_definition(scan, filter)).abs().maxCoeff(), 1e-12) << n;
        }
}

TEST(SplineFilter, RefusesInvalidParameters) {
    const LineScan scan{noise(10), 10.0, false, {}};
    EXPECT_THROW((void)filtered(scan, SplineFilter{}), InvalidArgument);
    EXPECT_THROW((void)filtered(scan, SplineFilter{.cutoff = 2.0}), InvalidArgument);
    EXPECT_THROW((void)filtered(scan, SplineFilter{.cutoff = 5.0, .tension = 1.5}), InvalidArgument);
    EXPECT_THROW(
        (void)apply(SplineFilter{.cutoff = 1.0}, topography::Profile{Array1D{{0.0, 1.0}}, Array1D{{0.0, 1.0}}, {}}),
        InvalidArgument);
}

}  // namespace
}  // namespace setae::processing::spline_filter_test
