// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "patched_sample.hpp"

using namespace setae::tests;

namespace setae::formats::tests::opd_test {
namespace {

struct Block {
    std::string name;
    int type;
    std::string content;
    std::int32_t announced = -1;  ///< bytes in the directory; negative: as many as there are
};

std::string opd_file(const std::vector<Block>& blocks) {
    ByteBuilder file;
    const auto entry = [&](const std::string& name, int type, std::int32_t length) {
        file.text(name, 16).number(static_cast<std::uint16_t>(type)).number(length).number<std::uint16_t>(8);
    };
    file.number<std::uint16_t>(1);
    entry("Directory", 1, static_cast<std::int32_t>(24 * (blocks.size() + 1)));
    for (const auto& block : blocks)
        entry(block.name, block.type,
              block.announced < 0 ? static_cast<std::int32_t>(block.content.size()) : block.announced);
    for (const auto& block : blocks) file.text(block.content);
    return file.content();
}

template <class T>
Block number(const std::string& name, int type, T value) {
    return {name, type, ByteBuilder().number(value).content()};
}

/// 2 × 3 times the same value of 2 bytes.
Block array(const std::string& name, std::int16_t value) {
    ByteBuilder bytes;
    bytes.number<std::uint16_t>(2).number<std::uint16_t>(3).number<std::uint16_t>(2);
    for (int i = 0; i < 6; ++i) bytes.number(value);
    return {name, 3, bytes.content()};
}

const Block wavelength = number("Wavelength", 7, 500.0f), pixel_size = number("Pixel_size", 7, 0.5f);

TEST(Opd, HeightScaleIsWavelengthOverMultiplier) {
    const auto channels =
        channels_of(opd_file({wavelength, pixel_size, number<std::uint16_t>("Mult", 6, 1000), array("RAW_DATA", 8)}));
    EXPECT_DOUBLE_EQ(map_of(channels.at(0)).heights(1, 1), 4e-9);
    EXPECT_DOUBLE_EQ(map_of(channels_of(opd_file({wavelength, pixel_size, array("RAW_DATA", 8)})).at(0)).heights(1, 1),
                     4e-6);
}

TEST(Opd, ReadsTheTimeOfMeasurement) {
    const auto metadata = channels_of(opd_samples().at(1).content).at(0).info.metadata;
    EXPECT_EQ(metadata.acquisition_time, "7/7/2015 16:19:48");
    EXPECT_EQ(metadata.instrument.type, "interferometer");
    EXPECT_EQ(metadata.attributes.at("measurement_mode"), "PSI") << "an entry of Vision64's tree within a block";
}

TEST(Opd, IntensityIsListedButNotAHeight) {
    const auto channels = channels_of(opd_samples().at(2).content);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[1].info.name, "Image");
    EXPECT_FALSE(channels[1].info.is_height);
}

TEST(Opd, PrimaryArrayContainsHeights) {
    const Block primary{"PrimaryData2D", 15, std::string("\x12\x01\x06") + "Filled"};
    EXPECT_FALSE(channels_of(opd_file({wavelength, pixel_size, array("Filled", 8)})).at(0).info.is_height);
    EXPECT_TRUE(channels_of(opd_file({wavelength, pixel_size, primary, array("Filled", 8)})).at(0).info.is_height);
}

TEST(Opd, WrongBlockLengthOfVisionDoesNotShiftOtherBlocks) {
    const auto modification = Block{"ImageModificat~0", 7, std::string(4, 'm'), 40};
    EXPECT_DOUBLE_EQ(
        map_of(channels_of(opd_file({modification, wavelength, pixel_size, array("OPD", 8)})).at(0)).heights(0, 0),
        4e-6);
}

TEST(Opd, WithoutPixelSizeTheSizeIsMissing) {
    const auto file = opd_file({wavelength, array("OPD", 8)});
    EXPECT_EQ(missing(channels_of(file).at(0).info).at(0), "size");
    EXPECT_NE(refusal(file).find("give `size`"), std::string::npos) << refusal(file);
    EXPECT_DOUBLE_EQ(map_of(channels_of(file, {.size = {{2e-6, 3e-6}}, .unit = {}}).at(0)).size[1], 3e-6);
}

TEST(Opd, HeightsWithoutScaleAreRefused) {
    EXPECT_NE(refusal(opd_file({pixel_size, array("OPD", 8)})).find("'Wavelength'"), std::string::npos);
    EXPECT_NE(refusal(opd_file({wavelength, pixel_size, number<std::uint16_t>("Mult", 6, 0), array("OPD", 8)}))
                  .find("above 0, 'Mult'"),
              std::string::npos);
}

TEST(Opd, ArrayBeyondItsBlockIsRefused) {
    auto lying = array("OPD", 8);
    lying.content = with_number<std::uint16_t>(lying.content, 0, 3);
    EXPECT_NE(refusal(opd_file({wavelength, pixel_size, lying, array("Image", 1)}))
                  .find("announces 3 × 3 values of 2 bytes in a block of 18 bytes"),
              std::string::npos);
}

TEST(Opd, DirectoryOfOddLengthIsRefused) {
    EXPECT_NE(refusal(with_number<std::int32_t>(opd_file({wavelength}), 20, 49)).find("a directory of 49 bytes"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::opd_test
