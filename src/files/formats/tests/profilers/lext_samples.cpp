// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "tiff_builder.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 5;
constexpr double per_x = 125000.5, per_y = 250000.0, per_z = 10000.0;  // pm
constexpr double calibration_x = 1.001, calibration_y = 0.998, calibration_z = 1.002;

std::string description() {
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?><TiffTagDescData xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"><HeightInfo><HeightDataPerPixelX>{}</HeightDataPerPixelX>"
        "<HeightDataUnitX>2</HeightDataUnitX><HeightDataPerPixelY>{}</HeightDataPerPixelY><HeightDataUnitY>2</HeightDataUnitY><HeightDataPerPixelZ>{}</HeightDataPerPixelZ><HeightDataUnitZ>2</HeightDataUnitZ>"
        "</HeightInfo></TiffTagDescData>",
        per_x, per_y, per_z);
}

std::string settings() {
    return fmt::format(
        "<ExifTagDescData><ImageCommonSettingsInfo><MakerCalibrationValueX>{}</MakerCalibrationValueX><MakerCalibrationValueY>{}</MakerCalibrationValueY><MakerCalibrationValueZ>{}"
        "</MakerCalibrationValueZ></ImageCommonSettingsInfo></ExifTagDescData>",
        calibration_x, calibration_y, calibration_z);
}

/// An Exif directory of one entry, put after the file; the pointer of the first page is set to it.
std::string with_exif(std::string file, std::uint32_t placeholder) {
    ByteBuilder directory;
    const auto xml = settings();
    const auto text_at = static_cast<std::uint32_t>(file.size()),
               at = static_cast<std::uint32_t>(text_at + xml.size() + xml.size() % 2);
    ByteBuilder pointer, wanted;
    pointer.number(at);
    wanted.number(placeholder);
    file.replace(file.find(wanted.content()), 4, pointer.content());
    directory.text(xml)
        .pad_to(xml.size() + xml.size() % 2)
        .number<std::uint16_t>(1)
        .number<std::uint16_t>(0xa40b)
        .number<std::uint16_t>(7)
        .number(static_cast<std::uint32_t>(xml.size()))
        .number(text_at)
        .number<std::uint32_t>(0);
    return file + directory.content();
}

FormatSample sample(const char* name, bool calibrated, bool compressed) {
    constexpr auto order = std::endian::little;
    constexpr std::uint32_t placeholder = 0x7ab1c0de;
    const Array2D raw = lopsided_heights(nx, ny, 40.0);
    TiffPageBuilder first(order), thumbnail(order), intensity(order), height(order);
    first.picture(2, 2, 8, 1)
        .strips(2, {std::string(4, 'x')})
        .text(270, description())
        .text(271, "OLYMPUS")
        .text(272, "OLS4100")
        .text(306, "2013:03:18 10:21:00");
    if (calibrated) first.longs(34665, {placeholder});
    thumbnail.picture(2, 2, 8, 1).strips(2, {std::string(4, 'x')}).text(270, "THUMBNAIL");
    intensity.picture(nx, ny, 16, 1).strips(ny, {std::string(2 * nx * ny, 'x')}).text(270, "INTENSITY");
    auto rows = ByteBuilder(order).rows<std::uint16_t>(raw).content();
    if (compressed) {
        std::string packed(compressBound(rows.size()), '\0');
        uLongf size = packed.size();
        compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
                 rows.size());
        rows = packed.substr(0, size);
    }
    height.picture(nx, ny, 16, 1, compressed ? 8 : 1).strips(ny, {rows}).text(270, "HEIGHT");
    auto content = tiff_file(order, {first, thumbnail, intensity, height});
    if (calibrated) content = with_exif(std::move(content), placeholder);
    const double x = calibrated ? calibration_x : 1.0, y = calibrated ? calibration_y : 1.0,
                 z = calibrated ? calibration_z : 1.0;
    return {.format = "lext",
            .name = name,
            .content = std::move(content),
            .channel = 1,
            .shape = {nx, ny},
            .size = {nx * per_x * x * 1e-12, ny * per_y * y * 1e-12},
            .heights = raw * (per_z * z * 1e-12)};
}

}  // namespace

std::vector<FormatSample> lext_samples() {
    return {sample("calibrated", true, false), sample("without device settings", false, false),
            sample("compressed", true, true)};
}

}  // namespace setae::formats::tests
