// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/formats/format.hpp"

/// Labels next to and above the heights of a table.
using namespace setae::tests;

namespace setae::formats::tests::labels_test {
namespace {

using topography::HeightMap;

constexpr Index nx = 11, ny = 9;

double height(Index i, Index j) { return 0.001 * static_cast<double>((37 * i * i + 29 * j * j + 5 * i * j) % 97); }

/// Rows of heights after what `label` gives for each.
template <class Label>
std::string rows(const char* separator, const Label& label) {
    std::string text;
    for (Index j = 0; j < ny; ++j) {
        text += label(j);
        for (Index i = 0; i < nx; ++i) text += fmt::format("{}{:.3f}", i > 0 ? separator : "", height(i, j));
        text += '\n';
    }
    return text;
}

std::string positions(const char* separator, double first, double step) {
    std::string text;
    for (Index i = 0; i < nx; ++i)
        text += fmt::format("{}{:.3f}", i > 0 ? separator : "", first + step * static_cast<double>(i));
    return text + "\n";
}

std::string labelled(const std::string& corner, const char* separator = ",", double step = 1.5) {
    return corner + positions(separator, 2.0, step) +
           rows(separator, [&](Index j) { return fmt::format("{:.3f}{}", 0.25 * static_cast<double>(j), separator); });
}

Channel channel_of(const std::string& text, const ReadOptions& options = {.unit = "um"}) {
    return open(bytes::memory_source("m.csv", text), options).at(0);
}

std::string refusal(const std::string& text, const ReadOptions& options = {.unit = "um"}) {
    return message_of([&] { (void)channel_of(text, options).read(); });
}

bool tells_labels(const Channel& channel) {
    for (const auto& alert : channel.info.metadata.alerts)
        if (alert.code == "LABELS_NOT_HEIGHTS") return true;
    return false;
}

void expect_map(const Channel& channel, double size_x, double size_y, double unit = 1e-6) {
    ASSERT_EQ(channel.info.shape, (std::vector<Index>{nx, ny}));
    EXPECT_TRUE(tells_labels(channel));
    const auto map = std::get<HeightMap>(channel.read());
    EXPECT_NEAR(map.size[0], size_x, 1e-9 * size_x);
    EXPECT_NEAR(map.size[1], size_y, 1e-9 * size_y);
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) ASSERT_NEAR(map.heights(i, j), height(i, j) * unit, 1e-12 * unit);
}

TEST(MatrixLabels, AreReadAsPositionsForAnyCornerCell) {
    for (const auto* corner : {",", "y\\x,", "Y/X,", "0,", "nan,", "um,", "\"y / x\","})
        expect_map(channel_of(labelled(corner)), nx * 1.5e-6, ny * 0.25e-6);
    expect_map(channel_of(labelled("Y/X\t", "\t")), nx * 1.5e-6, ny * 0.25e-6);
    expect_map(channel_of(labelled("", ",")), nx * 1.5e-6, ny * 0.25e-6);  // no cell above the first column
}

TEST(MatrixLabels, TakeTheirUnitFromTheCornerCell) {
    const auto channel = channel_of(labelled("y\\x [nm],"), {});
    expect_map(channel, nx * 1.5e-9, ny * 0.25e-9, 1e-9);
    EXPECT_EQ(channel.info.alerts.at(0).code, "UNIT_ASSUMED");
    expect_map(channel_of(labelled("y\\x [mm],"), {.unit = "um"}), nx * 1.5e-3, ny * 0.25e-3);
    expect_map(channel_of(labelled("Y/X,"), {.unit = "mm, um"}), nx * 1.5e-3, ny * 0.25e-3);
}

TEST(MatrixLabels, WithoutUnitRequireTheUnitOnly) {
    EXPECT_NE(refusal(labelled(","), {}).find("states no unit"), std::string::npos);
}

TEST(MatrixLabels, ThatCountDoNotDetermineTheSize) {
    const auto counted = [](bool head, bool corner) {
        std::string text = head && corner ? "," : "";
        for (Index i = 0; head && i < nx; ++i) text += fmt::format("{}{}", i > 0 ? "," : "", i);
        return text + (head ? "\n" : "") + rows(",", [&](Index j) { return fmt::format("{},", j); });
    };
    for (const auto& text : {counted(true, true), counted(true, false), counted(false, false)}) {
        EXPECT_NE(refusal(text).find("states no size"), std::string::npos);
        expect_map(channel_of(text, {.size = {{11e-6, 9e-6}}, .unit = "um"}), 11e-6, 9e-6);
    }
}

TEST(MatrixLabels, AboveOnlyLeaveTheSizeAlongYMissing) {
    const auto text = positions(",", 0.0, 1.5) + rows(",", [](Index) { return ""; });
    EXPECT_NE(refusal(text).find("states no size"), std::string::npos);
    expect_map(channel_of(text, {.size = {{16.5e-6, 9e-6}}, .unit = "um"}), 16.5e-6, 9e-6);
}

TEST(MatrixLabels, ThatDecreaseReverseTheMap) {
    const auto channel = channel_of(labelled("Y/X,", ",", -1.5));
    const auto map = std::get<HeightMap>(channel.read());
    EXPECT_NEAR(map.heights(0, 2), height(nx - 1, 2) * 1e-6, 1e-18);
    EXPECT_NEAR(map.size[0], nx * 1.5e-6, 1e-15);
}

TEST(MatrixLabels, NextToRowsOnlyAreReportedAsAmbiguous) {
    const auto text = rows(",", [](Index j) { return fmt::format("{},", 0.5 * static_cast<double>(j)); });
    const auto message = refusal(text);
    EXPECT_NE(message.find("x of 11 profiles, or positions of the rows of a map"), std::string::npos) << message;
    EXPECT_NE(message.find("`layout` to columns or matrix"), std::string::npos);
    expect_map(channel_of(text, {.size = {{11e-6, 9e-6}}, .unit = "um", .layout = TextLayout::matrix}), 11e-6, 9e-6);
    const auto profiles = open(bytes::memory_source("m.csv", text), {.unit = "um", .layout = TextLayout::columns});
    ASSERT_EQ(profiles.size(), 11u);
    EXPECT_EQ(profiles[10].info.shape, std::vector<Index>{9});
    EXPECT_NEAR(profiles[10].info.size.at(0), 4.5e-6, 1e-15);
}

TEST(MatrixLabels, WithUnevenStepsAreRefused) {
    std::string head = "Y/X";
    for (Index i = 0; i < nx; ++i) head += fmt::format(",{}", i * i);
    EXPECT_NE(refusal(head + "\n" + rows(",", [](Index j) { return fmt::format("{},", j); })).find("not evenly spaced"),
              std::string::npos);
}

TEST(MatrixLabels, ThatAreIncompleteAreReported) {
    auto text = labelled("Y/X,");
    std::string long_text = text;
    for (Index j = ny; j < 200; ++j) {
        long_text += fmt::format("{:.3f}", 0.25 * static_cast<double>(j == 100 ? 101 : j));
        for (Index i = 0; i < nx; ++i) long_text += fmt::format(",{:.3f}", height(i, j % ny));
        long_text += '\n';
    }
    EXPECT_NE(refusal(long_text).find("position 25.25 of row 101"), std::string::npos) << refusal(long_text);
}

TEST(MatrixLabels, AreDistinguishedFromEvenlySpacedHeights) {
    std::string ramp;
    for (Index j = 0; j < ny; ++j)
        for (Index i = 0; i < nx; ++i)
            ramp += fmt::format("{:.2f}{}", 0.5 * static_cast<double>(i) + 2.0 * static_cast<double>(j),
                                i + 1 < nx ? "," : "\n");
    const ReadOptions sized{.size = {{11e-6, 9e-6}}, .unit = "um"};
    EXPECT_FALSE(tells_labels(channel_of(ramp, sized)));
    EXPECT_EQ(channel_of(ramp, sized).info.shape, (std::vector<Index>{nx, ny}));
    EXPECT_FALSE(
        tells_labels(channel_of("1,2,3,4\n5,6,9,8\n3,3,2,2\n1,0,0,1\n", {.size = {{1e-6, 1e-6}}, .unit = "um"})));
}

TEST(MatrixLabels, AreKeptAsHeightsOnRequest) {
    const auto channel = channel_of(labelled("0,"), {.size = {{1e-6, 1e-6}}, .unit = "um", .keep_values = true});
    EXPECT_EQ(channel.info.shape, (std::vector<Index>{nx + 1, ny + 1}));
}

TEST(ConfocalTable, ReadsSizeAndUnitFromTheHeader) {
    const auto table = [](const char* separator, bool quoted, char decimal) {
        const auto cell = [&](std::string text) { return quoted ? "\"" + text + "\"" : text; };
        std::string text;
        for (const auto& [key, value] :
             std::vector<std::pair<std::string, std::string>>{{"Date and time", "2024/03/05 10:11:12"},
                                                              {"Model", "VK-X1"},
                                                              {"Comment", ""},
                                                              {"Output image data", "Height"},
                                                              {"Horizontal", "11"},
                                                              {"Vertical", "9"},
                                                              {"Unit", "nm"}})
            text += cell(key) + separator + cell(value) + "\r\n";
        text += cell("XY calibration") + separator + cell("0.5") + separator + cell("um/pixel") + "\r\n\r\n" +
                cell("Height") + "\r\n";
        for (Index j = 0; j < ny; ++j)
            for (Index i = 0; i < nx; ++i) {
                auto number = fmt::format("{:.4f}", height(i, j));
                std::replace(number.begin(), number.end(), '.', decimal);
                text += cell(number) + (i + 1 < nx ? separator : "\r\n");
            }
        return text;
    };
    for (const auto& text : {table(",", false, '.'), table(",", true, '.'), table(",", true, ','),
                             table(";", false, ','), table("\t", true, ',')}) {
        const auto channel = channel_of(text, {});
        ASSERT_EQ(channel.info.shape, (std::vector<Index>{nx, ny}));
        EXPECT_EQ(channel.info.metadata.instrument.name, "VK-X1");
        EXPECT_EQ(channel.info.name, "Height");
        const auto map = std::get<HeightMap>(channel.read());
        EXPECT_NEAR(map.size[0], 5.5e-6, 1e-15);
        EXPECT_NEAR(map.heights(3, 4), height(3, 4) * 1e-9, 1e-18);
    }
    auto intensity = table(",", false, '.');
    intensity.replace(intensity.find("Output image data,Height"), 24, "Output image data,Light ");
    EXPECT_FALSE(channel_of(intensity, {}).info.is_height);
}

}  // namespace
}  // namespace setae::formats::tests::labels_test
