// SPDX-License-Identifier: GPL-3.0-or-later
#include "oir_samples.hpp"

#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::oir_test {
namespace {

const Array2D raw = lopsided_heights(5, 4, 100.0);

std::vector<Channel> opened(const std::string& content) { return open(bytes::memory_source("a.oir", content), {}); }
std::string refusal(const std::string& content) {
    return message_of([&] { (void)opened(content); });
}
std::string replaced(std::string content, std::string_view from, std::string_view to) {
    for (auto at = content.find(from); at != std::string::npos; at = content.find(from, at + to.size()))
        content.replace(at, from.size(), to);
    return content;
}

TEST(Oir, CalibrationAppliesToHeightsAndLengths) {
    const auto channel = opened(oir_file({.raw = raw})).at(1);
    const auto map = std::get<topography::HeightMap>(channel.read());
    EXPECT_NEAR(map.heights(2, 1), raw(2, 1) * 0.01 * 3.0 * units::um, 1e-18);
    EXPECT_NEAR(map.size[0], 5 * 0.5 * 1.0 * units::um, 1e-18);
    EXPECT_NEAR(map.size[1], 4 * 0.25 * 2.0 * units::um, 1e-18);
    EXPECT_EQ(channel.info.unit, "µm");
}

TEST(Oir, ListsOtherChannelsThanHeights) {
    const auto channels = opened(oir_file({.raw = raw}));
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.name, "INTENSITY");
    EXPECT_FALSE(channels[0].info.is_height);
    const auto camera = opened(oir_file({.raw = raw, .camera = true}));
    ASSERT_EQ(camera.size(), 1u);
    EXPECT_FALSE(camera[0].info.is_height);
}

TEST(Oir, ReadsInstrumentAndTime) {
    const auto metadata = opened(oir_file({.raw = raw})).at(1).info.metadata;
    EXPECT_EQ(metadata.instrument.name, "OLS5000");
    EXPECT_EQ(metadata.acquisition_time, "2019-06-21T14:03:11.208+09:00");
}

TEST(Oir, BrokenPropertiesAreRefused) {
    const auto content = oir_file({.raw = raw});
    EXPECT_NE(refusal(replaced(content, "MICRO_METER", "SQUAREMETER")).find("unit"), std::string::npos);
    EXPECT_NE(refusal(replaced(content, "<commonparam:z>0.01<", "<commonparam:z>0.00<"))
                  .find("without a positive length or unit along z"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(content, "<commonphase:depth>2<", "<commonphase:depth>7<")).find("heights of 7 bytes"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(content, "<commonimage:width>5<", "<commonimage:width>6<"))
                  .find("the file ends here, expected the end of its heights (6 × 4 points)"),
              std::string::npos);
    EXPECT_NE(refusal(replaced(content, "t001_0_1_1f0c2a34-0000-4000-8000-00000000000a",
                               "t001_0_1_1f0c2a34-0000-4000-8000-00000000000c"))
                  .find("without the points of image"),
              std::string::npos);
    EXPECT_NE(refusal(ByteBuilder().text(content).number_at(96, -7).content()).find("a chunk of -7 bytes"),
              std::string::npos);
}

TEST(Poir, ReadsEveryOirFileOfTheArchive) {
    const auto content = zip_archive({{"notes.txt", "x"},
                                      {"a.oir", oir_file({.raw = raw})},
                                      {"folder/b.OIR", oir_file({.raw = raw * 2.0})},
                                      {"c.oir", "OLYMPUSRAWFORMAT cut"}});
    const auto channels = open(bytes::memory_source("a.poir", content), {});
    ASSERT_EQ(channels.size(), 5u);
    EXPECT_EQ(channels[1].info.name, "a.oir: Height");
    EXPECT_EQ(channels[3].info.name, "b.OIR: Height");
    EXPECT_EQ(channels[3].info.format, "poir");
    EXPECT_EQ(channels[4].info.alerts.at(0).code, "UNREADABLE_MEMBER");
    EXPECT_NEAR(topography::all_heights(channels[3].read())[7], 2.0 * topography::all_heights(channels[1].read())[7],
                1e-18);
}

}  // namespace
}  // namespace setae::formats::tests::oir_test
