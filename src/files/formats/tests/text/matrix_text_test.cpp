// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::matrix_text_test {
namespace {

using topography::HeightMap;
using topography::LineScan;

std::vector<Channel> channels_of(const std::string& text, const ReadOptions& options = {}) {
    return open(bytes::memory_source("m.txt", text), options);
}

HeightMap map_of(const std::string& text, const ReadOptions& options = {}, std::size_t channel = 0) {
    return std::get<HeightMap>(channels_of(text, options).at(channel).read());
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
    return message_of([&] {
        for (const auto& channel : channels_of(text, options)) (void)channel.read();
    });
}

const ReadOptions given{{{4e-6, 2e-6}}, "nm"};

TEST(MatrixText, OpeningDoesNotReadHeights) {
    const auto channel = channels_of("1 2 3 4\n5 wrong 7 8\n9 10 11 12\n", given).at(0);
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{4, 3}));
    EXPECT_THROW((void)channel.read(), FormatError);
}

TEST(MatrixText, MissingSizeAndUnitAreListedAndRefusedOnReading) {
    const auto channel = channels_of("1 2 3 4\n5 6 7 8\n").at(0);
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{4, 2}));
    EXPECT_EQ(missing(channel.info), (std::vector<std::string>{"size", "unit", "instrument", "date"}));
    EXPECT_THROW((void)channel.read(), InvalidArgument);
    EXPECT_NE(refusal("1 2 3 4\n5 6 7 8\n").find("neither size nor unit"), std::string::npos);
    EXPECT_NE(refusal("# Width: 4 um\n# Height: 2 um\n1 2 3 4\n5 6 7 8\n").find("no unit"), std::string::npos);
    EXPECT_NE(refusal("# Value units: nm\n1 2 3 4\n5 6 7 8\n").find("no size"), std::string::npos);
}

TEST(MatrixText, XPixelsIsTheLengthOfALine) {  // the other reader swaps nx and ny
    const auto map = map_of(
        "# File Format = ASCII\n# x-pixels = 4\n# y-pixels = 2\n# x-length = 400\n# y-length = 100\n# z-unit = nm\n# Start of Data:\n1 2 3 4\n5 6 7 8\n");
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{4, 2}));
    EXPECT_NEAR(map.size[0], 400e-9, 1e-20);
    EXPECT_NEAR(map.size[1], 100e-9, 1e-20);
    EXPECT_NEAR(map.heights(3, 0), 4e-9, 1e-22);
}

TEST(MatrixText, MapsOfTwoColumnsOrRowsAreMaps) {  // the other reader refuses them
    const std::string header = "# Width: 2 um\n# Height: 3 um\n# Value units: nm\n";
    EXPECT_EQ(map_of(header + "1 2\n3 4\n5 6\n").shape(), (std::array<Index, 2>{2, 3}));
    EXPECT_EQ(map_of(header + "1 2 3\n4 5 6\n").shape(), (std::array<Index, 2>{3, 2}));
    EXPECT_EQ(map_of("1 2 3 4\n5 6 7 8\n", given).shape(), (std::array<Index, 2>{4, 2}));
    auto matrix = given;
    matrix.layout = TextLayout::matrix;
    EXPECT_EQ(map_of("1 2\n3 4\n5 6\n", matrix).shape(), (std::array<Index, 2>{2, 3}));
}

TEST(MatrixText, ReadsDecimalCommasOfGermanGwyddion) {
    const auto map =
        map_of("# Kanal: Z\n# Breite: 12,34 µm\n# Höhe: 5678,9 nm\n# Value units: m\n1,5e-9\t2,5e-9\n-3e-9\t4e-9\n");
    EXPECT_DOUBLE_EQ(map.size[0], 12.34e-6);
    EXPECT_DOUBLE_EQ(map.size[1], 5678.9e-9);
    EXPECT_DOUBLE_EQ(map.heights(0, 0), 1.5e-9);
    EXPECT_DOUBLE_EQ(map.heights(0, 1), -3e-9);
}

