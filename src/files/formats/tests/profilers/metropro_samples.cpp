// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4, intensity_nx = 3, intensity_ny = 2, buckets = 2;
constexpr float scale_factor = 0.5f, wavelength = 6.328e-7f, obliquity = 1.25f, pixel = 1e-6f;

struct Dialect {
    std::uint32_t signature;
    std::uint16_t format;
    std::uint32_t header_bytes;
    std::int16_t phase_resolution;
    double steps;
    std::int16_t sign;
    bool with_intensity;
};

std::string header(const Dialect& dialect) {
    ByteBuilder bytes(std::endian::big);
    bytes.number(dialect.signature)
        .number(dialect.format)
        .number(dialect.header_bytes)
        .number<std::int16_t>(1)
        .text("Tue Jan 12 2016", 30);
    bytes.number_at<std::uint16_t>(52, dialect.with_intensity ? intensity_nx : 0)
        .number_at<std::uint16_t>(54, dialect.with_intensity ? intensity_ny : 0);
    bytes.number_at<std::uint16_t>(56, dialect.with_intensity ? buckets : 0);
    bytes.number_at<std::int16_t>(58, 0x7fff)
        .number_at<std::uint32_t>(60, dialect.with_intensity ? 2 * buckets * intensity_nx * intensity_ny : 0);
    bytes.number_at<std::uint16_t>(68, nx).number_at<std::uint16_t>(70, ny).number_at<std::uint32_t>(72, 4 * nx * ny);
    bytes.number_at<std::int32_t>(76, 1311439776).text_at(80, "step height");
    bytes.number_at(164, scale_factor).number_at(168, wavelength).number_at(176, obliquity).number_at(184, pixel);
    bytes.number_at(218, dialect.phase_resolution)
        .number_at(232, dialect.sign)
        .number_at<std::int16_t>(238, 5)
        .number_at<std::uint16_t>(242, 4711)
        .text_at(246, "10X");
    return bytes.pad_to(dialect.header_bytes).content();
}

FormatSample sample(const std::string& name, const Dialect& dialect) {
    Array2D raw = lopsided_heights(nx, ny, -1000.0);
    const double step = (dialect.sign ? -1.0 : 1.0) * static_cast<double>(scale_factor) *
                        static_cast<double>(wavelength) * static_cast<double>(obliquity) / dialect.steps;
    Array2D heights = raw * step;
    raw(2, 1) = 2147483640.0;
    raw(5, 3) = 2147483647.0;
    heights(2, 1) = heights(5, 3) = undefined;
    ByteBuilder file(std::endian::big);
    file.text(header(dialect));
    if (dialect.with_intensity)
        for (int i = 0; i < buckets * intensity_nx * intensity_ny; ++i) file.number<std::uint16_t>(0x7fff);
    file.rows<std::int32_t>(raw);
    return {.format = "metropro",
            .name = name,
            .content = file.content(),
            .shape = {nx, ny},
            .size = {nx * static_cast<double>(pixel), ny * static_cast<double>(pixel)},
            .heights = heights};
}

}  // namespace

std::vector<FormatSample> metropro_samples() {
    return {sample("version 1", {0x881b036f, 1, 834, 0, 4096.0, 0, false}),
            sample("version 2, intensities, negated", {0x881b0370, 2, 834, 1, 32768.0, 1, true}),
            sample("version 3", {0x881b0371, 3, 4096, 2, 131072.0, 0, true})};
}

}  // namespace setae::formats::tests
