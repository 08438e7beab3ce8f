// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include "setae/core/errors.hpp"
#include "setae/processing/fill.hpp"

namespace setae::processing::fill_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

constexpr double undefined_height = std::numeric_limits<double>::quiet_NaN();

Array2D noise(Index nx, Index ny, unsigned seed = 1) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal;
    return Array2D::NullaryExpr(nx, ny, [&] { return normal(generator); });
}

/// The equations of all undefined points simultaneously, dense.
Array2D by_definition(const HeightMap& map) {
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const auto pixel = map.pixel_size();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(nx * ny, nx * ny);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(nx * ny);
    const std::array<std::array<Index, 2>, 4> steps{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            const Index p = i * ny + j;
            if (!std::isnan(map.heights(i, j))) {
                matrix(p, p) = 1.0;
                right[p] = map.heights(i, j);
                continue;
            }
            for (const auto& [di, dj] : steps) {
                Index ni = i + di, nj = j + dj;
                if (map.periodic) {
                    ni = (ni + nx) % nx;
                    nj = (nj + ny) % ny;
                } else if (ni < 0 || nj < 0 || ni >= nx || nj >= ny) continue;
                const double k = di != 0 ? 1.0 / (pixel[0] * pixel[0]) : 1.0 / (pixel[1] * pixel[1]);
                matrix(p, p) += k;
                matrix(p, ni * ny + nj) -= k;
            }
        }
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    return Eigen::Map<const Array2D>(solution.data(), nx, ny);
}

double difference(const Array2D& a, const Array2D& b) { return (a - b).abs().maxCoeff(); }

TEST(FillUndefined, SolvesLaplacesEquation) {
    for (const bool periodic : {false, true})
        for (const double aspect : {1.0, 0.4, 5.0}) {
            HeightMap map{noise(17, 14), {17.0, 14.0 * aspect}, periodic, {}};
            map.heights.block(3, 3, 5, 6).setConstant(undefined_height);
            map.heights(4, 4) = 0.3;                                       // an island in the hole
            map.heights.row(10).setConstant(undefined_height);             // a whole row
            map.heights.block(14, 9, 3, 5).setConstant(undefined_height);  // a corner
            map.heights(0, 0) = map.heights(12, 0) = map.heights(12, 13) = undefined_height;
            const HeightMap full = filled(map);
            EXPECT_LT(difference(full.heights, by_definition(map)), 1e-12)
                << "periodic " << periodic << ", aspect " << aspect;
        }
}

TEST(FillUndefined, SolvesScatteredHolesOfEveryShape) {
    std::mt19937 generator(7);
    for (const double share : {0.2, 0.45, 0.7})
        for (const bool periodic : {false, true}) {
            HeightMap map{noise(24, 19), {24.0, 9.5}, periodic, {}};
            std::bernoulli_distribution hidden(share);
            for (double& height : map.heights.reshaped())
                if (hidden(generator)) height = undefined_height;
            EXPECT_LT(difference(filled(map).heights, by_definition(map)), 1e-11) << share << ", periodic " << periodic;
        }
}

TEST(FillUndefined, HandlesSingleRowsAndTwoPoints) {
    for (const auto& [nx, ny] : {std::pair<Index, Index>{1, 9}, {9, 1}, {2, 7}, {7, 2}})
        for (const bool periodic : {false, true}) {
            HeightMap map{noise(nx, ny), {1.5 * static_cast<double>(nx), static_cast<double>(ny)}, periodic, {}};
            map.heights.block(0, 0, std::min<Index>(nx, 3), std::min<Index>(ny, 4)).setConstant(undefined_height);
            EXPECT_LT(difference(filled(map).heights, by_definition(map)), 1e-13)
                << nx << " x " << ny << ", periodic " << periodic;
        }
}

/// Undefined within an ellipse.
void dig(HeightMap& map, double centre_x, double centre_y, double radius_x, double radius_y) {
    for (Index i = 0; i < map.heights.rows(); ++i)
        for (Index j = 0; j < map.heights.cols(); ++j)
            if (std::pow((static_cast<double>(i) - centre_x) / radius_x, 2.0) +
                    std::pow((static_cast<double>(j) - centre_y) / radius_y, 2.0) <
                1.0)
                map.heights(i, j) = undefined_height;
}

TEST(FillUndefined, IsExactForHarmonicHeightsOnAnyPixelAspect) {
    for (const double aspect : {1.0, 0.25, 10.0}) {
        const Index nx = 300, ny = 280;
        HeightMap map{Array2D(nx, ny), {300.0, 280.0 * aspect}, false, {}};
        for (Index i = 0; i < nx; ++i)
            for (Index j = 0; j < ny; ++j) {
                const double x = static_cast<double>(i) - 140.0, y = (static_cast<double>(j) - 150.0) * aspect;
                map.heights(i, j) = x * x - y * y + 0.3 * x * y + 5.0 * x - y;
            }
        const Array2D heights = map.heights;
        const double range = heights.maxCoeff() - heights.minCoeff();
        dig(map, 150.0, 140.0, 120.0, 125.0);
        dig(map, 20.0, 20.0, 6.0, 4.0);
        const Array2D full = filled(map).heights;
        EXPECT_LT(difference(full, heights), 1e-12 * range) << aspect;
    }
}

