// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/scale_bar.hpp"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "rendered_bar.hpp"

namespace setae::imaging::tests::scale_bar_test {
namespace {

struct Style {
    std::string name;
    RenderedBar bar;
    double blur = 0;  // standard deviation [px]
    int jpeg = 0;     // quality; 0: no JPEG
};

/// Kinds of bars. Bars and outlines cover whole pixels unless stated otherwise.
const std::vector<Style>& styles() {
    static const std::vector<Style> all{
        {"black", {}},
        {"white", {.level = 255}},
        {"black, thin white outline", {.begin_x = 61, .outline = 1}},
        {"white, black outline", {.level = 255, .outline = 2, .outline_level = 0}},
        {"black outlined, between pixels", {.outline = 1}},
        {"ticks", {.begin_x = 61, .thickness = 3, .tick_width = 3, .tick_reach = 6, .label_y = 405}},
        {"white ticks", {.thickness = 2, .level = 255, .tick_width = 2, .tick_reach = 5, .label_y = 405}},
        {"black on a data bar", {.top = 480, .label_x = 200, .label_y = 472, .data_bar = 50}},
        {"white on a data bar",
         {.top = 480, .level = 255, .label_x = 200, .label_y = 472, .data_bar = 50, .data_bar_level = 0}},
        {"between pixels", {.begin_x = 60.2, .length = 119.7}},
        {"JPEG", {}, 0, 85},
        {"JPEG, outlined", {.begin_x = 61, .level = 255, .outline = 1, .outline_level = 0}, 0, 85},
        {"blurred", {}, 0.7},
        {"one row", {.thickness = 1}},
        {"40 rows", {.thickness = 40}},
        {"3 % of the width", {.length = 16, .thickness = 4}},
    };
    return all;
}

FramePixels rendered(const Style& style, const RenderedGround& ground) {
    auto picture = ground.make();
    style.bar.draw(picture);
    if (style.blur > 0) cv::GaussianBlur(picture, picture, {}, style.blur);
    return style.jpeg > 0 ? through_jpeg(picture, style.jpeg) : eight_bits(picture);
}

class ScaleBarsOfAllStyles : public testing::TestWithParam<std::tuple<std::size_t, double>> {};

TEST_P(ScaleBarsOfAllStyles, AreFoundToHalfAPixel) {
    const auto [index, noise] = GetParam();
    auto style = styles()[index];
    style.bar.label.clear();  // the reader is tested elsewhere
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const auto bars =
            find_scale_bars(rendered(style, {.noise = noise, .seed = seed + 10 * static_cast<unsigned>(index)}));
        ASSERT_EQ(bars.size(), 1U) << style.name;
        const auto& bar = bars.front();
        EXPECT_NEAR(bar.length, style.bar.length, 0.5) << style.name;
        EXPECT_NEAR(bar.begin_x, style.bar.begin_x, 0.5) << style.name;
        EXPECT_NEAR(bar.y, style.bar.top + 0.5 * (style.bar.thickness - 1), 0.6) << style.name;
        EXPECT_LE(std::abs(bar.length - style.bar.length), 2 * bar.length_standard_error) << style.name;
        EXPECT_GE(bar.length_standard_error, 0.3) << style.name;
        EXPECT_FALSE(bar.labelled_length) << style.name;
    }
}
INSTANTIATE_TEST_SUITE_P(Noise, ScaleBarsOfAllStyles,
                         testing::Combine(testing::Range<std::size_t>(0, 16), testing::Values(0.0, 10.0, 25.0)));

TEST(ScaleBars, AreFoundInStrongNoise) {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        auto picture = RenderedGround{.noise = 0, .seed = seed}.make();
        RenderedBar{.level = seed % 2 == 0 ? 0.0 : 255.0, .label = U""}.draw(picture);
        std::mt19937_64 generator(seed);
        std::normal_distribution<float> normal(0.0f, 10.0f);
        for (auto& level : picture) level += normal(generator);
        const auto bars = find_scale_bars(eight_bits(picture));
        ASSERT_EQ(bars.size(), 1U) << seed;
        EXPECT_NEAR(bars.front().length, 120, 0.5);
    }
}

