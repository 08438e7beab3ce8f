// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "igor_builder.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 6, ny = 4;
constexpr double step_x = 2e-8, step_y = 5e-8;

/// Two layers: another channel, then the one described.
template <class T>
FormatSample map_sample(const char* name, std::endian order, std::int16_t type, double unit) {
    Array2D raw = lopsided_heights(nx, ny, unit).template cast<T>().template cast<double>();
    if constexpr (!std::is_integral_v<T>) raw(2, 1) = std::numeric_limits<double>::quiet_NaN();
    ByteBuilder numbers(order);
    numbers.rows<T>(Array2D::Zero(nx, ny)).template rows<T>(raw.rowwise().reverse());
    const IgorContent content{.points = {nx, ny, 2, 0},
                              .step = {step_x, step_y, 1, 1},
                              .data_unit = type >= 8 ? "nm" : "m",
                              .lateral_unit = "m",
                              .note = "ScanSize: 1e-7\rMicroscopeModel:MFP3D\rDate:2019-10-24\rTime:12:14:13 PM\r",
                              .labels = {"PhaseTrace", "HeightRetrace"},
                              .type = type,
                              .numbers = numbers.content()};
    return {.format = "ibw",
            .name = name,
            .content = igor_wave_5(order, content),
            .channel = 1,
            .shape = {nx, ny},
            .size = {nx * step_x, ny * step_y},
            .heights = raw * (type >= 8 ? units::nm : 1.0),
            .tolerance = 1e-7};
}

FormatSample line_of_version_2(std::endian order) {
    constexpr int n = 20;
    const Array2D raw = lopsided_heights(n, 1, 1e-9);
    ByteBuilder file(order);
    const std::string note = "a line";
    file.number<std::int16_t>(2)
        .number(static_cast<std::int32_t>(110 + 8 * n + 16))
        .number(static_cast<std::int32_t>(note.size()))
        .number<std::int32_t>(0)
        .number<std::uint16_t>(0);
    file.number<std::int16_t>(4).number<std::uint32_t>(0).text("line", 20).pad_to(16 + 34);
    file.text("m", 4).text("m", 4).number<std::int32_t>(n).number<std::int16_t>(0).number(3e-9).number(0.0).pad_to(126);
    put_checksum(file, 14, 126, order);
    file.rows<double>(raw).pad_to(126 + 8 * n + 16).text(note);
    return {.format = "ibw",
            .name = order == std::endian::big ? "version 2, big-endian" : "version 2",
            .content = file.content(),
            .shape = {n},
            .size = {n * 3e-9},
            .heights = raw};
}

}  // namespace

std::vector<FormatSample> ibw_samples() {
    return {map_sample<float>("float32", std::endian::little, 2, 1e-9),
            map_sample<double>("float64, big-endian", std::endian::big, 4, 1e-9),
            map_sample<std::int16_t>("int16", std::endian::little, 0x10, 1.0),
            map_sample<std::uint32_t>("uint32, big-endian", std::endian::big, 0x60, 1.0),
            line_of_version_2(std::endian::little),
            line_of_version_2(std::endian::big)};
}

}  // namespace setae::formats::tests