TEST(MatrixText, ReadsWordsForUndefinedHeights) {
    const auto map = map_of("bad nan inf ***\n1 -inf Bad NaN\n1.#QNAN -1.#IND infinite 8\n", {{{4e-6, 3e-6}}, "nm"});
    EXPECT_EQ(map.heights.isNaN().count(), 10);
    EXPECT_DOUBLE_EQ(map.heights(0, 1), 1e-9);
    EXPECT_DOUBLE_EQ(map.heights(3, 2), 8e-9);
}

TEST(MatrixText, LinesMayHaveTrailingSeparatorsAndBlankLinesBetween) {
    const auto map = map_of("1\t2\t3\t4\t\n\n# remark\n5\t6\t7\t8\t\n   \n", given);
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{4, 2}));
    EXPECT_DOUBLE_EQ(map.heights(3, 1), 8e-9);
}

TEST(MatrixText, WykoHeightsAreMultiplesOfTheWavelengthOrNanometres) {
    const auto text = [](const char* flags, const char* block) {
        return std::string("Wyko ASCII Data File Format ") + flags +
               "\nX Size\t4\nY Size\t2\nBlock Name\tType\tLength\tValue\nWavelength\t7\t4\t632.8\nMult\t6\t2\t2\nPixel_size\t7\t4\t0.002\n" +
               block + "\t3\t48\t\n1\t2\n3\tBad\n5\t6\n7\t8\n";
    };
    const auto map = map_of(text("0\t0\t1", "RAW_DATA"));
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{4, 2}));
    EXPECT_NEAR(map.size[0], 8e-6, 1e-18);
    EXPECT_NEAR(map.heights(0, 1), 316.4e-9, 1e-18) << "a line begins at the bottom";
    EXPECT_NEAR(map.heights(3, 0), 8 * 316.4e-9, 1e-18);
    EXPECT_TRUE(std::isnan(map.heights(1, 0)));
    EXPECT_NEAR(map_of(text("0\t1\t1", "OPD")).heights(0, 1), 1e-9, 1e-20);
    EXPECT_FALSE(channels_of(text("0\t0\t1", "Intensity")).at(0).info.is_height);
}

TEST(MatrixText, BlocksOfWykoFilesAreChannels) {
    const auto channels = channels_of(
        "Wyko ASCII Data File Format 0\t0\t1\nX Size\t4\nY Size\t2\nWavelength\t7\t4\t600\nPixel_size\t7\t4\t0.001\nRAW_DATA\t3\t48\t\n1\t2\n3\t4\n5\t6\n7\t8\n"
        "Intensity\t3\t48\t\n9\t9\n9\t9\n9\t9\n9\t9\n");
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[1].info.name, "Intensity");
    EXPECT_TRUE(channels[0].info.is_height);
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_NEAR(std::get<HeightMap>(channels[0].read()).heights(3, 0), 8 * 600e-9, 1e-18);
}

TEST(MatrixText, ChannelsOfOtherQuantitiesAreListedOnly) {
    const auto channels = channels_of(
        "# Channel: Phase\n# Width: 4 um\n# Height: 2 um\n# Value units: deg\n1 2 3 4\n5 6 7 8\n"
        "# Channel: Height\n# Width: 2 um\n# Height: 2 um\n# Value units: nm\n1 2\n3 4\n");
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_FALSE(channels[0].info.is_height);
    EXPECT_EQ(channels[0].info.unit, "deg");
    EXPECT_THROW((void)channels[0].read(), InvalidArgument);
    EXPECT_EQ(channels[1].info.name, "Height");
    EXPECT_DOUBLE_EQ(std::get<HeightMap>(channels[1].read()).heights(0, 1), 3e-9);
}

