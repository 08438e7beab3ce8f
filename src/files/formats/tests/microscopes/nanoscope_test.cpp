// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::nanoscope_test {
namespace {

using topography::HeightMap;

std::vector<Channel> opened(const std::string& content) {
    return formats::open(bytes::memory_source("a.di", content), {});
}
/// Replaces a part without moving the following bytes: zeros pad the header.
std::string replaced(std::string content, const std::string& from, const std::string& to) {
    const auto grown = static_cast<long>(to.size()) - static_cast<long>(from.size());
    content.replace(content.find(from), from.size(), to);
    const auto end = content.find('\x1a') + 1;
    return grown > 0 ? content.erase(end, static_cast<std::size_t>(grown))
                     : content.insert(end, static_cast<std::size_t>(-grown), '\0');
}
std::string sample() { return nanoscope_samples().at(0).content; }
std::string message(const std::string& content) {
    return message_of([&] { (void)opened(content); });
}

/// SurfaceTopography failed for maps that are not square.
TEST(Nanoscope, WidthAndHeightStayOnTheirAxes) {
    const auto map = std::get<HeightMap>(opened(sample()).at(0).read());
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{7, 4}));
    EXPECT_DOUBLE_EQ(map.size[0], 700 * units::nm);
    EXPECT_DOUBLE_EQ(map.size[1], 400 * units::nm);
}

TEST(Nanoscope, OneScanSizeUsesTheAspectRatio) {
    EXPECT_DOUBLE_EQ(opened(replaced(sample(), "Scan Size: 700 400 nm", "Scan Size: 700 nm")).at(0).info.size.at(1),
                     700 * units::nm);
    const auto info =
        opened(replaced(sample(), "Scan Size: 700 400 nm", "Scan Size: 700 nm\r\n\\Aspect Ratio: 4:1")).at(0).info;
    EXPECT_DOUBLE_EQ(info.size.at(0), 700 * units::nm);
    EXPECT_DOUBLE_EQ(info.size.at(1), 175 * units::nm);
}

TEST(Nanoscope, ReadsATildeAsMicro) {
    const auto info = opened(replaced(sample(), "Scan Size: 700 400 nm", "Scan Size: 7 4 ~m")).at(0).info;
    EXPECT_NEAR(info.size.at(0), 7 * units::um, 1e-18);
    EXPECT_NEAR(info.size.at(1), 4 * units::um, 1e-18);
}

TEST(Nanoscope, NamesContainTheDirectionOfTheScan) {
    const auto info = opened(replaced(sample(), "\\Bytes/pixel",
                                      "\\Line Direction: Retrace\r\n\\Frame direction: Down\r\n\\Bytes/pixel"))
                          .at(0)
                          .info;
    EXPECT_EQ(info.name, "Height (retrace)");
    EXPECT_EQ(info.metadata.attributes.at("line_direction"), "retrace");
    EXPECT_EQ(info.metadata.attributes.at("scan_direction"), "down");
}

TEST(Nanoscope, OtherQuantitiesHaveTheirUnit) {
    struct Case {
        const char *sensitivity, *scale, *unit;
    };
    for (const auto& [sensitivity, scale, unit] :
         {Case{"20.00000 nA/V", "2.000000 V", "nA"}, Case{"1.000000 ", "180.0000 \xba", "deg"},
          Case{"1.000000 ", "4000 mV", "mV"}, Case{"20.00000 MPa/V", "2.000000 V", "MPa"}}) {
        const auto content =
            replaced(replaced(sample(), "20.00000 nm/V", sensitivity), "2.000000 V\r", fmt::format("{}\r", scale));
        const auto channel = opened(content).at(0);
        EXPECT_EQ(channel.info.unit, unit);
        EXPECT_FALSE(channel.info.is_height) << unit;
    }
}

TEST(Nanoscope, DeflectionInNanometresIsNotAHeight) {
    const auto channel = opened(replaced(sample(), "\"Height\"", "\"Deflection Error\"")).at(0);
    EXPECT_EQ(channel.info.unit, "nm");
    EXPECT_FALSE(channel.info.is_height);
}

TEST(Nanoscope, SensitivityPerMillivoltIsConverted) {
    const auto plain = std::get<HeightMap>(opened(sample()).at(0).read());
    const auto milli = std::get<HeightMap>(opened(replaced(sample(), "20.00000 nm/V", "0.02000 nm/mV")).at(0).read());
    EXPECT_NEAR(milli.heights(3, 2), plain.heights(3, 2), 1e-12 * plain.heights(3, 2));
}

/// Version 5.30 may state another number of points for an image than its block contains; pixels remain square.
TEST(Nanoscope, UsesThePointsOfTheScanIfThoseOfTheImageDoNotFitTheBlock) {
    const auto content = replaced(
        replaced(sample(), "\\Samps/line: 7\r\n\\Number of lines: 4", "\\Samps/line: 14\r\n\\Number of lines: 8"),
        "\\*Ciao image list", "\\*Ciao scan list\r\n\\Samps/line: 7\r\n\\Lines: 4\r\n\\*Ciao image list");
    const auto info = opened(content).at(0).info;
    EXPECT_EQ(info.shape, (std::vector<Index>{7, 4}));
    EXPECT_DOUBLE_EQ(info.size.at(0), 350 * units::nm);
    EXPECT_DOUBLE_EQ(info.size.at(1), 200 * units::nm);
}

TEST(Nanoscope, MissingSensitivityIsReported) {
    const auto channel = opened(replaced(sample(), "\\@Sens. Zsens: V", "\\@Sens. Other: V")).at(0);
    EXPECT_FALSE(channel.info.is_height);
    EXPECT_EQ(channel.info.unit, "V");
    EXPECT_EQ(channel.info.alerts.at(0).code, "SENSITIVITY_MISSING");
}

TEST(Nanoscope, ForceCurvesAreRefusedWithTheCommandToUse) {
    const auto error = message(replaced(sample(), "\\*Ciao image list", "\\*Ciao force image list"));
    EXPECT_NE(error.find("force curves"), std::string::npos) << error;
    EXPECT_NE(error.find("setae jkr fit"), std::string::npos) << error;
}

TEST(Nanoscope, ForceVolumeGivesItsImageAndAWarning) {
    const auto channels = opened(
        replaced(sample(), "\\*Ciao image list", "\\*Ciao force image list\r\n\\Data offset: 9\r\n\\*Ciao image list"));
    ASSERT_EQ(channels.size(), 1u);
    EXPECT_EQ(channels[0].info.alerts.at(0).code, "FORCE_CURVES_NOT_READ");
}

TEST(Nanoscope, OlderVersionsAndTextAreRefusedByName) {
    EXPECT_NE(message(replaced(sample(), "\\@2:Z scale: V [Sens. Zsens]", "\\Z scale: 440")).find("before 4.3"),
              std::string::npos);
    EXPECT_NE(message("?*File list\r\n\\Version: 0x04220200\r\n").find("exported as text"), std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::nanoscope_test
