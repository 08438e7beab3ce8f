// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "patched_sample.hpp"

namespace setae::formats::tests::frt_test {
namespace {

TEST(Frt, FirstStoredRowIsAtTheBottom) {
    const auto map = map_of(channels_of(frt_samples().at(0).content).at(0));
    EXPECT_LT(map.heights(0, 0), map.heights(0, 3))
        << "heights grow downwards in the sample, whose last row stands first in the file";
    EXPECT_NE(channels_of(frt_samples().at(0).content).at(0).info.orientation.find("not stated in the file"),
              std::string::npos);
}

TEST(Frt, SingleMapIsNotListedTwice) {
    const auto channels = channels_of(frt_samples().at(2).content);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.name, "Topography");
    EXPECT_EQ(channels[1].info.name, "Intensity");
    EXPECT_FALSE(channels[1].info.is_height);
}

TEST(Frt, SensorOfAnImageIsNamed) {
    EXPECT_EQ(channels_of(frt_samples().at(3).content).at(0).info.name, "Thickness (bottom sensor)");
}

TEST(Frt, ReadsInstrumentAndTime) {
    const auto metadata = channels_of(frt_samples().at(1).content).at(0).info.metadata;
    EXPECT_EQ(metadata.instrument.name, "FRT MicroProf");
    EXPECT_EQ(metadata.acquisition_time, "2023-06-26 16:22:25 UTC");
    EXPECT_EQ(metadata.attributes.at("serial_number"), "SN_1036");
    EXPECT_EQ(metadata.attributes.at("description"), "a wafer");
}

TEST(Frt, OtherVersionsAreRefused) {
    auto file = frt_samples().at(0).content;
    file.replace(12, 4, "2.00");
    EXPECT_EQ(refusal(file), "file: at byte 12: FRT: version '2.00', expected 1.00 or 1.01");
}

TEST(Frt, MapThatDoesNotFillItsBlockIsRefused) {
    const auto file = frt_samples().at(0).content;
    const auto points = file.find(std::string("\x66\x00\x0c\x00\x00\x00", 6)) + 6;
    EXPECT_NE(refusal(with_number<std::uint32_t>(file, points + 8, 24)).find("values of 24 bits, expected 16 or 32"),
              std::string::npos);
    EXPECT_NE(refusal(with_number<std::uint32_t>(file, points, 70)).find("70 × 4"), std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::frt_test
