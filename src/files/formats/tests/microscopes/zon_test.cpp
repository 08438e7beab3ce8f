// SPDX-License-Identifier: GPL-3.0-or-later
#include "zon_samples.hpp"

#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::zon_test {
namespace {

const Array2D raw = lopsided_heights(5, 4, 10.0);
constexpr const char* heights_member = "4cdb0c75-5706-48cc-a9a1-adf395d609ae";

std::vector<Channel> opened(const std::string& content) { return open(bytes::memory_source("a.zon", content), {}); }
Array2D heights_of(const std::string& content) {
    return std::get<topography::HeightMap>(opened(content).at(0).read()).heights;
}
std::string refusal(const std::string& content) {
    return message_of([&] { (void)opened(content).at(0).read(); });
}

TEST(Zon, PointsWithoutMeasurementAreUndefined) {
    ZonFile file{.raw = raw, .validity = Array2D::Zero(5, 4)};
    file.validity(1, 1) = 1.0;   // out of range
    file.validity(2, 1) = 2.0;   // not to be measured
    file.validity(3, 1) = 0xc0;  // rated, but measured
    const auto heights = heights_of(zon_file(file));
    EXPECT_TRUE(std::isnan(heights(1, 1)));
    EXPECT_TRUE(std::isnan(heights(2, 1)));
    EXPECT_DOUBLE_EQ(heights(3, 1), raw(3, 1) * 10.0 * units::nm);
    EXPECT_EQ(heights.isNaN().count(), 2);
}

TEST(Zon, CompressedMembersHaveTheHeightsOfPlainOnes) {
    EXPECT_TRUE((heights_of(zon_file({.raw = raw, .packed = true})) == heights_of(zon_file({.raw = raw}))).all());
}

TEST(Zon, ReadsInstrumentTimeAndOtherImages) {
    const auto channels = opened(zon_file({.raw = raw, .colour = true}));
    ASSERT_EQ(channels.size(), 2u);
    const auto& metadata = channels[0].info.metadata;
    EXPECT_EQ(metadata.instrument.name, "VR-6200");
    EXPECT_EQ(metadata.attributes.at("serial"), "1A2");
    EXPECT_EQ(metadata.acquisition_time, "2023-05-17T08:12:05.1234567+02:00");
    EXPECT_EQ(metadata.file, "a.zon");
    EXPECT_EQ(channels[0].info.unit, "m");
    EXPECT_FALSE(channels[1].info.is_height);
}

TEST(Zon, DeviceAndTimeMayBeMissing) {
    auto members = zon_members({.raw = raw});
    members.erase(members.begin() + 1, members.begin() + 3);
    EXPECT_EQ(opened(keyence_package(members, false))[0].info.metadata.acquisition_time, "");
}

TEST(Zon, InconsistentSizesAreRefused) {
    const auto with = [](std::size_t offset, std::uint32_t number, bool packed) {
        auto members = zon_members({.raw = raw});
        for (auto& [name, content] : members)
            if (name == heights_member) content = ByteBuilder().text(content).number_at(offset, number).content();
        return refusal(keyence_package(members, packed));
    };
    EXPECT_NE(with(0, 0, false).find("0 × 4 points"), std::string::npos);
    EXPECT_NE(with(8, 3, false).find("points of 3 bytes"), std::string::npos);
    EXPECT_NE(with(12, 8, false).find("in rows of 8"), std::string::npos);
    EXPECT_NE(with(4, 4000, false).find("truncated or damaged"), std::string::npos);
    EXPECT_NE(with(4, 4000, true).find("the header states"), std::string::npos);
    EXPECT_NE(with(4, 0x7fffffff, true).find("announced in"), std::string::npos);
    ZonFile other{.raw = raw, .validity = Array2D::Zero(4, 5)};
    EXPECT_NE(refusal(zon_file(other)).find("4 × 5 points of validity for 5 × 4 heights"), std::string::npos);
    auto uncalibrated = zon_members({.raw = raw});
    uncalibrated[0].second = "<Calibration/>";
    EXPECT_NE(refusal(keyence_package(uncalibrated, false)).find("without a positive XYCalibration/MeterPerPixel"),
              std::string::npos);
}

TEST(Zag, IsDistinguishedFromZon) {
    const auto source = bytes::memory_source("a.zag", zag_file({{"one.zon", zon_file({.raw = raw})}}));
    EXPECT_EQ(detect_format(source).identifier, "zag");
    EXPECT_EQ(detect_format(bytes::memory_source("a.zon", zon_file({.raw = raw}))).identifier, "zon");
}

TEST(Zag, EveryMeasurementIsAChannelNamedByItsFile) {
    const auto channels =
        opened(zag_file({{"one.zon", zon_file({.raw = raw})}, {"hidden.zon", zon_file({.raw = raw + 5.0})}}));
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.name, "one.zon");
    EXPECT_EQ(channels[0].info.format, "zag");
    EXPECT_TRUE(channels[0].info.alerts.empty());
    EXPECT_EQ(channels[1].info.alerts.at(0).code, "HIDDEN_MEASUREMENT");
    EXPECT_EQ(topography::metadata(channels[0].read()).name, "one.zon");
    EXPECT_EQ(topography::metadata(channels[0].read()).format, "zag");
    EXPECT_NEAR(topography::all_heights(channels[1].read())[0] - topography::all_heights(channels[0].read())[0],
                50 * units::nm, 1e-18);
}

TEST(Zag, OneDamagedMeasurementDoesNotAffectOthers) {
    const auto channels = opened(zag_file({{"bad.zon", "KPK0 nothing"}, {"good.zon", zon_file({.raw = raw})}}));
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.alerts.at(0).code, "UNREADABLE_MEMBER");
    EXPECT_THROW((void)channels[0].read(), FormatError);
    EXPECT_EQ(topography::all_heights(channels[1].read()).size(), 20);
}

}  // namespace
}  // namespace setae::formats::tests::zon_test
