// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "patched_sample.hpp"

// Files of TrueMap, KLA Zeta and OmniSurf3D: short headers before one map.
namespace setae::formats::tests::plain_profilers_test {
namespace {

TEST(TrueMap, UnitIsAssumedWithAWarning) {
    const auto info = channels_of(tmd_samples().at(0).content).at(0).info;
    EXPECT_EQ(info.unit, "mm");
    ASSERT_EQ(info.alerts.size(), 1u);
    EXPECT_EQ(info.alerts[0].code, "UNIT_ASSUMED");
    EXPECT_EQ(info.metadata.attributes.at("comment"), "Created by TrueMap v6");
}

TEST(TrueMap, GivenUnitAppliesToLengthsAndHeights) {
    const auto file = tmd_samples().at(0).content;
    const auto assumed = map_of(channels_of(file).at(0)),
               given = map_of(channels_of(file, {.size = {}, .unit = "um"}).at(0));
    EXPECT_NEAR(given.heights(1, 1) / assumed.heights(1, 1), 1e-3, 1e-15);
    EXPECT_NEAR(given.size[0] / assumed.size[0], 1e-3, 1e-15);
    EXPECT_TRUE(channels_of(file, {.size = {}, .unit = "um"}).at(0).info.alerts.empty());
}

TEST(TrueMap, CommentWithoutEndIsRefused) {
    EXPECT_NE(refusal("Binary TrueMap Data File v2.0\r\n" + std::string(1, '\0') + std::string(5000, 'c'))
                  .find("does not end within 4096 bytes"),
              std::string::npos);
}

TEST(Zmg, HeightsAboveHalfTheRangeDoNotWrap) {
    const auto sample = zmg_samples().at(0);
    const auto map =
        map_of(channels_of(with_number<std::uint16_t>(sample.content, sample.content.size() - 2, 40000)).at(0));
    EXPECT_NEAR(map.heights(6, 3), 40000 * 0.0625e-6, 1e-15);
}

TEST(Zmg, KeepsRecipeAndComment) {
    const auto metadata = channels_of(zmg_samples().at(1).content).at(0).info.metadata;
    EXPECT_EQ(metadata.attributes.at("recipe"), "bump recipe");
    EXPECT_EQ(metadata.attributes.at("comment"), "measured twice");
    EXPECT_EQ(metadata.instrument.name, "KLA Zeta");
}

TEST(Zmg, InvalidStepsAreRefused) {
    EXPECT_NE(refusal(with_number(zmg_samples().at(0).content, 97, -1.0f)).find("`size`"), std::string::npos);
}

TEST(OmniSurf3d, ReadsMetadataOfTheHeader) {
    const auto metadata = channels_of(os3d_samples().at(0).content).at(0).info.metadata;
    EXPECT_EQ(metadata.acquisition_time, "20180321T101500");
    EXPECT_EQ(metadata.attributes.at("identification"), "pen");
    EXPECT_EQ(metadata.attributes.at("origin"), "3 4 µm");
    EXPECT_EQ(metadata.attributes.at("format_version"), "1.1");
}

TEST(OmniSurf3d, TextOfNegativeLengthIsRefused) {
    EXPECT_EQ(refusal(with_number<std::int32_t>(os3d_samples().at(0).content, 18, -1)),
              "file: at byte 18: OmniSurf3D: a text of -1 bytes, expected 0 to 65536; the file is damaged");
}

}  // namespace
}  // namespace setae::formats::tests::plain_profilers_test
