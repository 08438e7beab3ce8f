// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/line_profile.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::processing::line_profile_test {
namespace {

/// Heights without pattern on 40 × 30 points, pixels of 0.1 and 0.3 µm.
topography::HeightMap rough() {
    topography::HeightMap map{Array2D(40, 30), {40 * 0.1e-6, 30 * 0.3e-6}, false, {}};
    for (Index i = 0; i < 40; ++i)
        for (Index j = 0; j < 30; ++j)
            map.heights(i, j) =
                1e-9 * std::sin(12.9898 * static_cast<double>(i) + 78.233 * static_cast<double>(j)) * 43.7;
    return map;
}

topography::HeightMap plane(double slope_x, double slope_y) {
    auto map = rough();
    for (Index i = 0; i < 40; ++i)
        for (Index j = 0; j < 30; ++j)
            map.heights(i, j) = slope_x * 0.1e-6 * static_cast<double>(i) + slope_y * 0.3e-6 * static_cast<double>(j);
    return map;
}

TEST(LineProfile, AlongGridLinesGivesTheStoredHeights) {
    const auto map = rough();
    const auto along_x = line_profile(map, {.from = {0.0, 7 * 0.3e-6}, .to = {39 * 0.1e-6, 7 * 0.3e-6}});
    ASSERT_EQ(along_x.scan.heights.size(), 40);
    for (Index i = 0; i < 40; ++i) EXPECT_EQ(along_x.scan.heights[i], map.heights(i, 7));
    EXPECT_NEAR(along_x.scan.pixel_size(), 0.1e-6, 1e-18);
    const auto along_y = line_profile(map, {.from = {11 * 0.1e-6, 25 * 0.3e-6}, .to = {11 * 0.1e-6, 4 * 0.3e-6}});
    ASSERT_EQ(along_y.scan.heights.size(), 22);
    for (Index j = 0; j < 22; ++j) EXPECT_EQ(along_y.scan.heights[j], map.heights(11, 25 - j));
}

TEST(LineProfile, OfAPlaneIsARampInAnyDirection) {
    const auto map = plane(0.2, -0.05);
    const auto profile = line_profile(map, {.from = {0.13e-6, 1.1e-6}, .to = {3.7e-6, 7.9e-6}});
    for (Index p = 0; p < profile.x.size(); ++p)
        EXPECT_NEAR(profile.scan.heights[p], 0.2 * profile.x[p] - 0.05 * profile.y[p], 1e-18);
    EXPECT_DOUBLE_EQ(profile.x[profile.x.size() - 1], 3.7e-6);
    EXPECT_DOUBLE_EQ(profile.y[profile.y.size() - 1], 7.9e-6);
}

TEST(LineProfile, WithAWidthIsTheMeanOfParallelLines) {
    const auto map = rough();
    const auto profile =
        line_profile(map, {.from = {0.0, 10 * 0.3e-6}, .to = {39 * 0.1e-6, 10 * 0.3e-6}, .width = 5 * 0.3e-6});
    EXPECT_EQ(profile.tracks, 5);
    for (Index i = 0; i < 40; ++i) EXPECT_NEAR(profile.scan.heights[i], map.heights.row(i).segment(8, 5).mean(), 1e-22);
}

TEST(LineProfile, IgnoresUndefinedTracksInItsMean) {
    auto map = rough();
    map.heights(12, 10) = undefined;
    const ProfileLine thin{.from = {0.0, 10 * 0.3e-6}, .to = {39 * 0.1e-6, 10 * 0.3e-6}},
        wide{thin.from, thin.to, 3 * 0.3e-6, {}};
    EXPECT_TRUE(std::isnan(line_profile(map, thin).scan.heights[12]));
    EXPECT_NEAR(line_profile(map, wide).scan.heights[12], 0.5 * (map.heights(12, 9) + map.heights(12, 11)), 1e-22);
    // at the border tracks outside are missing too
    const auto border = line_profile(map, {.from = {0.0, 0.0}, .to = {39 * 0.1e-6, 0.0}, .width = 3 * 0.3e-6});
    EXPECT_NEAR(border.scan.heights[20], 0.5 * (map.heights(20, 0) + map.heights(20, 1)), 1e-22);
}

TEST(LineProfile, ContinuesAcrossThePeriod) {
    auto map = rough();
    map.periodic = true;
    const auto profile = line_profile(map, {.from = {38 * 0.1e-6, 0.0}, .to = {43 * 0.1e-6, 0.0}});
    ASSERT_EQ(profile.scan.heights.size(), 6);
    EXPECT_EQ(profile.scan.heights[1], map.heights(39, 0));
    EXPECT_EQ(profile.scan.heights[2], map.heights(0, 0));
    EXPECT_EQ(profile.scan.heights[5], map.heights(3, 0));
}

TEST(LineProfile, EndsAtTheLastPointForAnEndAtTheEdgeOfTheMap) {
    const auto map = rough();
    const double edge = 40 * 0.1e-6 * (1.0 + 1e-15);
    const auto to_edge = line_profile(map, {.from = {0.0, 7 * 0.3e-6}, .to = {edge, 7 * 0.3e-6}});
    ASSERT_EQ(to_edge.scan.heights.size(), 40);
    EXPECT_DOUBLE_EQ(to_edge.x[39], 39 * 0.1e-6);
    for (Index i = 0; i < 40; ++i) EXPECT_EQ(to_edge.scan.heights[i], map.heights(i, 7));
    const auto to_corner = line_profile(map, {.from = {0.0, 0.0}, .to = map.size});
    EXPECT_EQ(to_corner.scan.heights[to_corner.scan.heights.size() - 1], map.heights(39, 29));
}

TEST(LineProfile, RefusesAnEndOutsideTheMapWithLengthsInPrefixes) {
    try {
        (void)line_profile(rough(), {.from = {0.0, 0.0}, .to = {4.01e-6, 9e-6}});
        FAIL() << "an end outside the map was accepted";
    } catch (const InvalidArgument& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("(4.01000 µm, 9.00000 µm); expected between (0, 0) and (4.00000 µm, 9.00000 µm)"),
                  std::string::npos)
            << message;
    }
}

TEST(LineProfile, RefusesInvalidLines) {
    const auto map = rough();
    EXPECT_THROW((void)line_profile(map, {.from = {0.0, 0.0}, .to = {0.0, 0.0}}), InvalidArgument);
    EXPECT_THROW((void)line_profile(map, {.from = {0.0, 0.0}, .to = {41 * 0.1e-6, 0.0}}), InvalidArgument);
    EXPECT_THROW((void)line_profile(map, {.from = {0.0, 0.0}, .to = {1e-6, 0.0}, .width = -1.0}), InvalidArgument);
    EXPECT_THROW((void)line_profile(map, {.from = {0.0, 0.0}, .to = {1e-6, 0.0}, .points = 1}), InvalidArgument);
    EXPECT_THROW((void)line_profile(map, {.from = {0.0, std::nan("")}, .to = {1e-6, 0.0}}), InvalidArgument);
}

}  // namespace
}  // namespace setae::processing::line_profile_test
