// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "patched_sample.hpp"
#include "setae/core/constants.hpp"

namespace setae::formats::tests::hgt_test {
namespace {

constexpr Index nx = 1801, ny = 3601;

std::int16_t height_at(Index i, Index j) { return static_cast<std::int16_t>((3 * i + 2 * j) % 4000 - 100); }

/// A tile of 1" by 2" with one void.
const std::string& tile() {
    static const std::string content = [] {
        std::string bytes(2 * nx * ny, '\0');
        for (Index j = 0; j < ny; ++j)
            for (Index i = 0; i < nx; ++i) {
                const auto raw = static_cast<std::uint16_t>(i == 5 && j == 7 ? -32768 : height_at(i, j));
                bytes[static_cast<std::size_t>(2 * (j * nx + i))] = static_cast<char>(raw >> 8);
                bytes[static_cast<std::size_t>(2 * (j * nx + i) + 1)] = static_cast<char>(raw & 0xff);
            }
        return bytes;
    }();
    return content;
}

Channel channel_named(const std::string& name) { return open(bytes::memory_source(name, tile()), {}).at(0); }

Match detected(const std::string& content) {
    const auto source = bytes::memory_source("file", content);
    for (const auto& format : formats())
        if (format.identifier == "hgt") return format.detect(source.head(bytes::detection_bytes), source);
    return Match::no;
}

TEST(Hgt, KeepsAxesAndUndefinedPointsOfANonSquareMap) {
    EXPECT_EQ(detect_format(bytes::memory_source("N61E007.hgt", tile())).identifier, "hgt");
    const auto map = map_of(channel_named("N61E007.hgt"));
    ASSERT_EQ(map.shape(), (std::array<Index, 2>{nx, ny}));
    EXPECT_EQ(map.heights.isNaN().count(), 1);
    EXPECT_TRUE(std::isnan(map.heights(5, 7)));
    for (const auto& [i, j] : {std::pair<Index, Index>{0, 0}, {1800, 0}, {0, 3600}, {1800, 3600}, {17, 2900}})
        EXPECT_DOUBLE_EQ(map.heights(i, j), height_at(i, j)) << i << ' ' << j;
}

TEST(Hgt, LengthOfADegreeIsThatOfTheEllipsoid) {
    // NGA's series for the length of a degree of longitude and latitude [m]
    const double latitude = 46.5 * pi / 180.0;
    const double east = 111412.84 * std::cos(latitude) - 93.5 * std::cos(3 * latitude) + 0.118 * std::cos(5 * latitude);
    const double north =
        111132.92 - 559.82 * std::cos(2 * latitude) + 1.175 * std::cos(4 * latitude) - 0.0023 * std::cos(6 * latitude);
    const auto info = channel_named("folder/N46E007.hgt").info;
    EXPECT_NEAR(info.size.at(0) * (nx - 1) / nx / east, 1.0, 1e-6);
    EXPECT_NEAR(info.size.at(1) * (ny - 1) / ny / north, 1.0, 1e-6);
    ASSERT_EQ(info.alerts.size(), 1u);
    EXPECT_EQ(info.alerts[0].code, "SIZE_FROM_NAME");
}

TEST(Hgt, SouthernTilesSpanTowardsTheEquator) {
    EXPECT_NEAR(channel_named("archive.zip: s47w070.HGT").info.size.at(0), channel_named("N46E007.hgt").info.size.at(0),
                1e-6)
        << "both from 46 to 47 degrees";
}

TEST(Hgt, OtherNamesLeaveTheSizeMissing) {
    for (const auto* name : {"tile.hgt", "N4", "NxxE007.hgt", "N99E007.hgt"})
        EXPECT_EQ(missing(channel_named(name).info).at(0), "size") << name;
    const auto message = message_of([] { (void)channel_named("tile.hgt").read(); });
    EXPECT_NE(message.find("give `size`"), std::string::npos) << message;
}

TEST(Hgt, OtherContentOfThatLengthIsNotRead) {
    constexpr std::size_t length = 2 * 1201 * 1201;
    EXPECT_EQ(detected(std::string(length, '\0')), Match::no) << "zeros";
    EXPECT_EQ(detected(std::string(length, 'x')), Match::no) << "text";
    std::mt19937 random(1);
    std::string noise(length, '\0');
    for (auto& c : noise) c = static_cast<char>(random());
    EXPECT_EQ(detected(noise), Match::no) << "noise";
    std::string swapped = tile();
    for (std::size_t at = 0; at < swapped.size(); at += 2) std::swap(swapped[at], swapped[at + 1]);
    EXPECT_EQ(detected(swapped), Match::no) << "little-endian";
    EXPECT_EQ(detected(tile()), Match::maybe);
    EXPECT_EQ(detected(tile().substr(1)), Match::no) << "any other length";
}

TEST(Hgt, TilesOfThreeArcSecondsHaveTheRightShape) {
    const auto content = tile().substr(0, 2 * 1201 * 1201);
    EXPECT_EQ(open(bytes::memory_source("N10W020.hgt", content), {}).at(0).info.shape,
              (std::vector<Index>{1201, 1201}));
}

}  // namespace
}  // namespace setae::formats::tests::hgt_test
