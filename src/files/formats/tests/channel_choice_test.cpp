// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "height_names.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/channel.hpp"

using namespace setae::tests;

namespace setae::formats::tests::channel_choice_test {
namespace {

Channel channel(const std::string& name, bool is_height = true, std::vector<Index> shape = {4, 4},
                const std::string& unit = "nm") {
    ChannelInfo info{.name = name, .format = "x", .shape = std::move(shape), .size = {1.0, 1.0}, .unit = unit};
    info.is_height = is_height;
    return {std::move(info), {}};
}

TEST(ChannelChoice, PrefersNamesOfHeightsAndTheForwardScan) {
    EXPECT_EQ(preferred_channel({channel("Sneddon"), channel("Height (retrace)"), channel("Height (trace)")}), 2u);
    EXPECT_EQ(preferred_channel({channel("Z (backward)"), channel("Z (forward)")}), 1u);
    EXPECT_EQ(preferred_channel({channel("line", true, {9}), channel("data")}), 1u) << "a map goes before a line";
    EXPECT_EQ(preferred_channel({channel("a", true, {4, 4}, ""), channel("b")}), 1u) << "a unit that is known";
    EXPECT_EQ(preferred_channel({channel("b"), channel("a")}), 0u) << "else the order of the file";
    EXPECT_EQ(preferred_channel({channel("Height", false), channel("x")}), 1u);
    EXPECT_EQ(preferred_channel({channel("Phase", false)}), std::nullopt);
}

TEST(ChannelChoice, AcceptsNumbersAndNames) {
    const std::vector<Channel> channels{channel("Height (trace)"), channel("Phase", false),
                                        channel("Height (retrace)")};
    EXPECT_EQ(chosen_channels("f", channels, "2"), (std::vector<std::size_t>{2}));
    EXPECT_EQ(chosen_channels("f", channels, "height (r"), (std::vector<std::size_t>{2}));
    EXPECT_EQ(chosen_channels("f", channels, std::nullopt, true), (std::vector<std::size_t>{0, 2}));
    EXPECT_EQ(
        message_of([&] { (void)chosen_channels("f", channels, "hei"); }),
        "f: channel 'hei' is ambiguous: 0 'Height (trace)', 2 'Height (retrace)'; give the whole name or the number");
    EXPECT_NE(
        message_of([&] { (void)chosen_channels("f", channels, "3"); }).find("f: no channel 3; there are 0 'Height"),
        std::string::npos);
}

TEST(ChannelChoice, ExplainsWhyNoChannelContainsHeights) {
    auto index = channel("i", false);
    index.info.not_heights = "whole numbers that increase from value to value: an index";
    const auto message = message_of([&] {
        (void)chosen_channels("f", {index, channel("phase", false)}, std::nullopt);
    });
    EXPECT_NE(message.find("none of its 2 channels contains heights; 0 'i' is not heights: whole numbers"),
              std::string::npos)
        << message;
}

TEST(HeightNames, AreRecognisedByWholeWords) {
    for (const char* name :
         {"Height (trace)", "ZSensor", "Topography", "h", "Z (forward)", "/scan/z", "surfaceMap", "topo_raw"})
        EXPECT_TRUE(is_height_name(name)) << name;
    for (const char* name :
         {"phase", "zoom", "histogram", "x", "y", "weights", "amplitude", "/height2/phase2", "brightness"})
        EXPECT_FALSE(is_height_name(name)) << name;
}

}  // namespace
}  // namespace setae::formats::tests::channel_choice_test
