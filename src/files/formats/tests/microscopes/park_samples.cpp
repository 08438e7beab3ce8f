// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "tiff_builder.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr double gain = -2.5, scale = 0.5, offset = 12.0;

std::string wide(const std::string& text, std::size_t characters) {
    ByteBuilder builder;
    for (std::size_t k = 0; k < characters; ++k)
        builder.number<std::uint16_t>(k < text.size() ? static_cast<unsigned char>(text[k]) : 0);
    return builder.content();
}

/// The header as psia's documentation of 2006 lists it, and what version 2 appends.
std::string header(int version, std::uint32_t data_type, const std::string& unit) {
    ByteBuilder builder;
    const auto word = [&](std::uint32_t value) { builder.number(value); };
    const auto real = [&](double value) { builder.number(value); };
    word(0);
    builder.text(wide("Z Height", 32)).text(wide("NCM", 8));
    real(1.0), word(0), word(0), word(nx), word(ny), real(45.0), word(0), real(0.05), word(1), word(0), word(0);
    real(0.7), real(0.4), real(0.0), real(0.0), real(1.0), real(3.0);
    builder.text(wide("nm", 8));
    real(0.0), real(0.0), real(gain), real(scale), real(offset);
    builder.text(wide(unit, 8));
    word(0), word(100), word(50), word(0), word(0), word(1);
    if (version == 1) return builder.pad_to(356).content();
    real(1.0), real(20.0);
    for (int k = 0; k < 3; ++k) builder.text(wide("High", 8));
    word(data_type), word(0), word(0), real(10.0), real(3e5), real(0.0);
    return builder.text(wide("AC160TS", 16)).pad_to(580).content();
}

template <class Value>
FormatSample sample(const char* name, int version, std::uint32_t data_type) {
    const Array2D raw = lopsided_heights(nx, ny, 3.0);
    ByteBuilder samples;
    samples.rows<Value>(raw.rowwise().reverse());
    TiffPageBuilder page(std::endian::little);
    page.picture(2, 2, 8, 1).strips(2, {std::string(4, 'x')});
    page.longs(50432, {0x0E031301u})
        .longs(50433, {version == 1 ? 0x1000001u : 0x1000002u})
        .bytes(50434, samples.content(), 1)
        .bytes(50435, header(version, data_type, "nm"));
    return {.format = "park",
            .name = name,
            .content = tiff_file(std::endian::little, {page}),
            .shape = {nx, ny},
            .size = {0.7 * units::um, 0.4 * units::um},
            .heights = gain * (scale * raw + offset) * units::nm};
}

}  // namespace

std::vector<FormatSample> park_samples() {
    return {sample<std::int16_t>("version 1", 1, 0), sample<std::int16_t>("int16", 2, 0),
            sample<std::int32_t>("int32", 2, 1), sample<float>("float32", 2, 2)};
}

}  // namespace setae::formats::tests
