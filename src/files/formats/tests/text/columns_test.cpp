// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"
#include "setae/tables/text_numbers.hpp"

/// Points x, y, z and curves x, h in text.
using namespace setae::tests;

namespace setae::formats::tests::columns_test {
namespace {

using topography::HeightMap;
using topography::LineScan;
using topography::Profile;

const ReadOptions microns{{}, "um"};

ReadOptions taken_as(TextLayout layout) {
    auto options = microns;
    options.layout = layout;
    return options;
}

Channel channel_of(const std::string& text, const ReadOptions& options = microns) {
    return open(bytes::memory_source("c.txt", text), options).at(0);
}

HeightMap map_of(const std::string& text, const ReadOptions& options = microns) {
    return std::get<HeightMap>(channel_of(text, options).read());
}

std::string refusal(const std::string& text, const ReadOptions& options = microns) {
    return message_of([&] { (void)channel_of(text, options).read(); });
}

TEST(XyzText,
     GridNodesWithoutAPointAreUndefined) {  // the other reader refuses such a list and then reads it as a map of
                                            // three columns
    const auto map = map_of("0 0 1\n0 1 2\n1 0 3\n1 1 4\n2 0 5\n");
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{3, 2}));
    EXPECT_TRUE(std::isnan(map.heights(2, 1)));
    EXPECT_DOUBLE_EQ(map.heights(2, 0), 5e-6);
    EXPECT_DOUBLE_EQ(map.size[0], 3e-6);
    EXPECT_DOUBLE_EQ(map.size[1], 2e-6);
}

TEST(XyzText, NamedColumnsMayBeInAnyOrder) {
    const auto map = map_of("id,z [um],intensity,y [um],x [um]\n1,5,9,0,0\n2,6,9,0,1\n3,7,9,1,0\n4,8,9,1,1\n", {});
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{2, 2}));
    EXPECT_DOUBLE_EQ(map.heights(1, 0), 6e-6);
    EXPECT_DOUBLE_EQ(map.heights(0, 1), 7e-6);
}

TEST(CurveText, FindsPositionsByTheirName) {
    const auto heights = [](const std::string& text) {
        const auto line = std::get<LineScan>(channel_of(text, {}).read());
        EXPECT_DOUBLE_EQ(line.size, 4e-3) << text;
        return line.heights;
    };
    for (const char* text : {"z [um],x [mm]\n3,0\n5,1\n4,2\n6,3\n", "height (um),distance (mm)\n3,0\n5,1\n4,2\n6,3\n",
                             "Höhe/µm;Weg/mm\n3;0\n5;1\n4;2\n6;3\n", ",x [mm],z [um]\n0,0,3\n1,1,5\n2,2,4\n3,3,6\n",
                             "time [s],x [mm],height [um]\n0,0,3\n0.1,1,5\n0.2,2,4\n0.3,3,6\n"}) {
        const auto found = heights(text);
        EXPECT_DOUBLE_EQ(found[1], 5e-6) << text;
        EXPECT_DOUBLE_EQ(found[3], 6e-6) << text;
    }
}

TEST(CurveText, SecondColumnWithEvenStepsGivesPositions) {
    std::string text, named;
    for (int i = 0; i < 12; ++i) {
        text += fmt::format("{} {}\n", (7 * i * i) % 11, 0.5 * i);
        named += fmt::format("{},{}\n", (7 * i * i) % 11, 0.5 * i);
    }
    const auto channel = channel_of(text);
    const auto line = std::get<LineScan>(channel.read());
    EXPECT_DOUBLE_EQ(line.size, 6e-6);
    EXPECT_DOUBLE_EQ(line.heights[1], 7e-6);
    EXPECT_EQ(channel.info.alerts.at(0).code, "AMBIGUOUS_COLUMNS");
    EXPECT_NE(refusal("x,y\n" + named).find("jumps back and forth"), std::string::npos) << "x is named";
}

TEST(XyzText, NamedPointsOnOneLineAreALineScan) {
    const auto line = std::get<LineScan>(channel_of("x [um],y [um],z [um]\n0,2,5\n1,2,6\n2,2,7\n3,2,4\n", {}).read());
    EXPECT_DOUBLE_EQ(line.size, 4e-6);
    EXPECT_DOUBLE_EQ(line.heights[1], 6e-6);
}

