// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/height_preview.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"

namespace setae::study::height_preview_test {
namespace {

TEST(HeightPreviewOf, AShortLineIsUnchanged) {
    topography::LineScan scan;
    scan.heights = Array1D::LinSpaced(20, 0.0, 1e-9);
    scan.size = 2e-6;
    const auto preview = height_preview(scan, 10);
    ASSERT_EQ(preview.heights.size(), 20);
    EXPECT_TRUE((preview.heights == scan.heights).all());
    EXPECT_DOUBLE_EQ(preview.positions[19], 1.9e-6);
    EXPECT_EQ(preview.map.size(), 0);
}

TEST(HeightPreviewOf, ALongLineKeepsPeaksAndEnds) {
    topography::LineScan scan;
    scan.heights = Array1D::Zero(100000);
    scan.heights[31415] = 5e-9;
    scan.heights[92653] = -7e-9;
    scan.size = 1e-3;
    const auto preview = height_preview(scan, 100);
    EXPECT_LE(preview.heights.size(), 202);
    EXPECT_EQ(preview.heights.maxCoeff(), 5e-9);
    EXPECT_EQ(preview.heights.minCoeff(), -7e-9);
    EXPECT_EQ(preview.positions[0], 0.0);
    EXPECT_DOUBLE_EQ(preview.positions[preview.positions.size() - 1], 99999 * 1e-8);
    for (Index i = 1; i < preview.positions.size(); ++i) EXPECT_GT(preview.positions[i], preview.positions[i - 1]);
}

TEST(HeightPreviewOf, AGapRemainsAGap) {
    topography::Profile profile;
    profile.positions = Array1D::LinSpaced(1000, 0.0, 1e-6);
    profile.heights = Array1D::Zero(1000);
    profile.heights.segment(400, 200).setConstant(undefined);
    const auto preview = height_preview(profile, 10);
    EXPECT_TRUE(preview.heights.isNaN().any());
    EXPECT_DOUBLE_EQ(preview.size[0], 1e-6);
}

TEST(HeightPreviewOf, AMapAveragesDefinedPixels) {
    topography::HeightMap map;
    map.heights = Array2D(4, 6);
    for (Index i = 0; i < 4; ++i)
        for (Index j = 0; j < 6; ++j) map.heights(i, j) = static_cast<double>(10 * i + j);
    map.heights(0, 0) = undefined;
    map.size = {4e-6, 6e-6};
    const auto preview = height_preview(map, 10, 2);
    ASSERT_EQ(preview.map.rows(), 2);
    ASSERT_EQ(preview.map.cols(), 2);
    EXPECT_DOUBLE_EQ(preview.map(0, 0), (1.0 + 2.0 + 10.0 + 11.0 + 12.0) / 5.0);
    EXPECT_DOUBLE_EQ(preview.map(1, 1), 29.0);
    const auto whole = height_preview(map);
    EXPECT_EQ(whole.map.rows(), 4);
    EXPECT_EQ(whole.map.cols(), 6);
    EXPECT_EQ(whole.map(3, 5), 35.0);
    EXPECT_EQ(whole.size[1], 6e-6);
}

}  // namespace
}  // namespace setae::study::height_preview_test
