// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/formats/format.hpp"
#include "text/trace.hpp"

/// Profiles with positions that are rounded, repeated, missing, or run back and forth, and tables of several profiles.
using namespace setae::tests;

namespace setae::formats::tests::trace_test {
namespace {

using topography::LineScan;
using topography::Profile;

double height(Index i) { return std::sin(0.1 * static_cast<double>(i)); }

/// Lines of x and h.
std::string curve(const std::vector<double>& x, const std::vector<double>& heights, int digits = 4) {
    std::string text = "x [mm],z [um]\n";
    for (std::size_t i = 0; i < x.size(); ++i) text += fmt::format("{:.{}f},{:.6f}\n", x[i], digits, heights[i]);
    return text;
}

std::vector<Channel> channels_of(const std::string& text, const ReadOptions& options = {}) {
    return open(bytes::memory_source("t.csv", text), options);
}

std::vector<std::string> codes(const topography::Measurement& measurement) {
    std::vector<std::string> found;
    for (const auto& alert : topography::metadata(measurement).alerts) found.push_back(alert.code);
    return found;
}

std::string refusal(const std::string& text, const ReadOptions& options = {}) {
    return message_of([&] {
        for (const auto& channel : channels_of(text, options)) (void)channel.read();
    });
}

TEST(LastDigit, IsTheLastDigitOfTheFileInAnyUnit) {
    const Array1D rounded = Array1D::LinSpaced(30, 0.0, 2.9);
    EXPECT_DOUBLE_EQ(last_digit(rounded), 0.1);
    EXPECT_NEAR(last_digit(1e-6 * rounded), 1e-7, 1e-20);
    EXPECT_DOUBLE_EQ(last_digit(1000.0 * rounded), 100.0);
    EXPECT_EQ(last_digit(1e-9 * rounded / 7.0), 0.0);
    EXPECT_EQ(last_digit(Array1D::Zero(3)), 0.0);
}

TEST(Trace, RoundedPositionsOfEqualStepsGiveALineScan) {
    std::vector<double> x, h;
    for (Index i = 0; i < 300; ++i) {
        x.push_back(0.0533 * static_cast<double>(i));
        h.push_back(height(i));
    }
    const auto scan = std::get<LineScan>(channels_of(curve(x, h, 2)).at(0).read());  // deviates by a tenth of a step
    EXPECT_EQ(scan.heights.size(), 300);
    EXPECT_NEAR(scan.pixel_size(), 0.0533e-3, 1e-8);
    EXPECT_TRUE(scan.metadata.alerts.empty());
    const auto coarse = std::get<LineScan>(channels_of(curve(x, h, 1)).at(0).read());
    EXPECT_EQ(coarse.heights.size(), 300);
    EXPECT_NEAR(coarse.pixel_size(), 0.0533e-3, 1e-7);
    EXPECT_EQ(codes(coarse), std::vector<std::string>{"POSITIONS_REPEATED"});
}

TEST(Trace, HeightsAtOnePositionAreAveraged) {
    std::vector<double> x, h;
    for (Index i = 0; i < 60; ++i)
        for (int k = 0; k < 2; ++k) {
            x.push_back(0.01 * static_cast<double>(i * i));
            h.push_back(static_cast<double>(i) + k);
        }
    const auto profile = std::get<Profile>(channels_of(curve(x, h)).at(0).read());
    ASSERT_EQ(profile.positions.size(), 60);
    EXPECT_NEAR(profile.heights[7], 7.5e-6, 1e-15);
    EXPECT_EQ(codes(profile), std::vector<std::string>{"POSITIONS_REPEATED"});
}

TEST(Trace, MissingRowsAreGaps) {
    std::vector<double> x, h;
    for (Index i = 0; i < 400; ++i) {
        if ((i >= 50 && i < 110) || i == 200) continue;
        x.push_back(0.025 * static_cast<double>(i));
        h.push_back(height(i));
    }
    const auto scan = std::get<LineScan>(channels_of(curve(x, h)).at(0).read());
    ASSERT_EQ(scan.heights.size(), 400);
    EXPECT_EQ(scan.heights.isNaN().count(), 61);
    EXPECT_NEAR(scan.heights[300], height(300) * 1e-6, 1e-12);
    ASSERT_EQ(codes(scan), std::vector<std::string>{"ROWS_MISSING"});
    EXPECT_NE(scan.metadata.alerts[0].message.find("61 rows are missing in 2 gaps"), std::string::npos);
}

TEST(Trace, UnevenPositionsGiveAProfile) {
    std::vector<double> x, h;
    for (Index i = 0; i < 100; ++i) {
        x.push_back(0.01 * static_cast<double>(i) * (1.0 + 0.01 * static_cast<double>(i)));
        h.push_back(height(i));
    }
    const auto profile = std::get<Profile>(channels_of(curve(x, h, 6)).at(0).read());
    EXPECT_EQ(profile.positions.size(), 100);
    EXPECT_TRUE(profile.metadata.alerts.empty());
}

TEST(Passes, ForwardAndBackwardAreTwoChannels) {
    std::vector<double> x, h;
    for (Index i = 0; i < 50; ++i) {
        x.push_back(0.5 * static_cast<double>(i));
        h.push_back(height(i));
    }
    for (Index i = 49; i >= 0; --i) {
        x.push_back(0.5 * static_cast<double>(i));
        h.push_back(height(i) + 1.0);
    }
    const auto channels = channels_of(curve(x, h));
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.name, "z (forward)");
    EXPECT_EQ(channels[1].info.name, "z (backward)");
    const auto forward = std::get<LineScan>(channels[0].read()), backward = std::get<LineScan>(channels[1].read());
    EXPECT_EQ(forward.heights.size(), 50);
    EXPECT_EQ(codes(forward), std::vector<std::string>{"PASSES_SPLIT"});
    for (Index i = 0; i < 50; ++i) EXPECT_NEAR(backward.heights[i] - forward.heights[i], 1e-6, 1e-15);
}

TEST(Passes, MayAllStartAtTheSameEnd) {
    std::vector<double> x, h;
    for (int pass = 0; pass < 3; ++pass)
        for (Index i = 0; i < 40; ++i) {
            x.push_back(0.5 * static_cast<double>(i));
            h.push_back(height(i) + pass);
        }
    const auto channels = channels_of(curve(x, h));
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[2].info.name, "z (pass 3, forward)");
    EXPECT_NEAR(std::get<LineScan>(channels[2].read()).heights[0], 2e-6, 1e-15);
}