TEST(MatrixText, TallTablesWithoutNamesAreNotMaps) {
    std::string text;
    for (int i = 0; i < 250; ++i) text += fmt::format("{} {} {} {}\n", (7 * i) % 31, i % 5, (3 * i) % 17, (i * i) % 23);
    const auto channel = channel_of(text, {});
    EXPECT_NE(channel.info.not_heights.find("a table of 4 columns"), std::string::npos);
    EXPECT_TRUE(channel_of(text, taken_as(TextLayout::matrix)).info.not_heights.empty());
}

TEST(MatrixText, RowsOfNoDataMarksAreNotAnIndex) {  // 1e30 + 1 is 1e30
    std::string text;
    for (int j = 0; j < 12; ++j)
        for (int i = 0; i < 8; ++i) text += fmt::format("{}{}", j < 9 ? 1e30 : (7.3 * i * j), i < 7 ? " " : "\n");
    EXPECT_TRUE(channel_of(text, {}).info.not_heights.empty());
}

TEST(XyzText, ToleranceOfStepsIsRelative) {  // the other reader compares with 1e-6 of the unit of the
                                             // file: metres always pass
    EXPECT_EQ(
        channel_of("0 0 1e-9\n0 1e-7 2e-9\n1e-7 0 3e-9\n1e-7 1e-7 4e-9\n3.5e-7 0 1e-9\n3.5e-7 1e-7 2e-9\n", {{}, "m"})
            .info.shape,
        (std::vector<Index>{3, 6}))
        << "no regular grid";
    EXPECT_EQ(
        channel_of("0 0 1\n0 0.333 2\n0 0.667 2\n0 1.000 2\n0.333 0 3\n0.333 0.333 4\n0.333 0.667 4\n0.333 1.000 4\n")
            .info.shape,
        (std::vector<Index>{2, 4}))
        << "rounded positions";
    EXPECT_TRUE(std::holds_alternative<Profile>(channel_of("0 1\n1e-7 2\n3e-7 3\n4e-7 1\n", {{}, "m"}).read()));
}

TEST(XyzText, PositionsMayStartAnywhere) {
    const auto map = map_of("-3 10 1\n-3 12 2\n-2 10 3\n-2 12 4\n-1 10 5\n-1 12 6\n");
    EXPECT_EQ(map.shape(), (std::array<Index, 2>{3, 2}));
    EXPECT_DOUBLE_EQ(map.size[1], 4e-6);
    EXPECT_DOUBLE_EQ(map.heights(0, 1), 2e-6);
}

TEST(XyzText, UnitsOfTheHeaderGiveNoWarning) {
    const auto channel = channel_of("x [mm];y [mm];z [nm]\n0,0;0,0;1,5\n0,0;0,1;2\n0,1;0,0;3\n0,1;0,1;4\n", {});
    EXPECT_TRUE(channel.info.alerts.empty());
    const auto map = std::get<HeightMap>(channel.read());
    EXPECT_DOUBLE_EQ(map.heights(0, 0), 1.5e-9);
    EXPECT_NEAR(map.size[0], 0.2e-3, 1e-16);
}

TEST(XyzText, MissingUnitIsListedAndRefusedOnReading) {
    const auto channel = channel_of("0 0 1\n0 1 2\n1 0 3\n1 1 4\n", {});
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{2, 2}));
    EXPECT_THROW((void)channel.read(), InvalidArgument);
}

TEST(XyzText, OtherQuantitiesAreListedOnly) {
    const auto channel =
        channel_of("# Channel: Phase\n# Lateral units: µm\n# Value units: deg\n0 0 1\n0 1 2\n1 0 3\n1 1 4\n", {});
    EXPECT_FALSE(channel.info.is_height);
    EXPECT_EQ(channel.info.unit, "deg");
}

TEST(XyzText, ScatteredAndDuplicatePointsAreRefused) {
    EXPECT_NE(
        refusal("x;y;z\n0;0;1\n0.3;0.7;2\n0.9;0.1;3\n0.55;0.4;1\n").find("x of the points has 4 values for 4 points"),
        std::string::npos);
    EXPECT_NE(refusal("x;y;z\n0;0;1\n0;1;2\n1;0;3\n1;0;4\n").find("lie at x = 1, y = 0"), std::string::npos);
    EXPECT_NE(refusal("x;y;z\n0;0;1\n0;1;2\n1;0;3\n1;nan;4\n").find("y of the points is undefined"), std::string::npos);
}

