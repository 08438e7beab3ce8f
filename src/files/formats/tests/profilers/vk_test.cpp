// SPDX-License-Identifier: GPL-3.0-or-later
#include "vk_samples.hpp"

#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::vk_test {
namespace {

const Array2D raw = lopsided_heights(5, 4, 1.0);

std::vector<Channel> opened(const std::string& content) { return open(bytes::memory_source("a.vk", content), {}); }
std::string refusal(const std::string& content) {
    return message_of([&] { (void)opened(content); });
}

TEST(Vk, SizeIsPointsTimesPitch) {
    const auto info = opened(vk4_file({.heights = {raw}}))[0].info;
    EXPECT_DOUBLE_EQ(info.size.at(0), 5 * 500 * units::nm);
    EXPECT_DOUBLE_EQ(info.size.at(1), 4 * 250 * units::nm);
    EXPECT_EQ(info.unit, "pm");
}

TEST(Vk, TimeKeepsItsUtcOffset) {
    const auto time = [](int minutes) {
        return opened(vk4_file({.heights = {raw}, .minutes_ahead_of_utc = minutes}))[0].info.metadata.acquisition_time;
    };
    EXPECT_EQ(time(540), "2014-09-29T10:58:26+09:00");
    EXPECT_EQ(time(-210), "2014-09-29T10:58:26-03:30");
    EXPECT_EQ(time(0), "2014-09-29T10:58:26+00:00");
}

TEST(Vk, ReadsHeightImagesAndListsLightImages) {
    const auto channels = opened(vk4_file({.heights = {raw, raw + 1.0}, .light = true}));
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[0].info.name, "Height");
    EXPECT_EQ(channels[1].info.name, "Height 2");
    EXPECT_EQ(channels[2].info.name, "Light");
    EXPECT_FALSE(channels[2].info.is_height);
}

TEST(Vk, ReadsLensAndTitle) {
    const auto metadata = opened(vk6_file({.heights = {raw}}))[0].info.metadata;
    EXPECT_EQ(metadata.attributes.at("title"), "wafer 3");
    EXPECT_EQ(metadata.attributes.at("lens"), "Plan 50x");
    EXPECT_EQ(metadata.attributes.at("lens_magnification"), "50");
    EXPECT_EQ(metadata.attributes.at("numerical_aperture"), "0.95");
    EXPECT_EQ(metadata.instrument.type, "confocal");
    EXPECT_EQ(metadata.file, "a.vk");
}

TEST(Vk, WrappedFileHasTheHeightsOfThePlainFile) {
    const auto plain = topography::all_heights(opened(vk4_file({.heights = {raw}}))[0].read());
    EXPECT_TRUE((topography::all_heights(opened(vk6_file({.heights = {raw}}))[0].read()) == plain).all());
    EXPECT_TRUE((topography::all_heights(opened(vk6_file({.heights = {raw}}, '7'))[0].read()) == plain).all());
}

TEST(Vk, ArchiveMayStartShortlyAfterThePicture) {
    auto content = vk6_file({.heights = {raw}});
    content.insert(7 + bmp_picture().size(), 100, '\0');
    EXPECT_EQ(opened(content).size(), 1u);
    content.insert(7 + bmp_picture().size(), 2000, '\0');
    EXPECT_NE(refusal(content).find("no ZIP archive follows the picture"), std::string::npos);
}

TEST(Vk, SizeOfZeroIsReportedMissing) {
    const auto content = ByteBuilder().text(vk4_file({.heights = {raw}})).number_at(84 + 4 * 42, 0u).content();
    const auto channel = opened(content)[0];
    EXPECT_TRUE(channel.info.size.empty());
    EXPECT_NE(message_of([&] { (void)channel.read(); }).find("`size`"), std::string::npos);
    const auto given = open(bytes::memory_source("a.vk", content), {.size = {{1e-6, 2e-6}}})[0];
    EXPECT_EQ(given.info.size, (std::vector<double>{1e-6, 2e-6}));
}

TEST(Vk, ImagesOfInconsistentSizeAreRefusedWithTheOffset) {
    const auto content = vk4_file({.heights = {raw}});
    constexpr std::size_t image = 84 + 304;
    const auto changed = [&](std::size_t offset, std::uint32_t number) {
        return refusal(ByteBuilder().text(content).number_at(offset, number).content());
    };
    EXPECT_EQ(changed(image + 8, 12), "a.vk: at byte 396: VK: 12 bits per point, expected 8, 16 or 32");
    EXPECT_NE(changed(image, 0x80000005u).find("points of 16 bits in 40 bytes"), std::string::npos);
    EXPECT_NE(changed(36, 0xfffffff0u).find("truncated"), std::string::npos);
    EXPECT_NE(changed(36, 0).find("no image of heights or light"), std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::vk_test
