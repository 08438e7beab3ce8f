// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of rulings drawn here: scale, aspect and distortion agree with the known input.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/imaging/stage_micrometer.hpp"

namespace setae::imaging::stage_micrometer_test {
namespace {

struct Camera {
    double width = 1.8e-6, height = 1.8e-6;  ///< of a pixel [m]
    double angle = 0.02;                     ///< of the ruling in the picture [rad]
    double distortion = 0.0;                 ///< at the corners
    double noise = 4.0;                      ///< grey levels, of a contrast of 120
    bool lying = false, grid = false;
    double line_error = 0.0;  ///< of the place of each line [m]
    unsigned seed = 1;
};

/// 640 × 480 pixels of lines 20 µm apart, a quarter of each period dark; light decreases towards the corners.
FramePixels picture_of(const Camera& camera) {
    constexpr long columns = 640, rows = 480;
    constexpr double pitch = 20e-6;
    std::mt19937_64 engine(camera.seed);
    std::normal_distribution<double> normal;
    std::vector<double> errors(400);
    for (auto& error : errors) error = camera.line_error * normal(engine);
    const double corner = 0.5 * std::hypot(columns - 1, rows - 1);
    // coverage of a pixel by the dark quarter of a period, blurred by one pixel
    const auto dark = [&](double place) {
        const double line = std::round(place / pitch);
        const double distance =
            std::abs(place - line * pitch - errors[static_cast<std::size_t>(line + 200.0)]) - pitch / 8.0;
        return 0.5 * std::erfc(distance / (1.8e-6 * std::sqrt(2.0)));
    };
    FramePixels pixels(rows, columns);
    for (long row = 0; row < rows; ++row)
        for (long column = 0; column < columns; ++column) {
            const double x = static_cast<double>(column) - 0.5 * (columns - 1),
                         y = static_cast<double>(row) - 0.5 * (rows - 1), r = std::hypot(x, y) / corner;
            const double stretch = 1.0 + camera.distortion * r * r, u = x * camera.width * stretch,
                         v = y * camera.height * stretch;
            const double across = u * std::cos(camera.angle) + v * std::sin(camera.angle) + 0.3e-6,
                         along = v * std::cos(camera.angle) - u * std::sin(camera.angle) + 5.1e-6;
            const double covered =
                camera.grid ? std::max(dark(across), dark(along)) : dark(camera.lying ? along : across);
            pixels(row, column) =
                static_cast<float>(std::round(170.0 - 30.0 * r * r - 120.0 * covered + camera.noise * normal(engine)));
        }
    return pixels;
}

const Estimate pitch{.value = 20e-6, .standard_error = 0.0};

TEST(StageMicrometer, MeasuresThePixelSizeOfARotatedRuling) {
    for (const double angle : {0.0, 0.02, -0.08}) {
        const auto scale = camera_scale(std::vector<FramePixels>{picture_of({.angle = angle})}, pitch);
        ASSERT_TRUE(scale.across_x);
        EXPECT_FALSE(scale.across_y);
        EXPECT_FALSE(scale.aspect);
        EXPECT_NEAR(scale.pixel_size.value / 1.8e-6, 1.0, 1e-4) << angle;
        EXPECT_LT(scale.pixel_size.standard_error / 1.8e-6, 1e-4);
        EXPECT_NEAR(scale.across_x->angle, angle, 1e-3);
        EXPECT_GE(scale.across_x->lines, 50);
    }
}

TEST(StageMicrometer, MeasuresThePixelAspectFromTwoPicturesOrAGrid) {
    const Camera camera{.width = 1.8e-6, .height = 1.85e-6};
    auto lying = camera;
    lying.lying = true;
    auto grid = camera;
    grid.grid = true;
    for (const auto& pictures : {std::vector<FramePixels>{picture_of(camera), picture_of(lying)},
                                 std::vector<FramePixels>{picture_of(grid)}}) {
        const auto scale = camera_scale(pictures, pitch);
        ASSERT_TRUE(scale.aspect);
        EXPECT_NEAR(scale.aspect->value, 1.85 / 1.8, 3e-4);
        EXPECT_NEAR(scale.across_x->pixel_size.value / 1.80e-6, 1.0, 2e-4);
        EXPECT_NEAR(scale.across_y->pixel_size.value / 1.85e-6, 1.0, 2e-4);
    }
}

TEST(StageMicrometer, MeasuresRadialDistortion) {
    for (const double distortion : {-0.01, 0.004}) {
        const auto scale = camera_scale(std::vector<FramePixels>{picture_of({.distortion = distortion})}, pitch);
        EXPECT_NEAR(scale.across_x->distortion.value, distortion, 5e-4);
        EXPECT_LT(scale.across_x->probability, 1e-3);
        EXPECT_NEAR(scale.pixel_size.value / 1.8e-6, 1.0, 3e-4);
    }
}

TEST(StageMicrometer, StandardErrorsCoverTrueValuesForUnevenRulings) {
    int size = 0, distortion = 0;
    constexpr int pictures = 60;
    for (int i = 0; i < pictures; ++i) {
        const auto scale = camera_scale(
            std::vector<FramePixels>{picture_of({.line_error = 0.3e-6, .seed = 100U + static_cast<unsigned>(i)})},
            pitch);
        const auto held = [](const Estimate& e, double truth) {
            const auto interval = *interval_of(e);
            return interval.lower <= truth && truth <= interval.upper ? 1 : 0;
        };
        size += held(scale.pixel_size, 1.8e-6);
        distortion += held(scale.across_x->distortion, 0.0);
    }
    EXPECT_GE(size, 0.86 * pictures);
    EXPECT_GE(distortion, 0.86 * pictures);
    EXPECT_LE(size + distortion, 2 * pictures - 1);
}

TEST(StageMicrometer, ReportsOneRulingForInclinedLines) {
    // in projection, inclined lines have a larger distance
    for (const double angle : {0.03, 0.06, 0.12}) {
        const auto scale = camera_scale(std::vector<FramePixels>{picture_of({.angle = angle, .noise = 1.0})}, pitch);
        EXPECT_TRUE(scale.across_x);
        EXPECT_FALSE(scale.across_y) << angle;
    }
}

TEST(StageMicrometer, PropagatesTheErrorOfTheRuling) {
    const auto scale =
        camera_scale(std::vector<FramePixels>{picture_of({})}, {.value = 20e-6, .standard_error = 0.1e-6});
    EXPECT_NEAR(scale.pixel_size.standard_error / scale.pixel_size.value, 0.005, 1e-4);
}

TEST(StageMicrometer, RefusesPicturesWithoutLines) {
    std::mt19937_64 engine(3);
    std::normal_distribution<float> normal(120.0F, 10.0F);
    FramePixels noise(240, 320);
    for (auto& pixel : noise.reshaped()) pixel = normal(engine);
    EXPECT_THROW((void)camera_scale(std::vector<FramePixels>{noise}, pitch), UndefinedDataError);
    EXPECT_THROW((void)camera_scale(std::vector<FramePixels>{}, pitch), InvalidArgument);
    EXPECT_THROW((void)camera_scale(std::vector<FramePixels>{picture_of({}), noise}, pitch), InvalidArgument);
    EXPECT_THROW((void)camera_scale(std::vector<FramePixels>{picture_of({})}, Estimate{.value = 0.0}), InvalidArgument);
}

}  // namespace
}  // namespace setae::imaging::stage_micrometer_test
