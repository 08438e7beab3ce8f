// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/calibration.hpp"

#include <string>

#include <gtest/gtest.h>

#include "rendered_bar.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging::tests::calibration_test {
namespace {

/// A picture with a bar of 120 px labelled 20 nm: 1/6 nm per pixel.
constexpr double by_bar = 20e-9 / 120;

Micrograph micrograph(const FramePixels& pixels) {
    Micrograph made;
    made.pixels = pixels;
    made.file = "folder/soot.tif";
    made.name = "soot";
    return made;
}
const Micrograph& with_bar() {
    static const auto made = micrograph(picture_with_bar({}, {}));
    return made;
}
/// A bar whose label is no length.
const Micrograph& without_label() {
    static const auto made = micrograph(picture_with_bar({}, {.label = U""}));
    return made;
}
const Micrograph& without_bar() {
    static const auto made = micrograph(eight_bits(RenderedGround{}.make()));
    return made;
}
Micrograph stating(Micrograph made, double x, double y) {
    made.pixel_size = PixelSize{x, y};
    made.pixel_size_source = "DM4 calibration";
    return made;
}
Micrograph stating(Micrograph made, double size) { return stating(std::move(made), size, size); }

std::string message_of(const Micrograph& made, const CalibrationOptions& options = {}) {
    try {
        (void)calibrate(made, options);
    } catch (const InvalidArgument& error) {
        return error.what();
    }
    return "no error";
}
void expect_holds(const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

std::string codes(const Calibration& calibration) {
    std::string all;
    for (const auto& alert : calibration.alerts) all += alert.code + ' ';
    return all;
}

TEST(Calibration, PrefersTheGivenPixelSize) {
    const auto calibration =
        calibrate(stating(with_bar(), 1.004 * by_bar), {.pixel_size = PixelSize{by_bar, 1.001 * by_bar}});
    EXPECT_EQ(calibration.source, "given");
    EXPECT_DOUBLE_EQ(calibration.pixel_size.x, by_bar);
    EXPECT_DOUBLE_EQ(calibration.pixel_size.y, 1.001 * by_bar);
    EXPECT_DOUBLE_EQ(calibration.relative_standard_error, 0);
    EXPECT_EQ(codes(calibration), "");
    ASSERT_TRUE(calibration.scale_bar);
    EXPECT_DOUBLE_EQ(calibration.scale_bar->length, 120);
}

TEST(Calibration, PrefersTheFileToTheScaleBar) {
    const auto stated = calibrate(stating(with_bar(), 1.002 * by_bar, 1.5 * by_bar));  // bars give no information on y
    EXPECT_EQ(stated.source, "file: DM4 calibration");
    EXPECT_DOUBLE_EQ(stated.pixel_size.y, 1.5 * by_bar);
    EXPECT_EQ(codes(stated), "");

    const auto given = calibrate(without_label(), {.scale_bar_length = 40e-9});
    EXPECT_EQ(given.source, "scale bar 40 nm = 120.0 px");
    EXPECT_DOUBLE_EQ(given.pixel_size.x, 40e-9 / 120);
    EXPECT_DOUBLE_EQ(given.pixel_size.y, 40e-9 / 120);
    EXPECT_DOUBLE_EQ(given.relative_standard_error, 0.3 / 120);  // rounded to a pixel by the program that drew it
    EXPECT_EQ(codes(given), "");
}

TEST(Calibration, ByTheLabelOnlyRequiresConfirmation) {
    const auto read = calibrate(with_bar());
    EXPECT_EQ(read.source, "scale bar 20 nm = 120.0 px");
    EXPECT_DOUBLE_EQ(read.pixel_size.x, by_bar);
    ASSERT_EQ(codes(read), "SCALE_BAR_UNCONFIRMED ");
    EXPECT_EQ(read.alerts.front().subject, "soot");
    expect_holds(read.alerts.front().action, "in `scale_bar`: \"20 nm\"");
    EXPECT_EQ(codes(calibrate(with_bar(), {.scale_bar_length = 20e-9})), "");
}

TEST(Calibration, WithoutScaleBarUsesTheFile) {
    const auto calibration = calibrate(stating(without_bar(), 1e-10));
    EXPECT_DOUBLE_EQ(calibration.pixel_size.x, 1e-10);
    EXPECT_FALSE(calibration.scale_bar);
}

TEST(Calibration, RefusesSizesThatContradictEachOther) {
    expect_holds(message_of(stating(without_bar(), 1e-10), {.pixel_size = PixelSize{1.02e-10, 1.02e-10}}),
                 "folder/soot.tif: the given value gives 102.0 pm per pixel, the file 100.0 pm");
    expect_holds(message_of(stating(without_bar(), 1e-10, 1.02e-10), {.pixel_size = PixelSize{1e-10, 1e-10}}),
                 "the file 100.0 pm × 102.0 pm");
    expect_holds(message_of(stating(with_bar(), 1.02 * by_bar)),
                 "the file gives 170.0 pm per pixel, the scale bar of 120.0 px, read as 20 nm, 166.7 pm");
    expect_holds(message_of(stating(without_label(), by_bar), {.scale_bar_length = 40e-9}), "given as 40 nm");
    expect_holds(message_of(with_bar(), {.pixel_size = PixelSize{2e-10, 2e-10}}), "ignore_stated_pixel_size");
    expect_holds(message_of(with_bar(), {.scale_bar_length = 50e-9}),
                 "given as 50 nm, gives 416.7 pm per pixel, the scale bar of 120.0 px, read as 20 nm,");
    // within one per cent, or three standard errors of the bar
    EXPECT_EQ(message_of(stating(without_bar(), 1e-10), {.pixel_size = PixelSize{1.009e-10, 1.009e-10}}), "no error");
    EXPECT_EQ(message_of(stating(with_bar(), 1.009 * by_bar)), "no error");
}

TEST(Calibration, AllowsThreeStandardErrorsOfAShortBar) {
    // 30 px with 0.3 px: 3 % are three standard errors
    const auto made = micrograph(picture_with_bar({}, {.length = 30, .label = U""}));
    EXPECT_EQ(message_of(stating(made, 1.028 * 30e-9 / 30), {.scale_bar_length = 30e-9}), "no error");
    expect_holds(message_of(stating(made, 1.032 * 30e-9 / 30), {.scale_bar_length = 30e-9}), "scale bar of 30.0 px");
}

TEST(Calibration, UsesOptionOrScaleBarIfTheFileIsIgnored) {
    const auto by_option = calibrate(stating(without_bar(), 1e-10),
                                     {.pixel_size = PixelSize{2e-10, 2e-10}, .ignore_stated_pixel_size = true});
    EXPECT_DOUBLE_EQ(by_option.pixel_size.x, 2e-10);
    EXPECT_EQ(codes(by_option), "PIXEL_SIZE_DISAGREES ");
    const auto by_label = calibrate(stating(with_bar(), 1.3 * by_bar), {.ignore_stated_pixel_size = true});
    EXPECT_DOUBLE_EQ(by_label.pixel_size.x, by_bar);
    EXPECT_EQ(codes(by_label), "SCALE_BAR_DISAGREES ");
    const auto by_file = calibrate(stating(without_bar(), 1e-10), {.ignore_stated_pixel_size = true});
    EXPECT_DOUBLE_EQ(by_file.pixel_size.x, 1e-10);
}

TEST(Calibration, ReportsMissingInput) {
    expect_holds(message_of(without_bar()), "the file states none, and no scale bar was found; give `pixel`");
    expect_holds(message_of(without_label()),
                 "the label of the scale bar of 120.0 px at x 60, y 442 gives none (no letters next to the bar)");
    expect_holds(message_of(micrograph(picture_with_bar({}, {.label = U"5 1/nm"}))), "diffraction pattern");
    expect_holds(message_of(without_bar(), {.scale_bar_length = 5e-9}),
                 "no scale bar is found, although its length 5 nm was given");
}

TEST(Calibration, RefusesSizesThatAreNotPositive) {
    expect_holds(message_of(without_bar(), {.pixel_size = PixelSize{0, 1e-10}}), "expected positive");
    expect_holds(message_of(with_bar(), {.scale_bar_length = -5e-9}), "expected positive");
    expect_holds(message_of(stating(without_bar(), -1e-10)), "the file states a pixel size of");
}

TEST(Calibration, NamesEquallyGoodScaleBars) {
    auto picture = RenderedGround{}.make();
    RenderedBar{.label = U""}.draw(picture);
    RenderedBar{.begin_x = 300.5, .length = 90, .label = U""}.draw(picture);
    const auto made = micrograph(eight_bits(picture));
    const auto calibration = calibrate(made, {.scale_bar_length = 20e-9});
    ASSERT_EQ(codes(calibration), "SCALE_BAR_AMBIGUOUS ");
    expect_holds(calibration.alerts.front().message, "90.0 px");
    expect_holds(calibration.alerts.front().message, "120.0 px");
}

TEST(Calibration, AppliesOnlyToPicturesOfTheSameMagnification) {
    const auto calibration = calibrate(with_bar(), {.scale_bar_length = 20e-9});
    EXPECT_NO_THROW(check_same_magnification(calibration, with_bar()));
    EXPECT_NO_THROW(check_same_magnification(calibration, without_bar()));
    EXPECT_NO_THROW(check_same_magnification(calibration, stating(without_bar(), 1.009 * by_bar)));
    const auto refused = [&](const Micrograph& other) {
        try {
            check_same_magnification(calibration, other);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    expect_holds(
        refused(stating(without_bar(), 1.02 * by_bar)),
        "folder/soot.tif: the file gives 170.0 pm per pixel, the calibration (scale bar 20 nm = 120.0 px) 166.7 pm");
    expect_holds(refused(micrograph(picture_with_bar({}, {.label = U"50 nm"}))), "read as 50 nm");
}

}  // namespace
}  // namespace setae::imaging::tests::calibration_test
