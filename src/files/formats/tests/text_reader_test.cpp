// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::text_reader_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

LineScan line_from(std::string_view content, const ReadOptions& options = {}) {
    const TemporaryFolder folder;
    return std::get<LineScan>(read(folder.write("line.txt", content), 0, options));
}

std::string message_of(std::string_view content, const ReadOptions& options = {}) {
    const TemporaryFolder folder;
    try {
        (void)read(folder.write("file.txt", content), 0, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

const ReadOptions microns{{}, "um"};

TEST(XyText, EveryDialectGivesTheSameLine) {
    const char* dialects[] = {"0 0.5\n1 1.5\n2 -0.25\n",
                              "0.0\t0.5\n1.0\t1.5\n2.0\t-0.25\n",
                              "0.0,0.5\n1.0,1.5\n2.0,-0.25\n",
                              "  0.0,   5e-1\r\n  1.0,   1.5\r\n  2.0,  -0.25\r\n",
                              "0.0;0.5\n1.0;1.5\n2.0;-0.25\n",
                              "0,0;0,5\n1,0;1,5\n2,0;-0,25\n",
                              "0,0\t0,5\n1,0\t1,5\n2,0\t-0,25\n",
                              "0,0  0,5\n1,0  1,5\n2,0  -0,25\n",
                              "\xef\xbb\xbf# remark\n0 .5\n1 +1.5\n\n2 -.25\n\n",
                              "0 0.5\r1 1.5\r2 -0.25\r"};
    for (const auto* text : dialects) {
        const auto scan = line_from(text, microns);
        ASSERT_EQ(scan.heights.size(), 3) << text;
        EXPECT_DOUBLE_EQ(scan.heights[0], 0.5e-6) << text;
        EXPECT_DOUBLE_EQ(scan.heights[1], 1.5e-6) << text;
        EXPECT_DOUBLE_EQ(scan.heights[2], -0.25e-6) << text;
        EXPECT_DOUBLE_EQ(scan.size, 3e-6) << text;
    }
}

TEST(XyText, UnitsOfTheHeaderAreApplied) {
    const char* headers[] = {"x [um];h [nm]\n",     "x (um);h (nm)\n",   "x in um;h in nm\n", "x / um;h / nm\n",
                             "x;h\n[um];[nm]\n",    "x;h\num;nm\n",      "um;nm\n",           "x_(microns);h [nm]\n",
                             "Lateral um;Raw nm\n", "x [\xb5m];h [nm]\n"};
    for (const auto* header : headers) {
        const auto scan = line_from(std::string(header) + "0;1\n1;2\n2;4\n");
        EXPECT_DOUBLE_EQ(scan.size, 3e-6) << header;
        EXPECT_DOUBLE_EQ(scan.heights[2], 4e-9) << header;
        EXPECT_EQ(scan.metadata.unit, "nm") << header;
    }
}

TEST(XyText, ReadsUtf16) {
    const std::u16string text = u"\ufeffindex,x in \u00b5m,y in \u00b5m\r\n0,-2.0,1\r\n1,-1.5,2\r\n2,-1.0,3\r\n";
    const std::string little(reinterpret_cast<const char*>(text.data()), 2 * text.size());
    std::string big = little;
    for (std::size_t i = 0; i + 1 < big.size(); i += 2) std::swap(big[i], big[i + 1]);
    for (const auto& bytes : {little, big}) {
        const auto scan = line_from(bytes);
        EXPECT_DOUBLE_EQ(scan.size, 1.5e-6);
        EXPECT_DOUBLE_EQ(scan.heights[2], 3e-6);
    }
}

TEST(XyText, ErrorForAMissingUnitNamesTheOption) {
    EXPECT_NE(message_of("0 1\n1 2\n2 3\n").find("`unit`"), std::string::npos);
}

TEST(XyText, WrongUnitIsRefused) {
    EXPECT_NE(message_of("t [s];h [nm]\n0;1\n1;2\n").find("unit 's'"), std::string::npos);
    EXPECT_NE(message_of("0 1\n1 2\n2 3\n", {{}, "kg"}).find("kg"), std::string::npos);
}

TEST(XyText, UnitOfOneColumnAppliesToBothWithAWarning) {
    const TemporaryFolder folder;
    const auto path = folder.write("a.csv", "x_(microns),y1\n0,1\n1,2\n2,3\n");
    const auto assumed = open(path);
    EXPECT_EQ(assumed.at(0).info.alerts.at(0).code, "UNIT_ASSUMED");
    EXPECT_DOUBLE_EQ(std::get<LineScan>(assumed[0].read()).heights[2], 3e-6);
    const auto given = open(path, {{}, "nm"});
    EXPECT_TRUE(given.at(0).info.alerts.empty());
    EXPECT_DOUBLE_EQ(std::get<LineScan>(given[0].read()).heights[2], 3e-9);
}

TEST(XyText, UnitOfTheFileOverridesTheGivenOneWithAWarning) {
    const TemporaryFolder folder;
    const auto channels = open(folder.write("a.csv", "x [um],h [um]\n0,1\n1,2\n2,3\n"), {{}, "nm"});
    EXPECT_EQ(channels.at(0).info.alerts.at(0).code, "UNIT_MISMATCH");
    EXPECT_DOUBLE_EQ(std::get<LineScan>(channels[0].read()).heights[2], 3e-6);
}

TEST(XyText, UnequalStepsGiveAProfile) {
    const TemporaryFolder folder;
    const auto profile = std::get<Profile>(read(folder.write("p.txt", "0 0\n2 1\n1.5 2\n4 3\n"), 0, microns));
    EXPECT_DOUBLE_EQ(profile.positions[2], 1.5e-6);
    EXPECT_DOUBLE_EQ(profile.heights[3], 3e-6);
}

TEST(XyText, DecreasingPositionsAreReversed) {
    const auto scan = line_from("2 5\n1 6\n0 7\n", microns);
    EXPECT_DOUBLE_EQ(scan.heights[0], 7e-6);
    EXPECT_DOUBLE_EQ(scan.size, 3e-6);
}

TEST(XyText, ValidityColumnMasksHeights) {
    const auto scan = line_from("X;Y;valid\n[mm];[mm];[1/0]\n0;1;1\n1;99;0\n2;3;1\n");
    EXPECT_TRUE(std::isnan(scan.heights[1]));
    EXPECT_DOUBLE_EQ(scan.heights[2], 3e-3);
}

TEST(XyText, EmptyInvalidAndInfiniteHeightsAreUndefined) {
    const auto scan = line_from("0,1\n1,\n2,nan\n3,bad\n4,inf\n5,1\n", microns);
    EXPECT_EQ(scan.heights.isNaN().count(), 4);
}

TEST(XyText, UnitsAfterNamesWithoutLettersAreApplied) {
    const auto scan = line_from("\"\" [um] \"h\" [nm]\n0 1\n1 2\n2 4\n");
    EXPECT_DOUBLE_EQ(scan.size, 3e-6);
    EXPECT_DOUBLE_EQ(scan.heights[2], 4e-9);
    EXPECT_EQ(message_of("x\r\"\"\r\"[aPx\"\r\"x.0050,4.\xc9\n.150 00\n").find("no error"), std::string::npos);
}

TEST(XyText, DektakHeaderGivesUnitsAndStylus) {
    const auto scan = line_from(
        "Scan Parameters\r\r\nScan Type,Standard Scan\r\nID,0\r\nStylus,Radius: 2.5 \xb5m\r\n\r\r\nScan Data\r\r\n"
        "Lateral um,Raw Micrometer,\r\n0.0,1.0,,\r\n0.5,2.0,,\r\n1.0,3.0,,\r\n\r\r\n");
    EXPECT_DOUBLE_EQ(scan.heights[2], 3e-6);
    EXPECT_DOUBLE_EQ(scan.metadata.instrument.tip_radius.value(), 2.5e-6);
    EXPECT_EQ(scan.metadata.instrument.type, "stylus");
}

TEST(XyText, RefusesOtherTextsWithAOneLineMessage) {
    EXPECT_NE(message_of("").find("empty"), std::string::npos);
    EXPECT_NE(message_of("x [um], h [um]\n").find("without a row of numbers"), std::string::npos);
    EXPECT_NE(message_of("1 2\n", microns).find("expected at least 2"), std::string::npos);
    EXPECT_NE(message_of("0 nan\n1 nan\n", microns).find("all 2 heights are undefined"), std::string::npos);
    EXPECT_NE(message_of("1\n2\n3\n", microns).find("`size`, such as \"1 mm\""), std::string::npos);
    EXPECT_NE(message_of("0 1\nnan 2\n2 3\n", microns).find("x of point 2"), std::string::npos);
}

TEST(XyText, InvalidRowIsNamedByLine) {
    EXPECT_NE(message_of("x [um] h [um]\n0 1\n1 2\n2 3\n3", {}).find("file.txt:5: 1 columns, expected 2"),
              std::string::npos);
    EXPECT_NE(message_of("0 1\n1 2\n2 oops\n3 4\n", microns).find("file.txt:3: 'oops' in column 2"), std::string::npos);
}

TEST(MatrixText, HeaderGivesSizeAndUnit) {
    const TemporaryFolder folder;
    const char* headers[] = {"# Channel: Z\n# Width: 3 um\n# Height: 2000 nm\n# Value units: nm\n",
                             "# Kanal: Z\n# Breite: 3,0 µm\n# Höhe: 2,0 µm\n# Value units: nm\n"};
    for (const auto* header : headers) {
        const auto map = std::get<HeightMap>(read(folder.write("m.txt", std::string(header) + "1 2 3\n4 5 nan\n")));
        EXPECT_DOUBLE_EQ(map.size[0], 3e-6);
        EXPECT_DOUBLE_EQ(map.size[1], 2e-6);
        EXPECT_DOUBLE_EQ(map.heights(1, 0), 2e-9);
        EXPECT_DOUBLE_EQ(map.heights(0, 1), 4e-9);
        EXPECT_TRUE(std::isnan(map.heights(2, 1)));
        EXPECT_EQ(map.metadata.name, "Z");
    }
}

TEST(MatrixText, WithoutHeaderRequiresSizeAndUnit) {
    const char* text = "1 2 3 4\n5 6 7 8\n";
    EXPECT_NE(message_of(text).find("`size`"), std::string::npos);
    const TemporaryFolder folder;
    const auto map = std::get<HeightMap>(read(folder.write("m.txt", text), 0, {{{4e-6, 2e-6}}, "nm"}));
    EXPECT_DOUBLE_EQ(map.heights(3, 1), 8e-9);
    EXPECT_DOUBLE_EQ(map.size[1], 2e-6);
}

TEST(Open, RefusesMissingFilesAndFolders) {
    const TemporaryFolder folder;
    EXPECT_THROW((void)open(folder.path("missing")), FileError);
    EXPECT_THROW((void)open(folder.path(".")), FileError);
    EXPECT_THROW((void)open(folder.write("b", std::string("\x00\x01\x02", 3))), FormatError);
    EXPECT_THROW((void)read(folder.write("c", "0 1\n1 2\n"), 1, microns), InvalidArgument);
}

/// KLA-Tencor's profilers export bare columns, x in mm and heights in µm.
TEST(TwoColumns, WithoutHeaderAcceptOneUnitPerColumn) {
    const std::string text = "0.0000\t0.5\n0.0010\t0.25\n0.0020\t1.5\n";
    const auto scan =
        std::get<topography::LineScan>(open(bytes::memory_source("kla.txt", text), {.unit = "mm, um"}).at(0).read());
    EXPECT_NEAR(scan.size, 3e-6, 1e-18);
    EXPECT_NEAR(scan.heights[2], 1.5e-6, 1e-18);
    const auto points =
        open(bytes::memory_source("xyz.txt", "0 0 1\n1 0 2\n0 1 3\n1 1 5\n0 2 1\n1 2 1\n"), {.unit = "um, nm"}).at(0);
    EXPECT_NEAR(points.info.size.at(1), 3e-6, 1e-18);
    EXPECT_NEAR(std::get<topography::HeightMap>(points.read()).heights(1, 1), 5e-9, 1e-20);
}

}  // namespace
}  // namespace setae::formats::tests::text_reader_test