TEST(ScaleBars, OfWholePixelsAreExact) {
    for (int length = 20; length < 320; length += 61) {
        const auto bars = find_scale_bars(
            picture_with_bar({.noise = 15, .seed = static_cast<unsigned>(length)},
                             {.begin_x = 30.5, .length = static_cast<double>(length), .top = 300, .label = U""}));
        ASSERT_EQ(bars.size(), 1U);
        EXPECT_DOUBLE_EQ(bars.front().begin_x, 30.5);
        EXPECT_DOUBLE_EQ(bars.front().length, length);
        EXPECT_DOUBLE_EQ(bars.front().length_standard_error, 0.3);
    }
}

TEST(ScaleBars, HaveSubpixelEndsOnUniformBackground) {
    // without texture the covered share of the last pixel is determined to a grey level in 150: 0.01 px, and the steps
    // of 0.05 px
    for (const double begin : {60.1, 60.25, 60.8}) {
        const auto bars = find_scale_bars(picture_with_bar({.vacuum = 150, .sample = 150, .layers = 0, .noise = 0},
                                                           {.begin_x = begin, .length = 100.3, .label = U""}));
        ASSERT_EQ(bars.size(), 1U);
        EXPECT_NEAR(bars.front().length, 100.3, 0.08);
    }
}

TEST(ScaleBars, AreFoundAnywhereInAPictureOfAnyDepth) {
    for (const int left : {4, 200, 375})
        for (const int top : {4, 250, 500}) {
            const RenderedGround ground{.seed = static_cast<unsigned>(left + top)};
            const FramePixels pixels =
                picture_with_bar(ground, {.begin_x = left + 0.5, .length = 130, .top = top, .label = U""}) * 17.0f +
                300.0f;
            const auto bars = find_scale_bars(pixels);
            ASSERT_EQ(bars.size(), 1U) << left << ' ' << top;
            EXPECT_DOUBLE_EQ(bars.front().length, 130);
        }
}

/// Grey level at x, y of a picture without a bar; k from 1 to 20 varies it.
struct Barless {
    std::string name;
    std::function<double(double x, double y, int k, double noise)> level;  // noise: standard normal
};

const std::vector<Barless>& barless() {
    static const auto fringe = [](double y, int k) { return 128 + 60 * std::cos(2 * CV_PI * y / (2.5 + 0.9 * k)); };
    static const std::vector<Barless> all{
        {"one level", [](double, double, int k, double) { return 12.0 * k; }},
        {"noise", [](double, double, int k, double noise) { return 128 + 2 * k * noise; }},
        {"fringes along rows", [](double, double y, int k, double noise) { return fringe(y, k) + k * noise; }},
        {"a grain with fringes",
         [](double x, double y, int k, double noise) {
             return (x > 60 && x < 190 && y > 80 && y < 200 ? fringe(y, k) : 128.0) + 0.5 * (k - 1) * noise;
         }},
        {"the edge of a foil, tilted a little, with a bright fringe",
         [](double x, double y, int k, double noise) {
             const double distance = y - 120 - 0.002 * (k - 1) * x;
             return (distance > 0 ? 90.0 : 150.0) + 60 * std::exp(-0.5 * distance * distance / 4) + 2 * (k - 1) * noise;
         }},
        {"a line across a mask",
         [](double x, double y, int k, double) { return std::abs(y - 120 - 0.002 * (k - 1) * x) < 2 ? 255.0 : 0.0; }},
        {"a mask of particles",
         [](double x, double y, int k, double) {
             return std::hypot(x - 100 - 3 * k, y - 120) < 20 + k || std::hypot(x - 160, y - 90 - k) < 30 ? 255.0 : 0.0;
         }},
    };
    return all;
}

class PicturesWithoutScaleBar : public testing::TestWithParam<std::size_t> {};

TEST_P(PicturesWithoutScaleBar, HaveNone) {
    constexpr long size = 256;
    const auto& picture = barless()[GetParam()];
    for (int k = 1; k <= 20; ++k) {
        std::mt19937_64 generator(static_cast<unsigned>(k));
        std::normal_distribution<double> normal;
        FramePixels pixels(size, size);
        for (long y = 0; y < size; ++y)
            for (long x = 0; x < size; ++x)
                pixels(y, x) = static_cast<float>(
                    picture.level(static_cast<double>(x), static_cast<double>(y), k, normal(generator)));
        EXPECT_TRUE(find_scale_bars(pixels).empty()) << picture.name << ' ' << k;
    }
}
INSTANTIATE_TEST_SUITE_P(Kinds, PicturesWithoutScaleBar, testing::Range<std::size_t>(0, 7));