TEST(MatrixText, HeightsUseTheConversionOfTheHeader) {
    const auto map = map_of(
        "h=2 w=3\npixel size=3.69862e-007 m\ndata unit=rad\nheight conversion factor (-> m)=2.91818e-008\n1 2 3\n4 5 6\n");
    EXPECT_DOUBLE_EQ(map.heights(2, 1), 6 * 2.91818e-8);
    EXPECT_DOUBLE_EQ(map.size[0], 3 * 3.69862e-7);
    EXPECT_EQ(map.metadata.attributes.at("data unit"), "rad");
}

TEST(MatrixText, FewerLinesThanAnnouncedAreRefusedOnOpening) {
    EXPECT_THROW((void)channels_of("h=3 w=4\n1 2 3 4\n5 6 7 8\n"), FormatError);
    EXPECT_NE(
        refusal("h=3 w=4\npixel size=1 um\n1 2 3 4\n5 6 7 8\n").find("4 × 2 numbers, but its header announces 4 × 3"),
        std::string::npos);
    EXPECT_NE(refusal("1 2 3 4\n5 6 7 8\n9 10", given).find("m.txt:3: 2 columns, expected 4"), std::string::npos);
    EXPECT_THROW((void)channels_of("1 2 3 4\n5 6 7 8\n9 10", given), FormatError);
}

TEST(MatrixText, InvalidNumbersAreNamedByLine) {
    EXPECT_NE(refusal("# Width: 4 um\n# Height: 3 um\n# Value units: nm\n1 2 3 4\n5 6 x7 8\n9 1 2 3\n")
                  .find("m.txt:5: 'x7' in column 3"),
              std::string::npos);
    EXPECT_NE(refusal("# Width: 4 kg\n# Height: 3 um\n1 2 3 4\n").find("header of a text matrix"), std::string::npos);
    EXPECT_NE(refusal("# Width: -4 um\n# Height: 3 um\n1 2 3 4\n").find("positive length"), std::string::npos);
}

TEST(MatrixText, OneRowOrColumnIsALineScan) {
    const ReadOptions line{{{9e-6}}, "um"};
    const auto column = std::get<LineScan>(channels_of("1\n2\n3\n4\n", line).at(0).read());
    EXPECT_EQ(column.heights.size(), 4);
    EXPECT_DOUBLE_EQ(column.heights[3], 4e-6);
    EXPECT_DOUBLE_EQ(column.size, 9e-6);
    EXPECT_EQ(std::get<LineScan>(channels_of("1 2 3 4\n", line).at(0).read()).heights.size(), 4);
}

TEST(MatrixText, TablesWithNamesAreNotMaps) {
    const auto* loop = "force [mN];displacement [um];time [s];remark\n1;2;3;4\n2;3;4;5\n";
    EXPECT_NE(refusal(loop).find("`setae jkr fit`"), std::string::npos);
    EXPECT_EQ(channels_of(loop, given).at(0).info.shape, (std::vector<Index>{4, 2}))
        << "who gives a size says it is a map";
}

TEST(MatrixText, UnitOfTheFileOverridesTheGivenOneWithAWarning) {
    const auto channel =
        channels_of("# Width: 4 um\n# Height: 2 um\n# Value units: nm\n1 2 3 4\n5 6 7 8\n", {{}, "um"}).at(0);
    EXPECT_EQ(channel.info.alerts.at(0).code, "UNIT_MISMATCH");
    EXPECT_DOUBLE_EQ(std::get<HeightMap>(channel.read()).heights(3, 1), 8e-9);
}

TEST(MatrixText, LongLinesAreReadCompletely) {
    std::string text;
    for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 40000; ++i) text += fmt::format("{}{}", 10 * j + i % 7, i < 39999 ? ' ' : '\n');
    const auto map = map_of(text, {{{40e-3, 3e-6}}, "nm"});
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{40000, 3}));
    EXPECT_DOUBLE_EQ(map.heights(39999, 2), (20 + 39999 % 7) * 1e-9);
}

}  // namespace
}  // namespace setae::formats::tests::matrix_text_test