TEST(Passes, ReentrantContoursAreOnePass) {
    std::vector<double> x, h;
    for (Index i = 0; i < 100; ++i) {
        x.push_back(0.1 * static_cast<double>(i) - (i % 10 == 7 ? 0.15 : 0.0));
        h.push_back(height(i));
    }
    EXPECT_EQ(channels_of(curve(x, h)).size(), 1u);
}

TEST(Positions, OfScatteredPointsAreNotAProfile) {
    std::vector<double> x, y;
    for (Index i = 0; i < 40; ++i) {
        x.push_back(static_cast<double>((i * 37) % 41));
        y.push_back(static_cast<double>((i * 23) % 43));
    }
    EXPECT_NE(refusal(curve(x, y)).find("positions of scattered points"), std::string::npos);
}

std::string table(const std::string& header, Index lines, Index rows = 30) {
    std::string text = header + "\n";
    for (Index j = 0; j < rows; ++j) {
        text += fmt::format("{:.2f}", 0.5 * static_cast<double>(j));
        for (Index k = 0; k < lines; ++k) text += fmt::format(",{:.5f}", height(j + 7 * k));
        text += '\n';
    }
    return text;
}

TEST(ProfileTable, EachColumnIsAChannel) {
    for (const auto* header : {"x [mm],line 1 [um],line 2 [um],line 3 [um]", "Position (mm),a (um),b (um),c (um)"}) {
        const auto channels = channels_of(table(header, 3));
        ASSERT_EQ(channels.size(), 3u) << header;
        const auto scan = std::get<LineScan>(channels[1].read());
        EXPECT_EQ(scan.heights.size(), 30);
        EXPECT_NEAR(scan.size, 15e-3, 1e-12);
        EXPECT_NEAR(scan.heights[4], height(11) * 1e-6, 1e-11);
    }
    EXPECT_EQ(channels_of(table("x [mm],left [um],right [um]", 2)).size(), 2u);
}