TEST(XyzText, DistantPointsAreRefusedWithoutAHugeMap) {
    EXPECT_NE(refusal("x;y;z\n0;0;1\n0;1;2\n1;0;3\n1;1;4\n20;0;1\n20;1;1\n").find("gaps of too many steps"),
              std::string::npos);
    EXPECT_NE(refusal("x;y;z\n0;0;1\n0;1;2\n1;0;3\n1;1;4\n1e12;0;1\n1e12;1;1\n").find("regular grid"),
              std::string::npos);
    EXPECT_NE(refusal("x;y;z\n-1e308;0;1\n-1e308;1;2\n1e308;0;3\n1e308;1;4\n").find("is equal for all points"),
              std::string::npos);
}

TEST(ThreeColumns, OnAGridArePointsUnlessTheUserChoosesOtherwise) {
    const std::string text = "0 0 1\n0 1 2\n1 0 3\n1 1 4\n";
    const auto points = channel_of(text);
    EXPECT_EQ(points.info.format, "xyz");
    ASSERT_EQ(points.info.alerts.size(), 1u);
    EXPECT_EQ(points.info.alerts[0].code, "AMBIGUOUS_COLUMNS");
    EXPECT_NE(points.info.alerts[0].action.find("`layout` to matrix"), std::string::npos);
    const auto matrix = channel_of(text, taken_as(TextLayout::matrix));
    EXPECT_EQ(matrix.info.shape, (std::vector<Index>{3, 4}));
    EXPECT_EQ(matrix.info.format, "matrix");
    EXPECT_TRUE(matrix.info.alerts.empty());
    EXPECT_TRUE(channel_of(text, taken_as(TextLayout::columns)).info.alerts.empty());
}

TEST(ThreeColumns, AfterAnIndexColumnAreACurve) {
    const std::string text = "0 -2.0 1\n1 -1.5 2\n2 -1.0 3\n3 -0.5 1\n";
    const auto curve = channel_of(text);
    EXPECT_EQ(curve.info.format, "xy");
    EXPECT_EQ(curve.info.alerts.at(0).code, "AMBIGUOUS_COLUMNS");
    EXPECT_DOUBLE_EQ(std::get<LineScan>(curve.read()).size, 2e-6);
    EXPECT_EQ(channel_of(text, taken_as(TextLayout::matrix)).info.shape, (std::vector<Index>{3, 4}));
    EXPECT_TRUE(channel_of("index,x [um],h [um]\n0,-2.0,1\n1,-1.5,2\n2,-1.0,3\n").info.alerts.empty());
}

TEST(ThreeColumns, NotOnAGridAreANarrowMap) {
    const std::string text = "1 4 2\n3 7 5\n2 2 8\n9 1 1\n";
    const auto matrix = channel_of(text);
    EXPECT_EQ(matrix.info.shape, (std::vector<Index>{3, 4}));
    EXPECT_EQ(matrix.info.alerts.at(0).code, "AMBIGUOUS_COLUMNS");
    EXPECT_NE(matrix.info.alerts[0].action.find("`layout` to columns"), std::string::npos);
    EXPECT_NE(refusal(text, taken_as(TextLayout::columns)).find("regular grid"), std::string::npos);
}

TEST(XyText, ExportsWithoutHeaderRequireAUnit) {  // as of KLA-Tencor's Alpha-Step and Apex
    const auto channel =
        channel_of("0.000000\t-16.602800\n0.001000\t-16.601200\n0.002000\t-16.596100\n0.003000\t-16.587800\n", {});
    EXPECT_EQ(channel.info.format, "xy");
    EXPECT_EQ(channel.info.shape, std::vector<Index>{4});
    EXPECT_TRUE(channel.info.unit.empty());
    EXPECT_THROW((void)channel.read(), InvalidArgument);
}

TEST(XyText, ColumnsThatDoNotFormACurveAreRefused) {
    EXPECT_NE(refusal("3 2 3 4\n9 6 7 8\n5 1 1 1\n", taken_as(TextLayout::columns)).find("4 columns"),
              std::string::npos)
        << "the first turns back";
    EXPECT_NE(refusal("time [s];force [N]\n0;1\n1;2\n").find("`setae jkr fit`"), std::string::npos);
}

