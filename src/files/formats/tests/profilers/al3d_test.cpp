// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "al3d_samples.hpp"
#include "counted_source.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::al3d_test {
namespace {

Array1D heights_of(const Array2D& stored, const std::string& marker) {
    return topography::all_heights(
        open(bytes::memory_source("a.al3d", al3d_file(stored, {{"InvalidPixelValue", marker}})), {}).at(0).read());
}

std::string refusal(const std::string& content) {
    return message_of([&] { (void)open(bytes::memory_source("a.al3d", content), {}); });
}

TEST(Al3d, NegativeMarkerOfInvalidPixelsIsUndefined) {
    auto stored = lopsided_heights(3, 2, 1e-6);
    stored(1, 0) = -9999.0;
    const auto heights = heights_of(stored, "-9.999e+03");
    EXPECT_TRUE(std::isnan(heights[2]));
    EXPECT_EQ(heights.isNaN().count(), 1);
}

TEST(Al3d, OnlyValuesNearTheMarkerAreUndefined) {
    auto stored = lopsided_heights(4, 2, 1e-6);
    stored(0, 0) = 3e15 * (1.0 + 1.2e-7);
    stored(1, 0) = 3e15 * (1.0 - 1.2e-7);
    stored(2, 0) = 3e15 * (1.0 + 4e-7);
    const auto heights = heights_of(stored, "3.0e+15");
    EXPECT_TRUE(std::isnan(heights[0]));
    EXPECT_TRUE(std::isnan(heights[2]));
    EXPECT_FALSE(std::isnan(heights[4]));
}

TEST(Al3d, ZeroAsMarkerMatchesExactZeroOnly) {
    auto stored = lopsided_heights(3, 2, 1e-6);
    stored(2, 1) = 0.0;
    EXPECT_EQ(heights_of(stored, "0").isNaN().count(), 1);
    EXPECT_EQ(heights_of(stored, "nan").isNaN().count(), 0);
}

TEST(Al3d, ReadsTheImageOnlyOnce) {
    CountedSource counted(al3d_file(lopsided_heights(301, 201, 1e-6), {}));
    const auto channels = open(counted.source(), {});
    EXPECT_LT(counted.bytes(), 3u << 16);  // to detect and to walk the tags
    counted.reset();
    (void)channels.at(0).read();
    EXPECT_LE(counted.bytes(), 302u * 201u * 4u);
}

TEST(Al3d, KeepsItsCommentAndApplication) {
    const auto info = open(bytes::memory_source("a.al3d", al3d_file(lopsided_heights(3, 2, 1e-6),
                                                                    {{"CreatingApplication", "MeasureSuite 5.3.6"}})),
                           {})
                          .at(0)
                          .info;
    EXPECT_EQ(info.metadata.attributes.at("comment"), "polished");
    EXPECT_EQ(info.metadata.attributes.at("software_version"), "MeasureSuite 5.3.6");
    EXPECT_EQ(info.unit, "m");
}

TEST(Al3d, DamagedTagsAreRefusedWithTheOffset) {
    const auto content = al3d_file(lopsided_heights(3, 2, 1e-6), {});
    auto damaged = content;
    damaged[17 + 52 + 50] = 'x';
    EXPECT_NE(refusal(damaged).find("at byte 69: Alicona: the tag 'TagCount' does not end with CR LF"),
              std::string::npos)
        << refusal(damaged);
    damaged = content;
    damaged.replace(damaged.find("Cols"), 4, "Colt");
    EXPECT_NE(refusal(damaged).find("the tag 'Cols' is missing"), std::string::npos) << refusal(damaged);
    damaged = content;
    damaged.replace(17 + 52 + 20, 9, "999999999");
    EXPECT_NE(refusal(damaged).find("'999999999' tags announced"), std::string::npos) << refusal(damaged);
}

TEST(Al3d, FilesWithPicturesOnlyAreRefused) {
    auto content = al3d_file(lopsided_heights(3, 2, 1e-6), {});
    const auto at = content.find("DepthImageOffset") + 20;
    content.replace(at, 30, std::string("0") + std::string(29, '\0'));
    EXPECT_NE(refusal(content).find("no depth image"), std::string::npos) << refusal(content);
}

}  // namespace
}  // namespace setae::formats::tests::al3d_test
