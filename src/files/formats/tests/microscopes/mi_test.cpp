// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "patched_sample.hpp"
#include "setae/core/constants.hpp"
#include "setae/formats/format.hpp"

using namespace setae::tests;

namespace setae::formats::tests::mi_test {
namespace {

FormatSample sample_of(const std::string& name) {
    for (auto& sample : mi_samples())
        if (sample.name == name) return sample;
    throw std::runtime_error("no sample " + name);
}

std::vector<Channel> opened(const std::string& content) {
    return formats::open(bytes::memory_source("a.mi", content), {});
}
std::string message(const std::string& content) {
    return message_of([&] {
        for (const auto& channel : opened(content))
            if (channel.info.is_height) (void)channel.read();
    });
}

/// SurfaceTopography read lengths in metres as micrometres.
TEST(Mi, SizesAreInMetresForAnyUnitOfHeights) {
    const auto info = opened(sample_of("BINARY").content).at(1).info;
    EXPECT_DOUBLE_EQ(info.size.at(0), 16 * units::um);
    EXPECT_EQ(info.unit, "µm");
}

/// "FALSE" is a nonempty text: SurfaceTopography read it as true. Rows have the same order for both directions of the
/// scan.
TEST(Mi, RowOrderFollowsTheScanDirection) {
    const auto sample = sample_of("BINARY_32");
    const auto down = opened(sample.content).at(1),
               up = opened(replaced(sample.content, "scanUp        FALSE", "scanUp        TRUE")).at(1);
    EXPECT_EQ(down.info.metadata.attributes.at("scan_direction"), "down");
    EXPECT_EQ(up.info.metadata.attributes.at("scan_direction"), "up");
    EXPECT_TRUE(
        (std::get<topography::HeightMap>(down.read()).heights == std::get<topography::HeightMap>(up.read()).heights)
            .all());
}

/// SurfaceTopography stopped at the first number as text.
TEST(Mi, NumbersAsTextAreRead) {
    const auto map = std::get<topography::HeightMap>(opened(sample_of("ASCII").content).at(1).read());
    EXPECT_NEAR(map.heights(0, 0), 7.0 * 3.0 * units::um / 32768.0, 1e-20);
}

TEST(Mi, OtherQuantitiesAreListedWithTheirUnit) {
    const auto channels = opened(sample_of("BINARY").content);
    EXPECT_EQ(channels.at(0).info.name, "Deflection (trace)");
    EXPECT_EQ(channels[0].info.unit, "V");
    EXPECT_FALSE(channels[0].info.is_height);
    EXPECT_EQ(channels.at(1).info.metadata.attributes.at("line_direction"), "retrace");
    EXPECT_EQ(channels[1].info.metadata.attributes.at("software_version"), "PicoView 0x10c04");
    EXPECT_EQ(channels[1].info.metadata.acquisition_time, "Tue Feb 18 15:00:51 2014");
}

TEST(Mi, OtherDataThanImagesIsRefusedByName) {
    const auto content = sample_of("BINARY").content;
    EXPECT_NE(message(replaced(content, "Image", "Spectroscopy")).find("'Spectroscopy'"), std::string::npos);
    EXPECT_NE(message(replaced(content, "data          BINARY", "data          PACKED")).find("'PACKED'"),
              std::string::npos);
    EXPECT_NE(message(replaced(content, "xPixels       8", "xPixels       900000000")).find("900000000 × 5"),
              std::string::npos);
    EXPECT_NE(message(replaced(content, "xPixels       8", "xPixels       -8")).find("'xPixels' is '-8'"),
              std::string::npos);
    const auto words = sample_of("ASCII").content;
    EXPECT_NE(message(words.substr(0, words.size() - 10) + " 1.x 1 1 1 1 1 1").find("'1.x' is not a number"),
              std::string::npos);
}

}  // namespace
}  // namespace setae::formats::tests::mi_test