TEST(FillUndefined, FillsHolesAcrossThePeriodicBoundary) {
    // cos(2πx/L) cosh(2πy/L) in steps: the discrete harmonic cosine has cosh(κ) = 2 − cos(2π/n)
    const Index n = 128, ny = 200;
    const double k = 2.0 * std::numbers::pi / static_cast<double>(n), kappa = std::acosh(2.0 - std::cos(k));
    HeightMap map{Array2D::NullaryExpr(n, ny,
                                       [&](Index i, Index j) {
                                           return std::cos(k * static_cast<double>(i)) *
                                                  std::cosh(kappa * (static_cast<double>(j) - 100.0));
                                       }),
                  {128.0, 200.0},
                  true,
                  {}};
    const Array2D heights = map.heights;
    map.heights.middleCols(40, 120).setConstant(undefined_height);  // all around along x
    EXPECT_LT(difference(filled(map).heights, heights), 1e-12 * (heights.maxCoeff() - heights.minCoeff()));
    // the same hole seen from another corner
    const auto rolled = [&](const Array2D& field) {
        return Array2D(
            Array2D::NullaryExpr(n, ny, [&](Index i, Index j) { return field((i + 64) % n, (j + 100) % ny); }));
    };
    HeightMap around{noise(n, ny), {128.0, 200.0}, true, {}};
    dig(around, 64.0, 100.0, 50.0, 60.0);
    HeightMap split = around;
    split.heights = rolled(around.heights);
    EXPECT_LT(difference(filled(split).heights, rolled(filled(around).heights)), 1e-12);
}

TEST(FillUndefined, HasZeroNormalSlopeAtTheBorder) {
    HeightMap map{noise(60, 90), {60.0, 90.0}, false, {}};
    map.heights.leftCols(50).setConstant(undefined_height);
    const Array2D left = filled(map).heights;
    HeightMap mirrored{Array2D(60, 180), {60.0, 180.0}, false, {}};
    mirrored.heights << map.heights.rowwise().reverse(), map.heights;
    EXPECT_LT(difference(filled(mirrored).heights.rightCols(90), left), 1e-12);
    map.heights.setConstant(undefined_height);
    map.heights(7, 80) = 4.0;
    EXPECT_TRUE((filled(map).heights == 4.0).all());
}

TEST(FillUndefined, IsUnaffectedByOffsetsOfTenMillionRms) {
    HeightMap map{noise(90, 90), {90.0, 90.0}, false, {}};
    dig(map, 45.0, 45.0, 40.0, 40.0);
    const Array2D plain = filled(map).heights;
    map.heights += 1e7;
    EXPECT_LT(difference(filled(map).heights - 1e7, plain), 1e-8);
}

TEST(FillUndefined, KeepsDefinedHeights) {
    HeightMap map{noise(30, 30), {30.0, 30.0}, false, {}};
    EXPECT_TRUE((filled(map).heights == map.heights).all());
    dig(map, 10.0, 10.0, 4.0, 4.0);
    const Array2D full = filled(map).heights;
    EXPECT_TRUE((map.heights.isNaN() || full == map.heights).all());
    EXPECT_FALSE(full.isNaN().any());
}

TEST(FillUndefined, GivesTheSameBytesForAnyNumberOfThreads) {
    HeightMap map{noise(200, 200), {200.0, 200.0}, false, {}};
    for (Index k = 0; k < 12; ++k)
        for (Index m = 0; m < 12; ++m)
            dig(map, 10.0 + 16.0 * static_cast<double>(k), 10.0 + 16.0 * static_cast<double>(m), 5.0, 4.0);
    dig(map, 100.0, 100.0, 60.0, 60.0);
    const Array2D one = filled(map, {1}).heights, three = filled(map, {3}).heights;
    EXPECT_EQ(std::memcmp(one.data(), three.data(), sizeof(double) * static_cast<std::size_t>(one.size())), 0);
}

TEST(FillUndefined, InterpolatesGapsOfLinesLinearly) {
    const double nan = undefined_height;
    LineScan scan{Array1D{{nan, 1.0, nan, nan, 4.0, 2.0, nan}}, 7.0, false, {}};
    EXPECT_TRUE((filled(scan).heights == Array1D{{1.0, 1.0, 2.0, 3.0, 4.0, 2.0, 2.0}}).all());
    scan.periodic = true;
    EXPECT_LT((filled(scan).heights - Array1D{{4.0 / 3.0, 1.0, 2.0, 3.0, 4.0, 2.0, 5.0 / 3.0}}).abs().maxCoeff(),
              1e-15);
}

TEST(FillUndefined, RefusesMapsAndLinesWithoutADefinedHeight) {
    EXPECT_THROW((void)filled(HeightMap{Array2D::Constant(4, 5, undefined_height), {4.0, 5.0}, false, {}}),
                 UndefinedDataError);
    EXPECT_THROW((void)filled(LineScan{Array1D::Constant(4, undefined_height), 4.0, false, {}}), UndefinedDataError);
}

TEST(FillUndefined, RecordsTheNumberOfFilledPoints) {
    HeightMap map{noise(20, 20), {20.0, 20.0}, false, {}};
    map.heights.block(2, 2, 3, 3).setConstant(undefined_height);
    map.heights(10, 10) = undefined_height;
    const StepRecord record = apply(FillUndefined{}, map).record;
    EXPECT_EQ(record.step, "fill_undefined");
    EXPECT_EQ(record.numbers.at(0).estimate.value, 10.0);
    EXPECT_EQ(record.numbers.at(2).estimate.value, 2.0);
}

}  // namespace
}  // namespace setae::processing::fill_test
