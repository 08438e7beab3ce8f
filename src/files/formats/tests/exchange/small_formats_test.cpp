// SPDX-License-Identifier: GPL-3.0-or-later
// Gwyddion Simple Field, heights in TIFF, TopoStats: additions to the tests of all formats.
#include <gtest/gtest.h>

#include "byte_builder.hpp"
#include "error_message.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"
#include "tiff_builder.hpp"

using namespace setae::tests;

namespace setae::formats::tests::small_formats_test {
namespace {

std::vector<Channel> opened(const std::string& content, const ReadOptions& options = {}) {
    return open(bytes::memory_source("a", content), options);
}

std::string refusal(const std::string& content, const ReadOptions& options = {}) {
    return message_of([&] { (void)opened(content, options).at(0).read(); });
}

TEST(Gsf, IsUnchangedAfterReadingAndWriting) {
    const TemporaryFolder folder;
    const topography::HeightMap map{lopsided_heights(5, 3, 1e-9), {2e-6, 3e-6}, false, {}};
    for (const char* name : {"t", "ti", "tit", "titl"}) {  // every length of the padding of the header
        auto named = map;
        named.metadata.name = name;
        format_to_write("a.gsf").write(folder.path("a.gsf"), named);
        const auto channel = open(folder.path("a.gsf")).at(0);
        EXPECT_EQ(channel.info.name, name);
        const auto back = std::get<topography::HeightMap>(channel.read());
        EXPECT_EQ(back.size, map.size);
        EXPECT_LT((back.heights / map.heights - 1.0).abs().maxCoeff(), 1e-7);
    }
    const topography::LineScan line{Array1D::Ones(3), 1.0, false, {}};
    EXPECT_NE(message_of([&] { format_to_write("a.gsf").write(folder.path("b.gsf"), line); }).find("maps"),
              std::string::npos);
}

TEST(Gsf, OtherQuantitiesAreListed) {
    const auto content = ByteBuilder()
                             .text("Gwyddion Simple Field 1.0\nXRes = 2\nYRes = 2\nZUnits = V\n")  // 55 bytes
                             .pad_to(56 + 16)
                             .content();
    EXPECT_FALSE(opened(content).at(0).info.is_height);
    EXPECT_NE(refusal("Gwyddion Simple Field 1.0\nXRes = 2\nZUnits = m\n" + std::string(20, '\0')).find("'yres'"),
              std::string::npos);
}

TEST(HeightTiff, ReportsTheUnitAsMissing) {
    const auto content = height_tiff_samples().at(0).content;
    const auto channel = opened(content).at(0);
    EXPECT_EQ(channel.info.size, (std::vector<double>{3e-6, 2e-6}));
    EXPECT_NE(refusal(content).find("`unit`"), std::string::npos);
    EXPECT_NE(refusal(height_tiff_samples().at(1).content).find("`size`"), std::string::npos);
}

TEST(HeightTiff, EightBitAndColourPicturesAreNotHeights) {
    for (const int samples : {1, 3}) {
        TiffPageBuilder page(std::endian::little);
        page.longs(256, {2}).longs(257, {2}).shorts(258, {8}).shorts(259, {1}).shorts(262, {1});
        page.shorts(277, {static_cast<std::uint16_t>(samples)})
            .strips(2, {std::string(4 * static_cast<std::size_t>(samples), 'x')});
        EXPECT_NE(refusal(tiff_file(std::endian::little, {page}), {.size = {{1e-6, 1e-6}}, .unit = "nm"})
                      .find("grey values have lost their scale"),
                  std::string::npos);
    }
}

TEST(TopoStats, MasksAreListed) {
    const auto channels = opened(topostats_samples().at(0).content);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.not_heights, "a result of TopoStats");
    EXPECT_EQ(preferred_channel(channels), 1u);
}

}  // namespace
}  // namespace setae::formats::tests::small_formats_test
