// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "counted_source.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "mdt_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::mdt_test {
namespace {

const Array2D raw = lopsided_heights(5, 3, 1.0);

std::vector<Channel> channels_of(const std::vector<std::string>& frames) {
    return open(bytes::memory_source("a.mdt", mdt_file(frames)), {});
}

std::string refusal(const std::string& content) {
    return message_of([&] { (void)open(bytes::memory_source("a.mdt", content), {}); });
}

TEST(Mdt, FramesAreChannelsInTheirOrder) {
    const auto channels = channels_of({mdt_scan(raw, 1.0f, 0.0f, -1, "a"), mdt_scan(raw, 1.0f, 0.0f, 2, "b"),
                                       mdt_spectrum(), mdt_scan(raw, 1.0f, 0.0f, 0, "")});
    ASSERT_EQ(channels.size(), 4u);
    EXPECT_EQ(channels[0].info.name, "a");
    EXPECT_TRUE(channels[0].info.is_height);
    EXPECT_EQ(channels[1].info.unit, "V");
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_EQ(channels[2].info.name, "frame 2: spectroscopy");
    EXPECT_EQ(channels[3].info.name, "Height");
    EXPECT_EQ(channels[3].info.unit, "Å");
}

TEST(Mdt, HeightIsOffsetPlusStepTimesInteger) {
    const auto heights = topography::all_heights(channels_of({mdt_scan(raw, -0.5f, 3.0f, 0, "")}).at(0).read());
    EXPECT_NEAR(heights[0], (3.0 - 0.5 * raw(0, 0)) * units::angstrom, 1e-24);
}

TEST(Mdt, NegativeStepsAreReadAsLengths) {
    const auto info = channels_of({mdt_scan(raw, 1.0f, 0.0f, -1, "")}).at(0).info;
    EXPECT_DOUBLE_EQ(info.size[1], 9.0 * units::nm);
    EXPECT_EQ(info.metadata.acquisition_time, "2015-01-17 12:34:56");
}

TEST(Mdt, CyrillicTitlesAreRead) {
    EXPECT_EQ(channels_of({mdt_scan(raw, 1.0f, 0.0f, -1, "\xc2\xfb\xf1\xee\xf2\xe0 1")}).at(0).info.name, "Высота 1");
}

TEST(Mdt, MapsWithoutHeightStepAreListedWithAWarning) {
    const auto info = channels_of({mdt_scan(raw, 0.0f, 0.0f, -1, "")}).at(0).info;
    EXPECT_FALSE(info.is_height);
    ASSERT_EQ(info.alerts.size(), 1u);
    EXPECT_EQ(info.alerts[0].code, "NO_HEIGHT_SCALE");
}

TEST(Mdt, FilesWithSpectraOnlyAreRefusedWithTheRemedy) {
    const auto message = refusal(mdt_file({mdt_spectrum(), mdt_spectrum()}));
    EXPECT_NE(message.find("2 frames without a map"), std::string::npos) << message;
    EXPECT_NE(message.find("setae jkr fit"), std::string::npos) << message;
}

TEST(Mdt, MapsLargerThanTheirFrameAreRefused) {
    auto first = mdt_scan(raw, 1.0f, 0.0f, -1, "");
    first[22 + 130 + 4] = 60;  // rows
    const auto message = refusal(mdt_file({first, mdt_scan(raw, 1.0f, 0.0f, -1, std::string(600, 'x'))}));
    EXPECT_NE(message.find("their frame ends at"), std::string::npos) << message;
}

TEST(Mdt, OpenReadsHeadersOnly) {
    const CountedSource counted(mdt_file({mdt_scan(lopsided_heights(1000, 900, 0.1), 1.0f, 0.0f, -1, "")}));
    (void)open(counted.source(), {});
    EXPECT_LT(counted.bytes(), 5u << 16);
}

}  // namespace
}  // namespace setae::formats::tests::mdt_test