TEST(Dektak, EveryColumnOfHeightsIsAChannel) {
    const auto channels = open(
        bytes::memory_source(
            "d.csv",
            "Scan Parameters\nStylus,Radius: 12.5 um\n\nScan Data\nLateral um,Raw nm,Levelled nm\n0,1,5\n1,2,6\n2,3,7\n"),
        {});
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[1].info.name, "Levelled");
    EXPECT_DOUBLE_EQ(std::get<LineScan>(channels[1].read()).heights[2], 7e-9);
    EXPECT_DOUBLE_EQ(channels[1].info.metadata.instrument.tip_radius.value(), 12.5e-6);
}

TEST(Dektak, DamagedStylusEntryIsIgnored) {
    const auto channel =
        open(
            bytes::memory_source(
                "d.csv",
                "Scan Parameters\nAnalytical Results\nStylus,Radius: 2.5 um,x\n\nScan Data\nLateral um,Raw nm\n0,1\n1,2\n2,3\n"),
            {})
            .at(0);
    EXPECT_FALSE(channel.info.metadata.instrument.tip_radius.has_value());
}

TEST(Dabam, DescriptionFileIsRefusedWithTheFileToOpen) {
    try {
        (void)open(bytes::memory_source("m.txt", R"({"FILE_FORMAT": 1, "FILE_HEADER_LINES": 0, "X1_FACTOR": 0.001})"),
                   {});
        FAIL() << "opened";
    } catch (const FormatError& error) {
        EXPECT_NE(std::string(error.what()).find(".dat"), std::string::npos);
    }
}

TEST(Commas, ThatMayGroupThousandsAreRefusedInMaps) {
    const auto* text = "1,234 5,678 9,012 3,456\n1,235 5,679 9,013 3,457\n";
    EXPECT_NE(refusal(text).find("ambiguous"), std::string::npos);
    EXPECT_EQ(channel_of(std::string(text) + "1,5 2,5 3,5 4,5\n", {{{4e-6, 3e-6}}, "um"}).info.shape,
              (std::vector<Index>{4, 3}))
        << "another number decides";
    EXPECT_NE(refusal("x,h\n0,5,1,5\n1,5,2,5\n").find("also to mark decimals"), std::string::npos);
}

TEST(TextNumbers, RefusesImpossibleCountsBeforeAllocation) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "1\n";
    tables::TextStart start;
    start.source = bytes::memory_source("short.txt", text);
    start.layout.columns = std::size_t{1} << 40;
    const auto lines = tables::find_number_lines(start, 0, text.size());
    EXPECT_EQ(lines.rows, 1000);
    EXPECT_THROW((void)tables::read_numbers(lines), FormatError);
}

TEST(Dabam, DescriptionNextToTheFileGivesUnitsAndColumns) {
    const TemporaryFolder folder;
    folder.write(
        "m.txt",
        R"({"FILE_FORMAT": 1, "FILE_HEADER_LINES": 0, "X1_FACTOR": 0.001, "Y1_FACTOR": 1e-6, "FACILITY": "ESRF", "SCAN_DATE": null})");
    const auto channel = open(folder.write("m.dat", "; remark\n0 1\n1 3\n2 -1\n3 0\n")).at(0);
    EXPECT_EQ(channel.info.format, "dabam");
    EXPECT_EQ(channel.info.alerts.at(0).code, "SLOPES_INTEGRATED");
    EXPECT_EQ(channel.info.metadata.attributes.at("FACILITY"), "ESRF");
    const auto scan = std::get<LineScan>(channel.read());
    EXPECT_NEAR(scan.heights[1], 2e-9, 1e-21);
    EXPECT_NEAR(scan.heights[3], 2.5e-9, 1e-21);
    EXPECT_DOUBLE_EQ(scan.size, 4e-3);
}

TEST(Dabam, DamagedDescriptionsAreIgnored) {
    const TemporaryFolder folder;
    const auto path = folder.write("m.dat", "0 1\n1 3\n2 -1\n");
    for (const auto* text : {"{", "[1, 2]", R"({"FILE_FORMAT": 1})", ""}) {
        folder.write("m.txt", text);
        EXPECT_EQ(open(path).at(0).info.format, "xy") << text;
    }
    folder.write("m.txt", R"({"FILE_FORMAT": 1, "X1_FACTOR": -1})");
    EXPECT_THROW((void)open(path), FormatError);
}

}  // namespace
}  // namespace setae::formats::tests::columns_test
