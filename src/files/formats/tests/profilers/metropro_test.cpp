// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>
#include <ctime>

#include <gtest/gtest.h>

#include "patched_sample.hpp"

namespace setae::formats::tests::metropro_test {
namespace {

const auto big = std::endian::big;

TEST(MetroPro, TimeIsUtcInAnyTimeZone) {
    for (const auto* zone : {"UTC", "America/New_York", "Asia/Tokyo"}) {
        setenv("TZ", zone, 1);
        tzset();
        EXPECT_EQ(channels_of(metropro_samples().at(0).content).at(0).info.metadata.acquisition_time,
                  "2011-07-23 16:49:36 UTC")
            << zone;
    }
    unsetenv("TZ");
    tzset();
}

TEST(MetroPro, NegativeSignOfTheHeaderInvertsHeights) {
    const auto file = metropro_samples().at(0).content;
    EXPECT_DOUBLE_EQ(map_of(channels_of(with_number<std::int16_t>(file, 232, 1, big)).at(0)).heights(0, 0),
                     -map_of(channels_of(file).at(0)).heights(0, 0));
}

TEST(MetroPro, HeightStepFollowsPhaseResolution) {
    const auto file = metropro_samples().at(0).content;
    const double normal = map_of(channels_of(file).at(0)).heights(0, 0);
    EXPECT_DOUBLE_EQ(map_of(channels_of(with_number<std::int16_t>(file, 218, 1, big)).at(0)).heights(0, 0),
                     normal / 8.0);
    EXPECT_DOUBLE_EQ(map_of(channels_of(with_number<std::int16_t>(file, 218, 2, big)).at(0)).heights(0, 0),
                     normal / 32.0);
    EXPECT_EQ(refusal(with_number<std::int16_t>(file, 218, 3, big)),
              "file: at byte 218: MetroPro: phase resolution 3, expected 0, 1 or 2");
}

TEST(MetroPro, ObliquityScalesHeights) {
    const auto file = metropro_samples().at(0).content;
    EXPECT_DOUBLE_EQ(map_of(channels_of(with_number(file, 176, 2.5f, big)).at(0)).heights(0, 0),
                     2.0 * map_of(channels_of(file).at(0)).heights(0, 0));
}

TEST(MetroPro, IntensitiesAreListedAfterThePhase) {
    const auto channels = channels_of(metropro_samples().at(1).content);
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].info.name, "Phase");
    EXPECT_EQ(channels[1].info.name, "Intensity");
    EXPECT_FALSE(channels[1].info.is_height);
    EXPECT_EQ(channels[1].info.metadata.attributes.at("buckets"), "2");
    EXPECT_EQ(channels[0].info.metadata.instrument.name, "Zygo NewView");
    EXPECT_EQ(channels[0].info.metadata.attributes.at("serial_number"), "4711");
}

TEST(MetroPro, SerialNumberOfNewerFilesIsComplete) {
    const auto file = with_number<std::int32_t>(metropro_samples().at(0).content, 798, 70000);
    EXPECT_EQ(channels_of(file).at(0).info.metadata.attributes.at("serial_number"), "70000")
        << "this field is little-endian";
}

TEST(MetroPro, WithoutLateralResolutionTheSizeIsMissing) {
    const auto file = with_number(metropro_samples().at(0).content, 184, 0.0f, big);
    EXPECT_EQ(missing(channels_of(file).at(0).info).at(0), "size");
}

TEST(MetroPro, HeaderInconsistentWithItsSignatureIsRefused) {
    EXPECT_EQ(refusal(with_number<std::uint32_t>(metropro_samples().at(0).content, 6, 4096, big)),
              "file: at byte 6: MetroPro: header of format 1 and 4096 bytes, expected 1 and 834 after this signature");
}

}  // namespace
}  // namespace setae::formats::tests::metropro_test
