// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "enclosed_mask.hpp"
#include "reference_data.hpp"
#include "setae/imaging/contour_trace.hpp"
#include "setae/imaging/micrograph.hpp"
#include "setae/imaging/scale_bar.hpp"

namespace setae::imaging::contours_test {
namespace {

void expect_enclosed(const std::filesystem::path& path, std::size_t outlines) {
    const auto mask = read_micrograph(path.string()).pixels;
    const auto trace = trace_contour(mask);
    EXPECT_TRUE(trace.binary);
    EXPECT_EQ(trace.vacuum, Vacuum::dark);
    EXPECT_EQ(trace.segments.size(), outlines);
    const auto again = tests::enclosed(trace.segments, mask.cols(), mask.rows());
    EXPECT_EQ(((again == 1) != (mask > mask.minCoeff())).count(), 0);
    EXPECT_GT((again == 1).count(), 300'000);
}

TEST(Contours, OfMasksEncloseTheirPixelsExactly) {
    SETAE_REQUIRE_REFERENCE_DATA(first, "tem/20180529_A9_003.TIF");
    SETAE_REQUIRE_REFERENCE_DATA(second, "tem/Case4_D8_007.TIF");
    expect_enclosed(first, 13);
    expect_enclosed(second, 14);
}

TEST(Contours, OfSootRunsBetweenFringeAndSample) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "tem/ExampleImage.tif");
    const auto pixels = read_micrograph(path.string()).pixels;
    const auto trace = trace_contour(pixels, {.hidden = annotations(pixels)});
    ASSERT_EQ(trace.segments.size(), 1U);
    const auto& edge = trace.segments.front();
    EXPECT_TRUE(edge.fringe);
    EXPECT_TRUE(edge.converged);
    EXPECT_LT(edge.standard_error.mean(), 0.6);
    const Anchor seen[]{{370, 44}, {185, 200}, {235, 305}, {186, 406}, {465, 165}};
    for (const auto& place : seen) {
        const double nearest = std::sqrt(((edge.x - place.x).square() + (edge.y - place.y).square()).minCoeff());
        EXPECT_LT(nearest, 3) << place.x << ", " << place.y;
    }
}

}  // namespace
}  // namespace setae::imaging::contours_test