TEST(ProfileTable, IsNotAMapForAnyGivenSize) {
    const auto channels = channels_of(table("x [mm],a [um],b [um],c [um]", 3), {.size = {{1e-3, 1e-3}}, .unit = "um"});
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_EQ(channels[0].info.shape, std::vector<Index>{30});
}

TEST(ProfileTable, ListsOtherQuantitiesWithTheReason) {
    const auto channels = channels_of(table("x [mm],z [um],load [mN],rms [um]", 3));
    ASSERT_EQ(channels.size(), 3u);
    EXPECT_TRUE(channels[0].info.is_height);
    EXPECT_EQ(channels[1].info.not_heights, "its name means load");
    EXPECT_EQ(channels[2].info.not_heights, "its name means rms");
}

TEST(ProfileTable, RequiresPositionsInTheFirstColumn) {
    EXPECT_NE(refusal(table("time [s],a [um],b [um],c [um]", 3)).find("not heights: 4 columns"), std::string::npos);
    EXPECT_NE(refusal(table("a,b,c,d", 3)).find("`layout` to matrix and give `size`"), std::string::npos);
}

TEST(TwoNamedColumns, OfOtherQuantitiesAreNotHeights) {
    const auto channels = channels_of(table("time,voltage", 1), {.unit = "um"});
    EXPECT_FALSE(channels.at(0).info.is_height);
    EXPECT_EQ(channels[0].info.not_heights, "the first column is named time, expected positions");
    EXPECT_TRUE(
        channels_of(table("time,voltage", 1), {.unit = "um", .layout = TextLayout::columns}).at(0).info.is_height);
}

TEST(RowNumbers, AreNotHeights) {
    std::string column, matrix;
    for (int i = 0; i < 100; ++i) {
        column += fmt::format("{}\n", i);
        matrix += fmt::format("{}{}", i, i % 10 < 9 ? "," : "\n");
    }
    const ReadOptions line{.size = {{1e-3}}, .unit = "um"}, map{.size = {{1e-3, 1e-3}}, .unit = "um"};
    EXPECT_FALSE(channels_of(column, line).at(0).info.is_height);
    EXPECT_FALSE(channels_of(matrix, map).at(0).info.is_height);
}

TEST(Tokens, OfMissingHeightsAreUndefinedInEveryDialect) {
    for (const auto* word : {"", "NaN", "NA", "N/A", "n/a", "null", "#N/A", "#NV", "-", "--", "***", "BAD", "1.#IND",
                             "-1.#QNAN", "-nan(ind)", "inf", "#DIV/0!", "None", "undefined"})
        for (const auto& [separator, decimal] : {std::pair{',', '.'}, {';', ','}, {'\t', ','}}) {
            std::string text;
            for (int j = 0; j < 6; ++j)
                for (int i = 0; i < 5; ++i) {
                    auto cell = (i + 2 * j) % 4 == 0 ? std::string(word) : fmt::format("{}.25", 10 * j + i);
                    if ((i + 2 * j) % 4 != 0) std::replace(cell.begin(), cell.end(), '.', decimal);
                    text += cell + (i < 4 ? std::string(1, separator) : "\n");
                }
            const auto map = std::get<topography::HeightMap>(
                channels_of(text, {.size = {{5e-6, 6e-6}}, .unit = "um", .keep_values = true}).at(0).read());
            EXPECT_EQ(map.heights.isNaN().count(), 9) << word << separator;
            EXPECT_NEAR(map.heights(1, 2), 21.25e-6, 1e-15) << word << separator;
        }
}

TEST(Tokens, WhenInvalidAreNamedByRowAndColumn) {
    std::string text;
    for (int j = 0; j < 5; ++j) text += fmt::format("{0}.5,{0}.25,xx,{0}.75\n", j);
    EXPECT_NE(refusal(text, {.size = {{1e-6, 1e-6}}, .unit = "um"}).find("t.csv:1: 'xx' in column 3 is not a number"),
              std::string::npos);
    EXPECT_NE(refusal("x [um],z [um]\n0,1\n1,oops\n2,3\n3,4\n").find("t.csv:3: 'oops' in column 2"), std::string::npos);
    EXPECT_NE(refusal("0,oops\n1,2\n2,3\n3,4\n", {.unit = "um"}).find("t.csv:1: 'oops' in column 2"), std::string::npos)
        << "the first row is no header";
}

}  // namespace
}  // namespace setae::formats::tests::trace_test
