// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "patched_sample.hpp"

using namespace setae::tests;

namespace setae::formats::tests::bcr_test {
namespace {

/// 2 × 2 points: 0, 1, 2 and one more.
std::string integers(const std::string& entries, std::int16_t last = 3) {
    const auto header = "fileformat = bcrstm\nxpixels = 2\nypixels = 2\nxlength = 20\nylength = 20\n" + entries;
    return ByteBuilder()
        .text(header, 2048, ' ')
        .number<std::int16_t>(0)
        .number<std::int16_t>(1)
        .number<std::int16_t>(2)
        .number(last)
        .content();
}

TEST(Bcr, CountOfVoidsIsNotAHeight) {
    const auto heights = map_of(channels_of(integers("bit2nm = 1\nvoidpixels = 0\n")).at(0)).heights;
    EXPECT_EQ(heights.isNaN().count(), 0) << "zero voids, and a height of zero";
    EXPECT_DOUBLE_EQ(heights(1, 1), 3e-9);
    EXPECT_TRUE(std::isnan(map_of(channels_of(integers("bit2nm = 1\nvoidpixels = 1\n", 32767)).at(0)).heights(1, 1)));
}

TEST(Bcr, VoidsOfNanoFocusAreUndefined) {
    const auto sample = bcr_samples().at(4);
    const auto channel = channels_of(sample.content).at(0);
    EXPECT_EQ(map_of(channel).heights.isNaN().count(), 1)
        << "the header says 3.402823E+38, the values are 3.4028235e38";
    ASSERT_EQ(channel.info.alerts.size(), 1u);
    EXPECT_EQ(channel.info.alerts[0].code, "SIZE_BETWEEN_POINTS");
}

TEST(Bcr, LengthsSpanAllPixels) {
    EXPECT_NEAR(channels_of(integers("bit2nm = 1\n")).at(0).info.size.at(0), 20e-9, 1e-23);
    EXPECT_TRUE(channels_of(integers("bit2nm = 1\n")).at(0).info.alerts.empty());
    EXPECT_NEAR(channels_of(integers("bit2nm = 1\nxunit = um\n")).at(0).info.size.at(0), 20e-6, 1e-20);
}

TEST(Bcr, OtherUtf16FilesAreNotBcr) {
    const std::string foreign("\xff\xfe\x00\xd8\x00\xd8x\0=\0", 10);
    EXPECT_EQ(refusal(foreign).find("BCR"), std::string::npos) << refusal(foreign);
    EXPECT_NE(refusal(foreign), "no error");
}

TEST(Bcr, IntegersWithoutScaleRequireAUnit) {
    EXPECT_EQ(missing(channels_of(integers("")).at(0).info).at(0), "unit");
    EXPECT_DOUBLE_EQ(map_of(channels_of(integers(""), {.size = {}, .unit = "um"}).at(0)).heights(1, 1), 3e-6);
}

TEST(Bcr, ChannelInVoltsIsListedButNotAHeight) {
    const auto channel = channels_of(integers("bit2nm = 1\nzunit = V\n")).at(0);
    EXPECT_FALSE(channel.info.is_height);
    EXPECT_EQ(channel.info.unit, "V");
}

TEST(Bcr, KeepsTimeAndOffsets) {
    const auto metadata =
        channels_of(integers("bit2nm = 1\nstarttime = 07 04 98 13:09:52\nxoffset = 17\n")).at(0).info.metadata;
    EXPECT_EQ(metadata.acquisition_time, "07 04 98 13:09:52");
    EXPECT_EQ(metadata.attributes.at("xoffset"), "17");
}

TEST(Bcr, ForceCurvesAreRefused) {
    EXPECT_NE(refusal(integers("forcecurve = 1\n")).find("a force curve, not a map"), std::string::npos);
}

TEST(Bcr, BrokenHeadersAreRefused) {
    EXPECT_NE(refusal(integers("intelmode = yes\n")).find("'intelmode' is 'yes', expected a number"),
              std::string::npos);
    EXPECT_NE(
        refusal("fileformat = bcrstm\nxpixels = 2.5\nypixels = 2\n" + std::string(4096, ' ')).find("'xpixels' is 2.5"),
        std::string::npos);
    EXPECT_NE(refusal("fileformat = bcrxy\nxpixels = 2\n" + std::string(4096, ' ')).find("fileformat is 'bcrxy'"),
              std::string::npos);
    EXPECT_NE(refusal("fileformat = bcrf\nheadersize = 1e9\n" + std::string(4096, ' '))
                  .find("a header of 1000000000 characters"),
              std::string::npos);
    EXPECT_NE(refusal(integers("bit2nm = 1\nxunit = s\n")).find("xunit is 's', expected a unit of length"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::bcr_test
