// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/no_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setae/core/constants.hpp"

namespace setae::topography::no_data_test {
namespace {

constexpr double micrometre = 1e-6;
const NoDataHints in_micrometres{.unit = micrometre};

/// Waves of different lengths with noise, a few µm high.
HeightMap rough(Index nx = 128, Index ny = 96) {
    std::mt19937 engine(11);
    std::normal_distribution<double> normal(0.0, 0.2);
    HeightMap map{Array2D(nx, ny), {1e-3, 1e-3}, false, {}};
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j)
            map.heights(i, j) = micrometre * (5.0 + std::sin(0.13 * static_cast<double>(i)) +
                                              std::cos(0.21 * static_cast<double>(j)) + normal(engine));
    return map;
}

/// The same waves with a value at a random share of the points.
HeightMap with_marks(HeightMap map, double value, double share, unsigned seed = 1) {
    std::mt19937 engine(seed);
    std::bernoulli_distribution marked(share);
    for (Index k = 0; k < map.heights.size(); ++k)
        if (marked(engine)) map.heights.data()[k] = value;
    return map;
}

TEST(NoData, FindsMarksOfKnownPrograms) {
    for (const double mark :
         {-9999.0, -999.25, 10000.0, -25400.0, -32768.0, 0.0, 3.402823466e38, 1e30, 999.999, -1e10, 65535.0})
        for (const double share : {0.002, 0.05, 0.4}) {
            const double value = mark * micrometre;
            const auto map = with_marks(rough(), value, share);
            const auto report = find_no_data(map, in_micrometres);
            ASSERT_EQ(report.values.size(), 1u) << mark << " at " << share;
            EXPECT_TRUE(report.values[0].no_height) << mark << " at " << share;
            EXPECT_EQ(report.values[0].count, (map.heights == value).count());
            EXPECT_EQ(report.defined, map.heights.size());
            EXPECT_GT(report.least, 2e-6);
            EXPECT_LT(report.greatest, 8e-6);
        }
}

TEST(NoData, FindsAUsualMarkNearTheHeights) {  // no gap, but every step to it is a jump
    auto map = rough();
    map.heights = 2500.0 * (map.heights - 5e-6);  // within ±8 mm
    const auto report = find_no_data(with_marks(map, -9999e-6, 0.05), in_micrometres);
    ASSERT_EQ(report.values.size(), 1u);
    EXPECT_TRUE(report.values[0].no_height);
}

TEST(NoData, FindsFewMarksAmongDistinctHeights) {
    auto map = rough(40, 25);
    for (Index k = 7; k < 1000; k += 131) map.heights.data()[k] = 0.0;
    const auto report = find_no_data(map, in_micrometres);
    ASSERT_EQ(report.values.size(), 1u);
    EXPECT_EQ(report.values[0].count, 8);
}

TEST(NoData, FindsSeveralMarks) {
    const auto map = with_marks(with_marks(with_marks(rough(), -9999e-6, 0.1), 32767e-6, 0.01, 2), 1e24, 0.003, 3);
    const auto report = find_no_data(map, in_micrometres);
    ASSERT_EQ(report.values.size(), 3u);
    for (const auto& mark : report.values) EXPECT_TRUE(mark.no_height) << mark.value;
    Measurement measurement = map;
    undefine(measurement, report);
    EXPECT_EQ(std::get<HeightMap>(measurement).heights.isNaN().count(),
              report.values[0].count + report.values[1].count + report.values[2].count);
}

TEST(NoData, FindsASingleImpossibleHeight) {
    auto map = rough();
    map.heights(3, 4) = 1e24;
    const auto report = find_no_data(map, in_micrometres);
    ASSERT_EQ(report.values.size(), 1u);
    EXPECT_TRUE(report.values[0].no_height);
    EXPECT_EQ(report.values[0].count, 1);
}

TEST(NoData, FindsTheExtremesOfTheNumberType) {
    const double code = -32768.0 * 0.37e-9 + 1e-3;
    auto map = rough();
    map.heights = map.heights * 0.2 + 1e-3;
    map = with_marks(map, code, 0.0005);
    EXPECT_TRUE(find_no_data(map, {.unit = micrometre, .codes = {code}}).any_undefined());
}

TEST(NoData, FindsZerosThatAreAllReachedByJumps) {
    LineScan scan{Array1D(4000), 1e-2, false, {}};
    for (Index i = 0; i < 4000; ++i)
        scan.heights[i] = micrometre * (4.0 * std::sin(0.004 * static_cast<double>(i)) + 3.9);
    std::mt19937 engine(5);
    std::uniform_int_distribution<Index> begin(0, 3900), length(3, 60);
    for (int run = 0; run < 20; ++run) scan.heights.segment(begin(engine), length(engine)).setZero();
    const auto report = find_no_data(scan, in_micrometres);
    ASSERT_EQ(report.values.size(), 1u);
    EXPECT_TRUE(report.values[0].no_height);
}

TEST(NoData, OnlySuspectsZerosAmongSimilarHeights) {
    auto map = rough();
    map.heights -= map.heights.mean();
    const auto report = find_no_data(with_marks(map, 0.0, 0.05), in_micrometres);
    ASSERT_EQ(report.values.size(), 1u);
    EXPECT_FALSE(report.values[0].no_height);
    const auto alerts = alerts_of(report, "a.csv", "µm");
    ASSERT_EQ(alerts.size(), 1u);
    EXPECT_EQ(alerts[0].code, "NO_DATA_SUSPECTED");
    EXPECT_NE(alerts[0].message.find("are exactly 0 µm"), std::string::npos);
    EXPECT_NE(alerts[0].action.find("undefine value=\"0 µm\""), std::string::npos);
}

TEST(NoData, OnlySuspectsARegularPattern) {
    auto map = rough();
    for (Index i = 0; i < map.heights.rows(); ++i)
        if (i % 16 < 8) map.heights.row(i).setConstant(100e-6);
    const auto report = find_no_data(map, in_micrometres);
    ASSERT_EQ(report.values.size(), 1u);
    EXPECT_FALSE(report.values[0].no_height);
}

void expect_nothing(const Measurement& measurement, const char* what) {
    EXPECT_TRUE(find_no_data(measurement, in_micrometres).values.empty()) << what;
}

TEST(NoData, FindsNothingInOrdinarySurfaces) {
    expect_nothing(rough(), "rough");
    auto map = rough();
    map.heights = map.heights.max(5e-6);
    expect_nothing(map, "clipped floor");
    map.heights = map.heights.min(5.5e-6);
    expect_nothing(map, "clipped at both ends");
    map.heights = (rough().heights / 0.3e-6).round() * 0.3e-6;
    expect_nothing(map, "quantised");
    map.heights = (rough().heights > 5e-6).select(Array2D::Constant(128, 96, 1e-6), 0.0);
    expect_nothing(map, "two levels");
    for (Index i = 0; i < 128; ++i) map.heights.row(i) = rough().heights.row(i) * 0.01 + (i % 20 < 7 ? 1e-6 : 0.0);
    expect_nothing(map, "step grating");
    map = rough();
    map.heights.block(20, 20, 30, 30).setConstant(undefined);
    expect_nothing(map, "masked already");
    expect_nothing(LineScan{Array1D::Constant(500, 2e-6), 1e-3, false, {}}, "flat");
    expect_nothing(LineScan{Array1D{{1e-6, 2e-6, 2e-6, 3e-6, 1e-6, 0.0, 0.0}}, 1e-3, false, {}}, "few samples");
}

TEST(NoData, IsTheSameByBandsAndForAnyNumberOfThreads) {
    auto map = with_marks(rough(700, 1500), -9999e-6, 0.01);
    map.heights(5, 1400) = undefined;
    const auto one = find_no_data(map, in_micrometres, {1}), four = find_no_data(map, in_micrometres, {4}),
               bands = find_no_data(tiled(map), in_micrometres);
    for (const auto* other : {&four, &bands}) {
        ASSERT_EQ(one.values.size(), other->values.size());
        EXPECT_EQ(one.values[0].count, other->values[0].count);
        EXPECT_EQ(one.values[0].no_height, other->values[0].no_height);
        EXPECT_EQ(one.defined, other->defined);
        EXPECT_EQ(one.least, other->least);
        EXPECT_EQ(one.greatest, other->greatest);
    }
}

}  // namespace
}  // namespace setae::topography::no_data_test
