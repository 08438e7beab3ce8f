// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

#include <fmt/format.h>

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
/// hard value 2 V times sensitivity 20 nm/V
constexpr double full_scale = 40.0 * units::nm;

std::string header(int bytes, std::size_t offset) {
    return fmt::format(
        "\\*File list\r\n\\Version: 0x07200000\r\n\\Date: 09:57:48 AM Tue Jan 12 2016\r\n\\*Scanner list\r\n\\@Sens. Zsens: V 20.00000 nm/V\r\n"
        "\\*Ciao image list\r\n\\Data offset: {}\r\n\\Data length: {}\r\n\\Bytes/pixel: {}\r\n\\Samps/line: {}\r\n\\Number of lines: {}\r\n"
        "\\Scan Size: 700 400 nm\r\n\\@2:Image Data: S [Height] \"Height\"\r\n\\@2:Z scale: V [Sens. Zsens] (0.0000305 V/LSB) 2.000000 V\r\n\\*File list end\r\n\x1a",
        offset, nx * ny * bytes, bytes, nx, ny);
}

template <class Integer>
FormatSample sample(const std::string& name, double step) {
    constexpr std::size_t offset = 2048;
    ByteBuilder file;
    file.text(header(sizeof(Integer), offset)).pad_to(offset);
    const Array2D raw = lopsided_heights(nx, ny, 1.0);
    file.rows<Integer>(raw.rowwise().reverse());  // from the bottom
    return {.format = "di",
            .name = name,
            .content = file.content(),
            .shape = {nx, ny},
            .size = {700 * units::nm, 400 * units::nm},
            .heights = raw * step};
}

}  // namespace

std::vector<FormatSample> nanoscope_samples() {
    return {sample<std::int16_t>("2 bytes", full_scale / 65536.0),
            sample<std::int32_t>("4 bytes", full_scale / 65536.0 / 65536.0)};
}

}  // namespace setae::formats::tests
