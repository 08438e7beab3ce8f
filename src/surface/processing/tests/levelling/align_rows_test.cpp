// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/align_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "record_number.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing::align_rows_test {
namespace {

using topography::HeightMap;

/// Islands of height 1e-8 on a flat ground with noise of 1e-10; the share of each line that they cover.
HeightMap islands(Index nx, Index ny, double share) {
    std::mt19937 engine(3);
    std::normal_distribution<double> normal(0.0, 1e-10);
    HeightMap map{Array2D(nx, ny), {1e-6, 1e-6}};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            const bool island =
                static_cast<double>(i) < share * static_cast<double>(nx) && j > ny / 4 && j < 3 * ny / 4;
            map.heights(i, j) = normal(engine) + (island ? 1e-8 : 0.0);
        }
    return map;
}

/// The same islands with a random jump of each line.
HeightMap jumped(HeightMap map) {
    std::mt19937 engine(11);
    std::normal_distribution<double> normal(0.0, 5e-9);
    for (Index j = 0; j < map.heights.cols(); ++j) map.heights.col(j) += normal(engine);
    return map;
}

double left_over(const HeightMap& aligned, const HeightMap& truth) { return rms_of(aligned.heights - truth.heights); }

TEST(AlignRows, ByMedianRemovesJumpsAndKeepsIslandsBelowHalfALine) {
    const auto truth = islands(200, 80, 0.3);
    EXPECT_LT(left_over(map_of(apply(AlignRows{}, jumped(truth))), truth), 0.03e-8);
    // means follow the islands
    EXPECT_GT(left_over(map_of(apply(AlignRows{.method = RowAlignment::mean}, jumped(truth))), truth), 0.1e-8);
}

TEST(AlignRows, ByMedianOfDifferencesKeepsIslandsAboveHalfALine) {
    // where an island begins, most points of the line step up: 40 % of the points do not
    const auto truth = islands(200, 80, 0.45);
    EXPECT_LT(left_over(map_of(apply(AlignRows{.method = RowAlignment::median_of_differences}, jumped(truth))), truth),
              0.03e-8);
    // an island that grows line by line finally covers most of a line, and the median then treats it as the background
    HeightMap wedge{Array2D::Zero(200, 80), {1e-6, 1e-6}};
    for (Index j = 0; j < 80; ++j)
        for (Index i = 0; i < std::min<Index>(160, 2 * j + 2); ++i) wedge.heights(i, j) = 1e-8;
    EXPECT_LT(left_over(map_of(apply(AlignRows{.method = RowAlignment::median_of_differences}, jumped(wedge))), wedge),
              1e-20);
    EXPECT_GT(left_over(map_of(apply(AlignRows{}, jumped(wedge))), wedge), 0.3e-8);
}

TEST(AlignRows, ByMedianOfDifferencesAccumulatesMedians) {
    HeightMap map{Array2D(3, 3), {3.0, 3.0}};
    map.heights << 0.0, 1.0, 5.0,  //
        0.0, 2.0, 4.0,             //
        0.0, 4.0, 9.0;             // differences of lines: 1 2 4 (median 2), 4 2 5 (median 4)
    const auto level = map_of(apply(AlignRows{.method = RowAlignment::median_of_differences}, map));
    Array2D expected = map.heights;
    const double mean = (0.0 + 2.0 + 6.0) / 3.0;
    expected.col(0) -= 0.0 - mean;
    expected.col(1) -= 2.0 - mean;
    expected.col(2) -= 6.0 - mean;
    EXPECT_LT((level.heights - expected).abs().maxCoeff(), 1e-15);
}

TEST(AlignRows, RemovesStructureAlongTheSlowAxis) {
    HeightMap map{Array2D(64, 64), {1.0, 1.0}};
    for (Index i = 0; i < 64; ++i)
        for (Index j = 0; j < 64; ++j) map.heights(i, j) = std::cos(2.0 * pi * static_cast<double>(j) / 64.0);
    for (const auto method :
         {RowAlignment::mean, RowAlignment::median, RowAlignment::median_of_differences, RowAlignment::polynomial})
        EXPECT_LT(rms_of(map_of(apply(AlignRows{.method = method}, map)).heights), 1e-14);
    // along the fast axis it is kept
    EXPECT_NEAR(rms_of(map_of(apply(AlignRows{.method = RowAlignment::mean, .direction = Direction::y}, map)).heights),
                std::sqrt(0.5), 1e-12);
}

