// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "tiff_builder.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int tiff_nx = 6, tiff_ny = 4;

template <class Value>
TiffPageBuilder page_of(std::endian order, int kind, const Array2D& values) {
    ByteBuilder pixels(order);
    pixels.rows<Value>(values);
    TiffPageBuilder page(order);
    page.picture(tiff_nx, tiff_ny, 8 * static_cast<int>(sizeof(Value)), kind).strips(tiff_ny, {pixels.content()});
    return page;
}

}  // namespace

std::vector<FormatSample> height_tiff_samples() {
    const auto map = lopsided_heights(tiff_nx, tiff_ny, 1.0);
    std::vector<FormatSample> samples;
    auto floats = page_of<float>(std::endian::little, 3, map);
    floats.text(270, "ImageJ=1.53t\nunit=um\nmin=0.0\n").real(282, 2.0).real(283, 2.0);
    samples.push_back({.format = "tiff",
                       .name = "float32 with the pixels of ImageJ",
                       .content = tiff_file(std::endian::little, {floats}),
                       .options = {.size = {}, .unit = "nm"},
                       .shape = {tiff_nx, tiff_ny},
                       .size = {3e-6, 2e-6},
                       .heights = map * units::nm});
    samples.push_back({.format = "tiff",
                       .name = "float64, big-endian, without size",
                       .content = tiff_file(std::endian::big, {page_of<double>(std::endian::big, 3, map)}),
                       .options = {.size = {{3e-6, 2e-6}}, .unit = "um"},
                       .shape = {tiff_nx, tiff_ny},
                       .size = {3e-6, 2e-6},
                       .heights = map * units::um});
    auto calibrated = page_of<std::uint16_t>(std::endian::little, 1, map);
    calibrated.text(270, "ImageJ=1.53t\nunit=\\u00B5m\ncf=0\nc0=-5\nc1=0.5\nvunit=nm\n").real(282, 2.0).real(283, 4.0);
    samples.push_back({.format = "tiff",
                       .name = "uint16 with ImageJ's calibration",
                       .content = tiff_file(std::endian::little, {calibrated}),
                       .shape = {tiff_nx, tiff_ny},
                       .size = {3e-6, 1e-6},
                       .heights = (0.5 * map - 5.0) * units::nm});
    return samples;
}

}  // namespace setae::formats::tests