TEST(ScaleBars, AreNotFoundInSamples) {
    for (unsigned seed = 1; seed <= 20; ++seed)
        EXPECT_TRUE(
            find_scale_bars(
                eight_bits(RenderedGround{.width = 256, .height = 256, .noise = 2.0 * (seed - 1), .seed = seed}.make()))
                .empty())
            << seed;
}

TEST(ScaleBars, AreNotFoundInStreaks) {
    for (unsigned seed = 1; seed <= 10; ++seed) {
        std::mt19937_64 generator(seed);
        std::normal_distribution<float> normal;
        cv::Mat1f noise(512, 512), streaks, mask;
        for (auto& level : noise) level = normal(generator);
        cv::GaussianBlur(noise, streaks, {}, 6.0, 0.7);
        EXPECT_TRUE(find_scale_bars(eight_bits(cv::Mat1f(128 + 200 * streaks))).empty()) << seed;
        cv::GaussianBlur(noise, streaks, {}, 30.0, 3.0);
        cv::threshold(streaks, mask, 0.0, 255.0, cv::THRESH_BINARY);
        EXPECT_TRUE(find_scale_bars(eight_bits(mask)).empty()) << seed;
    }
}

struct Labelled {
    std::u32string label;
    std::string text;
    double length;
};

class LabelsOfScaleBars : public testing::TestWithParam<Labelled> {};

TEST_P(LabelsOfScaleBars, AreRead) {
    const auto& expected = GetParam();
    const auto bars = find_scale_bars(picture_with_bar({}, {.label = expected.label}));
    ASSERT_EQ(bars.size(), 1U);
    EXPECT_EQ(bars.front().label, expected.text);
    ASSERT_TRUE(bars.front().labelled_length) << expected.text;
    EXPECT_DOUBLE_EQ(*bars.front().labelled_length, expected.length);
}
INSTANTIATE_TEST_SUITE_P(Units, LabelsOfScaleBars,
                         testing::Values(Labelled{U"5 nm", "5 nm", 5e-9}, Labelled{U"200nm", "200 nm", 200e-9},
                                         Labelled{U"0.5 \u00b5m", "0.5 µm", 0.5e-6}, Labelled{U"2 um", "2 µm", 2e-6},
                                         Labelled{U"5 \u00c5", "5 Å", 5e-10}, Labelled{U"500 pm", "500 pm", 500e-12},
                                         Labelled{U"1 mm", "1 mm", 1e-3}, Labelled{U"2.5 nm", "2.5 nm", 2.5e-9}));

TEST(ScaleBars, HaveLabelsAboveBelowOrNextToThem) {
    for (const auto& [x, y] : std::vector<std::pair<int, int>>{{70, 408}, {70, 450}, {200, 432}}) {
        const auto bars = find_scale_bars(picture_with_bar({}, {.label = U"20 nm", .label_x = x, .label_y = y}));
        ASSERT_EQ(bars.size(), 1U);
        ASSERT_TRUE(bars.front().labelled_length) << x << ' ' << y << ' ' << bars.front().label;
        EXPECT_DOUBLE_EQ(*bars.front().labelled_length, 20e-9);
        const auto& region = bars.front().annotation;
        EXPECT_LE(region.x, 61);
        EXPECT_LE(region.y, std::min(440, y + 6));
        EXPECT_GE(region.x + region.width, std::max(181, x + 50));
        EXPECT_GE(region.y + region.height, std::max(446, y + 18));
    }
}

TEST(ScaleBars, GiveNoLengthForInvalidLabels) {
    for (const std::u32string label : {U"5 1/nm", U"3 nm", U"52", U"nm"}) {
        const auto bars = find_scale_bars(picture_with_bar({}, {.label = label}));
        ASSERT_EQ(bars.size(), 1U);
        EXPECT_FALSE(bars.front().labelled_length) << bars.front().label;
    }
}

TEST(ScaleBars, AreNeverReadWithAWrongLengthInNoise) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const auto bars = find_scale_bars(picture_with_bar({.noise = 30, .seed = seed}, {.label = U"0.5 \u00b5m"}));
        ASSERT_EQ(bars.size(), 1U);
        EXPECT_DOUBLE_EQ(bars.front().labelled_length.value_or(0.5e-6), 0.5e-6) << bars.front().label;
    }
}

