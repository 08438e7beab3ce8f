// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/crop.hpp"

#include <gtest/gtest.h>

#include "record_number.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing::crop_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

/// 10 x 8 points of 1 µm, each height its number.
HeightMap numbered() {
    HeightMap map{Array2D(10, 8), {10e-6, 8e-6}, true};
    for (Index k = 0; k < 80; ++k) map.heights.data()[k] = static_cast<double>(k);
    return map;
}

TEST(Crop, TakesAWindowInMetresWithItsEnds) {
    const auto done = apply(Crop{.x_from = 2e-6, .x_to = 5e-6, .y_from = 1e-6}, numbered());
    const auto& map = map_of(done);
    ASSERT_EQ(map.heights.rows(), 4);
    ASSERT_EQ(map.heights.cols(), 7);
    EXPECT_EQ(map.heights(0, 0), 17.0);
    EXPECT_EQ(map.heights(3, 6), 47.0);
    EXPECT_DOUBLE_EQ(map.size[0], 4e-6);
    EXPECT_DOUBLE_EQ(map.size[1], 7e-6);
    EXPECT_FALSE(map.periodic);
    EXPECT_DOUBLE_EQ(number_of(done.record, "x_offset"), 2e-6);
    EXPECT_DOUBLE_EQ(number_of(done.record, "y_offset"), 1e-6);
}

TEST(Crop, RemovesPointsAtEachSide) {
    const auto map = map_of(apply(Crop{.cut_left = 1, .cut_right = 2, .cut_first = 3, .cut_last = 1}, numbered()));
    ASSERT_EQ(map.heights.rows(), 7);
    ASSERT_EQ(map.heights.cols(), 4);
    EXPECT_EQ(map.heights(0, 0), 11.0);
    EXPECT_EQ(map.heights(6, 3), 62.0);
}

TEST(Crop, OfZeroPointsKeepsAPeriodicMapPeriodic) {
    EXPECT_TRUE(map_of(apply(Crop{.x_from = 0.0, .x_to = 1.0}, numbered())).periodic);
}

TEST(Crop, WorksForLinesAndPolylines) {
    const LineScan scan{Array1D::LinSpaced(10, 0.0, 9.0), 10.0};
    const auto line = line_of(apply(Crop{.x_from = 2.5, .x_to = 7.0}, scan));
    ASSERT_EQ(line.heights.size(), 5);
    EXPECT_EQ(line.heights[0], 3.0);
    EXPECT_DOUBLE_EQ(line.size, 5.0);
    Profile profile{Array1D::LinSpaced(10, 100.0, 109.0), Array1D::LinSpaced(10, 0.0, 9.0), {}};
    profile.standard_error = Array1D::LinSpaced(10, 0.0, 9.0);
    const auto part = profile_of(apply(Crop{.x_from = 102.5, .x_to = 107.0}, profile));
    ASSERT_EQ(part.positions.size(), 5);
    EXPECT_EQ(part.positions[0], 103.0);
    EXPECT_EQ(part.standard_error[4], 7.0);
}

TEST(Crop, RefusesEmptyWindowsAndMixedParameters) {
    EXPECT_THROW((void)apply(Crop{.x_from = 20e-6}, numbered()), InvalidArgument);
    EXPECT_THROW((void)apply(Crop{.x_from = 3e-6, .x_to = 3e-6}, numbered()), InvalidArgument);
    EXPECT_THROW((void)apply(Crop{.x_from = 3e-6, .x_to = 1e-6}, numbered()), InvalidArgument);
    EXPECT_THROW((void)apply(Crop{.x_from = 3e-6, .cut_right = 1}, numbered()), InvalidArgument);
    EXPECT_THROW((void)apply(Crop{.cut_left = -1}, numbered()), InvalidArgument);
    EXPECT_THROW((void)apply(Crop{.cut_left = 5, .cut_right = 5}, numbered()), InvalidArgument);
    EXPECT_THROW((void)apply(Crop{.y_from = 1.0}, LineScan{Array1D::Zero(10), 10.0}), InvalidArgument);
    EXPECT_THROW((void)apply(Crop{.cut_left = 30}, Profile{Array1D::LinSpaced(10, 0.0, 1.0), Array1D::Zero(10), {}}),
                 InvalidArgument);
}

}  // namespace
}  // namespace setae::processing::crop_test
