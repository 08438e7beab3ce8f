// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/scars.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>

#include "record_number.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing::scars_test {
namespace {

using topography::HeightMap;

/// Waves of amplitude 1e-8 with noise of 2 %.
HeightMap ground() {
    std::mt19937 engine(8);
    std::normal_distribution<double> normal(0.0, 2e-10);
    HeightMap map{Array2D(120, 90), {1e-6, 1e-6}};
    for (Index i = 0; i < 120; ++i)
        for (Index j = 0; j < 90; ++j)
            map.heights(i, j) =
                1e-8 * std::sin(0.05 * static_cast<double>(i)) * std::cos(0.03 * static_cast<double>(j)) +
                normal(engine);
    return map;
}

void stroke(HeightMap& map, Index from, Index to, Index line, Index lines, double height) {
    map.heights.block(from, line, to - from, lines) += height;
}

TEST(RemoveScars, FindsStrokesOfEitherSign) {
    auto map = ground();
    stroke(map, 10, 60, 20, 1, 2e-8);
    stroke(map, 30, 100, 50, 3, -2e-8);
    const auto both = find_scars(RemoveScars{}, map), above = find_scars(RemoveScars{.sign = ScarSign::positive}, map),
               below = find_scars(RemoveScars{.sign = ScarSign::negative}, map);
    EXPECT_EQ((both != 0).count(), 50 + 210);
    EXPECT_EQ((above != 0).count(), 50);
    EXPECT_EQ((below != 0).count(), 210);
    EXPECT_TRUE((both.block(10, 20, 50, 1) == 1).all());
    EXPECT_TRUE((both.block(30, 50, 70, 3) == 1).all());
}

TEST(RemoveScars, KeepsShortWideAndLowStrokes) {
    auto map = ground();
    stroke(map, 10, 20, 20, 1, 2e-8);   // ten points long
    stroke(map, 10, 110, 50, 6, 2e-8);  // six lines wide
    EXPECT_EQ((find_scars(RemoveScars{}, map) != 0).count(), 0);
    EXPECT_EQ((find_scars(RemoveScars{.length = 10}, map) != 0).count(), 10);
    EXPECT_EQ((find_scars(RemoveScars{.width = 6}, map) != 0).count(), 600);
}

TEST(RemoveScars, ContinuesIntoTheFadingEndOfAStroke) {
    auto map = ground();
    for (Index i = 20; i < 100; ++i)
        map.heights(i, 40) += i < 70 ? 2e-8 : 0.5e-8;  // half the threshold `high` and more than `low`
    const auto scars = find_scars(RemoveScars{}, map);
    EXPECT_EQ((scars != 0).count(), 80);
}

TEST(RemoveScars, InterpolatesFromNeighbouringLines) {
    const auto clean = ground();
    auto map = clean;
    stroke(map, 10, 60, 20, 2, 2e-8);
    const auto done = apply(RemoveScars{}, map);
    EXPECT_EQ(number_of(done.record, "strokes"), 2.0);
    EXPECT_EQ(number_of(done.record, "scar_points"), 100.0);
    EXPECT_LT((map_of(done).heights - clean.heights).abs().maxCoeff(), 2e-9);
    EXPECT_NEAR(map_of(done).heights(30, 20),
                clean.heights(30, 19) + (clean.heights(30, 22) - clean.heights(30, 19)) / 3.0, 1e-22);
    const auto holes = apply(RemoveScars{.replace_by = ScarReplacement::undefined}, map);
    EXPECT_EQ(map_of(holes).heights.isNaN().count(), 100);
}

TEST(RemoveScars, IgnoresUndefinedPoints) {
    auto map = ground();
    stroke(map, 10, 60, 20, 1, 2e-8);
    map.heights.row(40).setConstant(undefined);
    map.heights.block(15, 21, 3, 1).setConstant(undefined);  // below the stroke: no point there ends it
    const auto scars = find_scars(RemoveScars{.length = 5}, map);
    EXPECT_EQ((scars != 0).count(), 46);
    const auto done = map_of(apply(RemoveScars{.length = 5}, map));
    EXPECT_TRUE(done.heights.row(40).isNaN().all());
}

TEST(RemoveScars, FindsNothingOnAConstantMapOrASingleLine) {
    HeightMap map{Array2D::Constant(40, 30, 2.0), {1.0, 1.0}};
    EXPECT_EQ(number_of(apply(RemoveScars{}, map).record, "strokes"), 0.0);
    map.heights = Array2D::Random(40, 1);
    EXPECT_EQ(number_of(apply(RemoveScars{}, map).record, "strokes"), 0.0);
}

TEST(RemoveScars, RefusesInvalidParameters) {
    EXPECT_THROW((void)apply(RemoveScars{.high = 0.1}, ground()), InvalidArgument);
    EXPECT_THROW((void)apply(RemoveScars{.low = 0.0}, ground()), InvalidArgument);
    EXPECT_THROW((void)apply(RemoveScars{.length = 0}, ground()), InvalidArgument);
    EXPECT_THROW((void)apply(RemoveScars{}, topography::LineScan{Array1D::Zero(9), 1.0}), InvalidArgument);
}

TEST(RemoveScars, GivesTheSameForAnyNumberOfThreads) {
    auto map = ground();
    stroke(map, 10, 60, 20, 1, 2e-8);
    EXPECT_TRUE(
        (map_of(apply(RemoveScars{}, map, {1})).heights == map_of(apply(RemoveScars{}, map, {3})).heights).all());
}

TEST(FindScars, LoadsEveryRowTwice) {
    auto map = ground();
    stroke(map, 10, 60, 20, 1, 2e-8);
    stroke(map, 30, 100, 50, 3, -2e-8);
    std::atomic<Index> loaded = 0;
    const RowsOfHeights rows{map.heights.rows(), map.heights.cols(), [&](Index first, Index last, double* room) {
                                 loaded += last - first;
                                 for (Index i = first; i < last; ++i)
                                     for (Index j = 0; j < 90; ++j) *room++ = map.heights(i, j);
                                 return room - (last - first) * 90;
                             }};
    EXPECT_TRUE((find_scars(RemoveScars{}, rows, {2}) == find_scars(RemoveScars{}, map)).all());
    EXPECT_EQ(loaded, 2 * map.heights.rows());
}

}  // namespace
}  // namespace setae::processing::scars_test
