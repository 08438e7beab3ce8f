// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::nanosurf_test {
namespace {

std::vector<Channel> opened(const std::string& content) {
    return formats::open(bytes::memory_source("a.nid", content), {});
}
std::string replaced(std::string content, const std::string& from, const std::string& to) {
    return content.replace(content.rfind(from), from.size(), to);
}
std::string message(const std::string& content) {
    return message_of([&] { (void)opened(content).back().read(); });
}

/// SurfaceTopography ignored Dim2Min.
TEST(Nanosurf, SmallestIntegerIsDim2Min) {
    for (const auto& sample : nanosurf_samples()) {
        const auto map = std::get<topography::HeightMap>(opened(sample.content).at(2).read());
        const double step = 9.5 * units::um;  // over 2^bits
        EXPECT_GE(map.heights(0, 0), -2.0 * units::um) << sample.name;
        EXPECT_LE(map.heights(0, 0), -2.0 * units::um + 20.0 * step / 256.0) << sample.name;
    }
}

/// SurfaceTopography used the units of the axes for the heights.
TEST(Nanosurf, EachAxisHasItsOwnUnit) {
    const auto info = opened(nanosurf_samples().at(2).content).at(2).info;
    EXPECT_DOUBLE_EQ(info.size.at(0), 3 * units::um);
    EXPECT_DOUBLE_EQ(info.size.at(1), 1 * units::um);
    EXPECT_EQ(info.unit, "µm");
}

TEST(Nanosurf, ChannelsFollowInOrderOfTheirNumbers) {
    const auto channels = opened(nanosurf_samples().at(2).content);
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[0].info.name, "Amplitude (Scan forward)");
    EXPECT_EQ(channels[1].info.name, "Phase (Scan forward)");
    EXPECT_EQ(channels[2].info.name, "Z-Axis (Scan backward)");
    EXPECT_EQ(channels[0].info.unit, "V");
    EXPECT_EQ(channels[1].info.unit, "deg");
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_EQ(channels[2].info.metadata.instrument.name, "Nanosurf FlexAFM");
    EXPECT_EQ(channels[2].info.metadata.acquisition_time, "07-08-2018 12:56:42");
    EXPECT_EQ(channels[2].info.metadata.attributes.at("line_direction"), "backward");
}

/// SurfaceTopography had its test of the first line inverted.
TEST(Nanosurf, DetectsOnlyFilesThatBeginWithTheFirstSection) {
    const auto content = nanosurf_samples().at(2).content;
    EXPECT_EQ(detect_format(bytes::memory_source("a.nid", content)).identifier, "nanosurf");
    EXPECT_NE(message(replaced(content, "[DataSet]\r\n", "[Dataset]\r\n")), "no error");
    EXPECT_NE(message("[DataSet-Info]\r\n" + content), "no error");
}

TEST(Nanosurf, SpectraAreListedButNotHeights) {
    const auto content = replaced(nanosurf_samples().at(2).content, "Dim0Unit=nm", "Dim0Unit=V");
    EXPECT_FALSE(opened(content).at(2).info.is_height);
}

TEST(Nanosurf, UnsupportedContentIsNamed) {
    const auto content = nanosurf_samples().at(2).content;
    EXPECT_NE(message(replaced(content, "SaveMode=Binary", "SaveMode=ASCII")).find("'ASCII'"), std::string::npos);
    EXPECT_NE(message(replaced(content, "SaveBits=16", "SaveBits=24")).find("'24' bits"), std::string::npos);
    EXPECT_NE(message(replaced(content, "Points=6", "Points=2000000000")).find("2000000000 × 4"), std::string::npos);
    EXPECT_NE(message(replaced(content, "[DataSet]\r", "[DataSet]\rx")).find("names no channel"), std::string::npos);
    EXPECT_NE(message(replaced(content, "Dim2Range=9.5", "Dim2Range=wide")).find("'Dim2Range' is 'wide'"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::nanosurf_test