TEST(AlignRows, KeepsTheMeanOfAllLines) {
    auto map = jumped(islands(40, 30, 0.3));
    map.heights += 3e-6;
    for (const auto method : {RowAlignment::mean, RowAlignment::polynomial})
        EXPECT_NEAR(map_of(apply(AlignRows{.method = method}, map)).heights.mean(), map.heights.mean(), 1e-18);
}

TEST(AlignRows, OfTiltedStripedDataRecoversSqWithinOnePercent) {
    std::mt19937 engine(5);
    std::normal_distribution<double> normal(0.0, 2e-8);
    HeightMap truth{Array2D(256, 200), {2e-6, 2e-6}};
    for (Index i = 0; i < 256; ++i)
        for (Index j = 0; j < 200; ++j)
            truth.heights(i, j) =
                1e-8 * std::sin(0.3 * static_cast<double>(i)) * std::cos(0.2 * static_cast<double>(j));
    auto measured = truth;
    for (Index j = 0; j < 200; ++j)
        for (Index i = 0; i < 256; ++i) measured.heights(i, j) += 0.05 * 2e-6 * static_cast<double>(i) / 256.0;
    for (Index j = 0; j < 200; ++j) measured.heights.col(j) += normal(engine) + 0.02 * 1e-8 * static_cast<double>(j);
    const auto level = map_of(apply(AlignRows{.method = RowAlignment::polynomial}, measured));
    EXPECT_NEAR(rms_of(level.heights) / rms_of(truth.heights), 1.0, 0.01);
}

TEST(AlignRows, FitsTheRegionOnlyAndShiftsWholeLines) {
    auto map = jumped(islands(100, 60, 0.7));
    const auto truth = islands(100, 60, 0.7);
    const AlignRows step{.region = region_from_text("exclude rectangle below 0.705 um")};
    EXPECT_LT(left_over(map_of(apply(step, map)), truth), 0.05e-8);
}

TEST(AlignRows, ShiftsLinesWithoutPointsWithTheirNeighbours) {
    auto map = jumped(islands(50, 20, 0.0));
    map.heights.col(7).setConstant(undefined);
    map.heights.col(0).setConstant(undefined);
    for (const auto method : {RowAlignment::mean, RowAlignment::median, RowAlignment::median_of_differences}) {
        const auto level = map_of(apply(AlignRows{.method = method}, map));
        EXPECT_EQ(level.heights.isNaN().count(), 100);
    }
    const auto level = apply(AlignRows{.method = RowAlignment::polynomial}, map);
    EXPECT_EQ(level.record.alerts.size(), 1u);
    map.heights.setConstant(undefined);
    EXPECT_THROW((void)apply(AlignRows{}, map), UndefinedDataError);
}

TEST(AlignRows, RefusesALine) {
    EXPECT_THROW((void)apply(AlignRows{}, topography::LineScan{Array1D::Zero(5), 1.0}), InvalidArgument);
    EXPECT_THROW((void)apply(AlignRows{.method = RowAlignment::polynomial, .degree = 13}, islands(20, 20, 0.1)),
                 InvalidArgument);
}

TEST(AlignRows, GivesTheSameBytesForAnyNumberOfThreads) {
    auto map = jumped(islands(333, 130, 0.3));
    map.heights(5, 5) = undefined;
    for (const auto method :
         {RowAlignment::mean, RowAlignment::median, RowAlignment::median_of_differences, RowAlignment::polynomial}) {
        const auto one = map_of(apply(AlignRows{.method = method}, map, {1})),
                   three = map_of(apply(AlignRows{.method = method}, map, {3}));
        EXPECT_EQ(std::memcmp(one.heights.data(), three.heights.data(),
                              sizeof(double) * static_cast<std::size_t>(one.heights.size())),
                  0);
    }
}

}  // namespace
}  // namespace setae::processing::align_rows_test
