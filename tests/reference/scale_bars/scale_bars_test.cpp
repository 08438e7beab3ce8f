// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/imaging/calibration.hpp"
#include "setae/imaging/frames.hpp"
#include "setae/imaging/scale_bar.hpp"

namespace setae::imaging::scale_bars_test {
namespace {

FramePixels picture(const std::filesystem::path& path) {
    const FrameSource source(path.string(), {.frame_rate = 1});
    return source.read(0).pixels;
}

TEST(ScaleBars, OfSootMatchesTheAuthors) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "tem/ExampleImage.tif");
    const auto pixels = picture(path);
    const auto bars = find_scale_bars(pixels);
    ASSERT_EQ(bars.size(), 1U);
    const auto& bar = bars.front();
    EXPECT_NEAR(bar.length, 5 * 18.0194, 0.5);
    EXPECT_LE(std::abs(bar.length - 5 * 18.0194), bar.length_standard_error);
    EXPECT_EQ(bar.label, "5 nm");
    ASSERT_TRUE(bar.labelled_length);
    EXPECT_DOUBLE_EQ(*bar.labelled_length, 5e-9);
    // the letters begin at x 19, y 470, the white line ends at x 105, y 496
    EXPECT_LE(bar.annotation.x, 15);
    EXPECT_LE(bar.annotation.y, 470);
    EXPECT_GT(bar.annotation.x + bar.annotation.width, 105);
    EXPECT_GT(bar.annotation.y + bar.annotation.height, 496);
    EXPECT_LE(bar.annotation.height, 40);

    Micrograph micrograph;
    micrograph.pixels = pixels;
    const auto calibration = calibrate(micrograph, {.scale_bar_length = 5e-9});
    EXPECT_NEAR(calibration.pixel_size.x, 1e-9 / 18.0194,
                3 * calibration.relative_standard_error * calibration.pixel_size.x);
    EXPECT_LT(calibration.relative_standard_error, 0.01);
    EXPECT_EQ(annotations(pixels).size(), 1U);
}

TEST(ScaleBars, AreNotFoundInMasks) {
    for (const auto* name : {"tem/20180529_A9_003.TIF", "tem/Case4_D8_007.TIF"}) {
        SETAE_REQUIRE_REFERENCE_DATA(path, name);
        EXPECT_TRUE(annotations(picture(path)).empty()) << name;
    }
}

}  // namespace
}  // namespace setae::imaging::scale_bars_test