TEST(ScaleBars, HaveNoLabelWithoutTesseractData) {
    const char* before = std::getenv("TESSDATA_PREFIX");
    const std::string kept = before ? before : "";
    setenv("TESSDATA_PREFIX", "/nonexistent", 1);
    testing::internal::CaptureStderr();
    const auto bars = find_scale_bars(picture_with_bar({}, {}));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    if (before) setenv("TESSDATA_PREFIX", kept.c_str(), 1);
    else unsetenv("TESSDATA_PREFIX");
    ASSERT_EQ(bars.size(), 1U);
    EXPECT_EQ(bars.front().label, "");
    EXPECT_FALSE(bars.front().labelled_length);
    EXPECT_DOUBLE_EQ(bars.front().length, 120);
}

TEST(ScaleBars, JoinTwoHalvesAroundTheLabel) {
    auto picture = RenderedGround{}.make();
    RenderedBar left{.begin_x = 200.5,
                     .length = 60,
                     .top = 480,
                     .thickness = 3,
                     .level = 255,
                     .label = U"",
                     .data_bar = 50,
                     .data_bar_level = 0};
    RenderedBar right{.begin_x = 340.5,
                      .length = 60,
                      .top = 480,
                      .thickness = 3,
                      .level = 255,
                      .label = U"200 nm",
                      .label_x = 266,
                      .label_y = 470};
    left.draw(picture);
    right.draw(picture);
    const auto bars = find_scale_bars(eight_bits(picture));
    ASSERT_EQ(bars.size(), 1U);
    EXPECT_DOUBLE_EQ(bars.front().length, 200);
    ASSERT_TRUE(bars.front().labelled_length) << bars.front().label;
    EXPECT_DOUBLE_EQ(*bars.front().labelled_length, 200e-9);
}

TEST(ScaleBars, AreReproducible) {
    const auto pixels = picture_with_bar({.noise = 25}, {});
    const auto first = find_scale_bars(pixels), second = find_scale_bars(pixels);
    ASSERT_EQ(first.size(), 1U);
    ASSERT_EQ(second.size(), 1U);
    EXPECT_EQ(first.front().label, second.front().label);
    EXPECT_EQ(first.front().length, second.front().length);
    EXPECT_EQ(first.front().confidence, second.front().confidence);
}

bool holds(const std::vector<PictureRegion>& regions, const PictureRegion& part) {
    for (const auto& region : regions)
        if (region.x <= part.x && region.y <= part.y && region.x + region.width >= part.x + part.width &&
            region.y + region.height >= part.y + part.height)
            return true;
    return false;
}

TEST(Annotations, ContainScaleBarsLabelsAndDataBars) {
    EXPECT_TRUE(holds(annotations(picture_with_bar({}, {})), {61, 412, 120, 34}));
    const auto on_data_bar =
        annotations(picture_with_bar({}, {.top = 480, .label_x = 200, .label_y = 472, .data_bar = 50}));
    EXPECT_TRUE(holds(on_data_bar, {0, 462, 512, 50}));
    EXPECT_FALSE(holds(on_data_bar, {0, 455, 512, 50}));
}

TEST(Annotations, ContainDrawnText) {
    auto picture = RenderedGround{}.make();
    RenderedBar::write(picture, U"20 nm 512 AA", 300, 20, 1.0, 255);
    const auto regions = annotations(eight_bits(picture));
    ASSERT_EQ(regions.size(), 1U);
    EXPECT_TRUE(holds(regions, {302, 25, 120, 13}));
    EXPECT_LT(regions.front().height, 40);
}

TEST(Annotations, AreEmptyForVacuumMasksAndFoils) {
    EXPECT_TRUE(annotations(eight_bits(RenderedGround{}.make())).empty());
    EXPECT_TRUE(annotations(eight_bits(RenderedGround{.noise = 0}.make())).empty());
    FramePixels foil = FramePixels::Constant(300, 300, 200.0f);
    foil.bottomRows(60).setConstant(80.0f);
    EXPECT_TRUE(annotations(foil).empty());
    FramePixels mask = FramePixels::Zero(300, 300);
    for (long y = 0; y < 300; ++y)
        for (long x = 0; x < 300; ++x)
            if (std::hypot(static_cast<double>(x % 60) - 30, static_cast<double>(y % 100) - 50) < 14) mask(y, x) = 255;
    EXPECT_TRUE(annotations(mask).empty());
}

}  // namespace
}  // namespace setae::imaging::tests::scale_bar_test
