// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "patched_sample.hpp"
#include "setae/formats/format.hpp"
#include "tiff_builder.hpp"

using namespace setae::tests;

namespace setae::formats::tests::jpk_test {
namespace {

Channel first_channel(const FormatSample& sample) {
    return formats::open(bytes::memory_source("a.jpk", sample.content), {}).at(0);
}

TEST(Jpk, NamesContainTheDirectionOfTheScan) {
    EXPECT_EQ(first_channel(jpk_samples().at(0)).info.name, "Height (measured, retrace)");
    EXPECT_EQ(first_channel(jpk_samples().at(1)).info.name, "Height (trace)");
    EXPECT_EQ(first_channel(jpk_samples().at(1)).info.metadata.attributes.at("line_direction"), "trace");
}

TEST(Jpk, CalibratedSlotOverridesTheDefaultSlot) {
    const auto info = first_channel(jpk_samples().at(0)).info;
    EXPECT_EQ(info.metadata.attributes.at("slot"), "calibrated");
    EXPECT_EQ(info.metadata.attributes.at("slots"), "volts [V], nominal [m], calibrated [m]");
}

TEST(Jpk, DefaultSlotIsReadWhereNoneIsCalibrated) {
    const auto sample = jpk_samples().at(0);
    const auto channel =
        formats::open(bytes::memory_source("a.jpk", replaced(sample.content, "calibrated", "calibratex")), {}).at(0);
    EXPECT_EQ(channel.info.metadata.attributes.at("slot"), "nominal");
    const auto map = std::get<topography::HeightMap>(channel.read());
    EXPECT_NEAR(map.heights(0, 0), 2.0 * (sample.heights(0, 0) - 3e-6) + 3e-6, 1e-18);
}

TEST(Jpk, OffsetOfTheSlotIsAdded) {
    const auto map = std::get<topography::HeightMap>(first_channel(jpk_samples().at(0)).read());
    EXPECT_NEAR(map.heights(0, 0), -2e-12 * -700.0 + 3e-6, 1e-18);
}

TEST(Jpk, AmplitudeInMetresIsNotAHeight) {
    const auto content =
        replaced(jpk_samples().at(1).content, std::string("\0Height\0", 8), std::string("\0Error Q", 8));
    EXPECT_FALSE(formats::open(bytes::memory_source("a.jpk", content), {}).at(0).info.is_height);
}

TEST(Jpk, ImagesOfForceCurvesNameTheComputedQuantity) {
    const auto info = first_channel(jpk_qi_samples().at(0)).info;
    EXPECT_EQ(info.name, "Height (measured, trace): Ref. Force Height at 40%");
    EXPECT_EQ(info.format, "jpk-qi");
    EXPECT_EQ(info.metadata.instrument.name, "JPK Nanowizard 3");
}

TEST(Jpk, DateIsReadFromTheFile) {
    EXPECT_EQ(first_channel(jpk_samples().at(0)).info.metadata.acquisition_time, "2017-01-16 16:00:32.334 GMT");
}

TEST(Tiff, PlainPictureIsRefusedWithTheCommandToUse) {
    TiffPageBuilder page(std::endian::little);
    page.picture(2, 2, 8, 1).strips(2, {std::string(4, 'x')});
    const auto content = tiff_file(std::endian::little, {page});
    const auto error = message_of([&] { (void)formats::open(bytes::memory_source("a.tif", content), {}); });
    EXPECT_NE(error.find("at byte 0"), std::string::npos) << error;
    EXPECT_NE(error.find("setae contour"), std::string::npos) << error;
    const auto cut = message_of([&] { (void)formats::open(bytes::memory_source("a.tif", content.substr(0, 40)), {}); });
    EXPECT_NE(cut.find("at byte 40: TIFF: the file ends here"), std::string::npos) << cut;
}

TEST(Tiff, DirectoriesThatFormALoopAreRefused) {
    auto content = jpk_samples().at(0).content;
    content.replace(content.size() - 4, 4, content.substr(4, 4));
    const auto error = message_of([&] { (void)formats::open(bytes::memory_source("a.jpk", content), {}); });
    EXPECT_NE(error.find("loop"), std::string::npos) << error;
}

TEST(Tiff, RefusesFewBytesThatAnnounceManyPixels) {
    TiffPageBuilder page(std::endian::big), first(std::endian::big);
    first.picture(2, 2, 8, 1)
        .strips(2, {std::string(4, 'x')})
        .real(0x8042, 1e-6)
        .real(0x8043, 1e-6)
        .text(0x8050, "thumbnail");
    page.picture(1 << 20, 1 << 10, 32, 2, 8)
        .strips(1 << 10, {std::string(64, 'x')})
        .text(0x8050, "height")
        .signed_long(0x8080, 0);
    const auto error = message_of([&] {
        (void)formats::open(bytes::memory_source("a.jpk", tiff_file(std::endian::big, {first, page})), {});
    });
    EXPECT_NE(error.find("announce 1048576 × 1024 pixels"), std::string::npos) << error;
}

TEST(Tiff, DamagedCompressionIsRefusedWithItsStrip) {
    auto sample = jpk_samples().at(2);
    const auto strip = sample.content.find("\x78\x9c");
    sample.content.replace(strip, 8, "xxxxxxxx");
    const auto error = message_of([&] { (void)first_channel(sample).read(); });
    EXPECT_NE(error.find("at byte " + std::to_string(strip) + ": JPK: pixels cannot be expanded"), std::string::npos)
        << error;
}

}  // namespace
}  // namespace setae::formats::tests::jpk_test
