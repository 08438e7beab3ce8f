// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::park_test {
namespace {

bytes::Source sample_source(std::size_t index) {
    return bytes::memory_source("a.tiff", park_samples().at(index).content);
}

/// A sample with a number of its header replaced; offsets are those of the header's layout.
template <class T>
bytes::Source with_field(std::size_t offset, T value) {
    auto content = park_samples().at(1).content;
    const auto header = content.find(std::string("\0\0\0\0Z\0 \0H\0", 10));
    content.replace(header + offset, sizeof(T), reinterpret_cast<const char*>(&value), sizeof(T));
    return bytes::memory_source("a.tiff", content);
}

std::string message(const bytes::Source& source) {
    return message_of([&] { (void)formats::open(source, {}).at(0).read(); });
}

TEST(Park, NegativeGainIsKept) {
    const auto map = std::get<topography::HeightMap>(formats::open(sample_source(0), {}).at(0).read());
    EXPECT_DOUBLE_EQ(map.heights(0, 0), -2.5 * (0.5 * 3.0 + 12.0) * units::nm);
}

TEST(Park, ReadsModeCantileverAndDirections) {
    const auto info = formats::open(sample_source(3), {}).at(0).info;
    EXPECT_EQ(info.name, "Z Height");
    EXPECT_EQ(info.unit, "nm");
    EXPECT_EQ(info.metadata.attributes.at("mode"), "NCM");
    EXPECT_EQ(info.metadata.attributes.at("cantilever"), "AC160TS");
    EXPECT_EQ(info.metadata.attributes.at("scan_angle"), "45 deg");
    EXPECT_EQ(info.metadata.attributes.at("line_direction"), "forward");
    EXPECT_EQ(info.metadata.attributes.at("scan_direction"), "down");
    EXPECT_EQ(info.metadata.attributes.at("header_version"), "2");
}

TEST(Park, ScaleOfZeroCountsAsOne) {
    const auto map = std::get<topography::HeightMap>(formats::open(with_field(228, 0.0), {}).at(0).read());
    EXPECT_DOUBLE_EQ(map.heights(0, 0), -2.5 * (3.0 + 12.0) * units::nm);
}

TEST(Park, MissingUnitIsAssumedWithAWarning) {
    const auto channel = formats::open(with_field(244, std::uint32_t{0}), {}).at(0);
    EXPECT_EQ(channel.info.unit, "µm");
    EXPECT_EQ(channel.info.alerts.at(0).code, "UNIT_ASSUMED");
}

TEST(Park, ChannelInVoltsIsListedWithItsUnit) {
    const auto channel = formats::open(with_field(244, std::uint32_t{'V'}), {}).at(0);
    EXPECT_FALSE(channel.info.is_height);
    EXPECT_EQ(channel.info.unit, "V");
}

TEST(Park, UnsupportedContentIsNamed) {
    EXPECT_NE(message(with_field(0, std::uint32_t{1})).find("line profile"), std::string::npos);
    EXPECT_NE(message(with_field(272, std::uint32_t{1})).find("compressed"), std::string::npos);
    EXPECT_NE(message(with_field(348, std::uint32_t{7})).find("type 7"), std::string::npos);
    EXPECT_NE(message(with_field(100, std::uint32_t{8})).find("8 × 4 points"), std::string::npos);
    EXPECT_NE(message(with_field(100, std::uint32_t{0x80000001})).find("Park: 56 bytes"), std::string::npos);
}

TEST(Park, SizesAreInMicrometresPerAxis) {
    const auto info = formats::open(sample_source(2), {}).at(0).info;
    EXPECT_DOUBLE_EQ(info.size.at(0), 0.7 * units::um);
    EXPECT_DOUBLE_EQ(info.size.at(1), 0.4 * units::um);
}

}  // namespace
}  // namespace setae::formats::tests::park_test
