// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/calibration_file.hpp"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "recordings.hpp"
#include "setae/bytes/digest.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging::tests::calibration_file_test {
namespace {

KeptCalibration example() {
    KeptCalibration kept;
    kept.calibration = {.pixel_size = {5e-9 / 90, 5e-9 / 89.7},
                        .relative_standard_error = 0.65 / 90,
                        .source = "scale bar 5 nm = 90.0 px",
                        .scale_bar = ScaleBar{.begin_x = 15,
                                              .end_x = 105,
                                              .y = 492.5,
                                              .thickness = 7,
                                              .length = 90,
                                              .length_standard_error = 0.65,
                                              .label = "5 nm",
                                              .labelled_length = 5e-9,
                                              .annotation = {12, 467, 97, 33},
                                              .confidence = 0.9},
                        .alerts = {{"SCALE_BAR_UNCONFIRMED", "soot", "the label was read as '5 nm'", "confirm it"}}};
    kept.picture = "soot \u00b5.tif";
    kept.picture_sha256 = bytes::sha256("bytes");
    return kept;
}

TEST(CalibrationFile, PreservesEveryNumberToTheLastBit) {
    const Folder folder;
    const auto path = folder / "calibration.json";
    const auto kept = example();
    write_calibration(path, kept);
    const auto read = read_calibration(path);
    EXPECT_EQ(read.calibration.pixel_size.x, kept.calibration.pixel_size.x);
    EXPECT_EQ(read.calibration.pixel_size.y, kept.calibration.pixel_size.y);
    EXPECT_EQ(read.calibration.relative_standard_error, kept.calibration.relative_standard_error);
    EXPECT_EQ(read.calibration.source, kept.calibration.source);
    EXPECT_EQ(read.calibration.alerts, kept.calibration.alerts);
    EXPECT_EQ(read.picture, kept.picture);
    EXPECT_EQ(read.picture_sha256, kept.picture_sha256);
    ASSERT_TRUE(read.calibration.scale_bar);
    const auto &bar = *read.calibration.scale_bar, &written = *kept.calibration.scale_bar;
    EXPECT_EQ(bar.begin_x, written.begin_x);
    EXPECT_EQ(bar.end_x, written.end_x);
    EXPECT_EQ(bar.y, written.y);
    EXPECT_EQ(bar.thickness, written.thickness);
    EXPECT_EQ(bar.length, written.length);
    EXPECT_EQ(bar.length_standard_error, written.length_standard_error);
    EXPECT_EQ(bar.label, written.label);
    EXPECT_EQ(bar.labelled_length, written.labelled_length);
    EXPECT_EQ(bar.annotation.y, written.annotation.y);
    EXPECT_EQ(bar.annotation.width, written.annotation.width);
    EXPECT_EQ(bar.confidence, written.confidence);
    const auto bytes = bytes::read_file(path);
    write_calibration(path, read);
    EXPECT_EQ(bytes::read_file(path), bytes);
}

TEST(CalibrationFile, DoesNotRequireAScaleBar) {
    const Folder folder;
    auto kept = example();
    kept.calibration.scale_bar.reset();
    write_calibration(folder / "c.json", kept);
    EXPECT_FALSE(read_calibration(folder / "c.json").calibration.scale_bar);
    kept = example();
    kept.calibration.scale_bar->labelled_length.reset();
    write_calibration(folder / "c.json", kept);
    EXPECT_FALSE(read_calibration(folder / "c.json").calibration.scale_bar->labelled_length);
}

TEST(CalibrationFile, NamesItsPicture) {
    const Folder folder;
    write_bytes(folder / "soot.tif", "bytes");
    const auto kept = kept_calibration(example().calibration, folder / "soot.tif");
    EXPECT_EQ(kept.picture, "soot.tif");
    EXPECT_EQ(kept.picture_sha256, bytes::sha256("bytes"));
    EXPECT_THROW((void)kept_calibration(example().calibration, folder / "missing.tif"), FileError);
    EXPECT_THROW(write_calibration(folder / "missing" + "/c.json", kept), FileError);
}

TEST(CalibrationFile, ErrorsNameFileAndKey) {
    const Folder folder;
    const auto path = folder / "c.json";
    write_calibration(path, example());
    const auto text = bytes::read_file(path);
    const auto message_after = [&](const std::string& from, const std::string& to) {
        auto changed = text;
        const auto at = changed.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        changed.replace(at, from.size(), to);
        write_bytes(path, changed);
        try {
            (void)read_calibration(path);
        } catch (const FormatError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with(path)) << error.what();
            return std::string(error.what());
        }
        return std::string("no error");
    };
    const auto expect_holds = [](const std::string& message, const std::string& part) {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };
    expect_holds(message_after("\"source\"", "\"sorce\""), "'source': missing");
    expect_holds(message_after("\"source\"", "\"relative_standard_eror\": 1, \"source\""),
                 "'relative_standard_eror': unknown key; did you mean 'relative_standard_error'?");
    expect_holds(message_after("\"length_px\"", "\"lenght_px\": 1, \"length_px\""),
                 "'scale_bar.lenght_px': unknown key; did you mean 'length_px'?");
    expect_holds(message_after("\"setae_calibration\": 1", "\"setae_calibration\": 2"),
                 "'setae_calibration': version 2, expected 1");
    expect_holds(message_after("\"relative_standard_error\": ", "\"relative_standard_error\": -"),
                 "'relative_standard_error': -0.00722222, expected a number >= 0");
    expect_holds(message_after("\"pixel_size_x_m\": ", "\"pixel_size_x_m\": -"), "'pixel_size_x_m'");
    expect_holds(message_after("\"label\": \"5 nm\"", "\"label\": 5"), "'scale_bar.label': 5, expected text");
    expect_holds(message_after("\"code\"", "\"cod\""), "'alerts[0].code': missing");
    expect_holds(message_after("\"sha256\": \"", "\"sha256\": \"x"),
                 "'picture.sha256': expected 64 hexadecimal digits");
    expect_holds(message_after("{", "{,"), "not valid JSON");
    write_bytes(path, "[]");
    EXPECT_THROW((void)read_calibration(path), FormatError);
    EXPECT_THROW((void)read_calibration(folder / "none.json"), FileError);
}

}  // namespace
}  // namespace setae::imaging::tests::calibration_file_test
