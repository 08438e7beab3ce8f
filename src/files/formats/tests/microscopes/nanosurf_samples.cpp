// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 6, ny = 4;
constexpr double range = 9.5, least = -2.0;  // µm

std::string section(const char* name, const char* frame, const char* quantity, const char* unit, int bits,
                    bool is_signed, std::endian order) {
    return fmt::format(
        "[{}]\r\nVersion=2\r\nPoints={}\r\nLines={}\r\nFrame={}\r\nDim0Name=X*\r\nDim0Unit=nm\r\nDim0Range=3000\r\nDim0Min=0\r\nDim1Name=Y*\r\nDim1Unit=m\r\nDim1Range=1e-06\r\nDim1Min=0\r\n"
        "Dim2Name={}\r\nDim2Unit={}\r\nDim2Range={}\r\nDim2Min={}\r\nSaveMode=Binary\r\nSaveBits={}\r\nSaveSign={}\r\nSaveOrder={}\r\n\r\n",
        name, nx, ny, frame, quantity, unit, range, least, bits, is_signed ? "Signed" : "Unsigned",
        order == std::endian::little ? "Intel" : "Motorola");
}

template <class Integer>
FormatSample sample(const char* name, std::endian order) {
    constexpr bool is_signed = std::is_signed_v<Integer>;
    constexpr int bits = 8 * sizeof(Integer);
    const double lowest = static_cast<double>(std::numeric_limits<Integer>::min()), count = std::ldexp(1.0, bits);
    const Array2D raw = lopsided_heights(nx, ny, bits == 8 ? 0.25 : 20.0).floor() + lowest;
    ByteBuilder file(order);
    file.text(
        "[DataSet]\r\nVersion=2\r\nGroupCount=2\r\nGr0-Name=Scan forward\r\nGr0-Count=12\r\nGr1-Name=Scan backward\r\nGr1-Count=4\r\nGr0-Ch2=DataSet-0:2\r\nGr0-Ch10=DataSet-0:10\r\nGr1-Ch2=DataSet-1:2\r\n\r\n");
    file.text("[DataSet-Info]\r\nDate=07-08-2018\r\nTime=12:56:42\r\nHead type=FlexAFM\r\n\r\n");
    file.text(section("DataSet-0:2", "Scan forward", "Amplitude", "V", bits, is_signed, order))
        .text(section("DataSet-0:10", "Scan forward", "Phase", "\xb0", bits, is_signed, order));
    file.text(section("DataSet-1:2", "Scan backward", "Z-Axis", "\xb5m", bits, is_signed, order)).text("\r\n#!");
    const Array2D other = Array2D::Constant(nx, ny, 1.0);
    file.rows<Integer>(other).template rows<Integer>(other).template rows<Integer>(raw.rowwise().reverse());
    const Array2D heights = (least + range * (raw - lowest) / count) * units::um;
    return {.format = "nanosurf",
            .name = name,
            .content = file.content(),
            .channel = 2,
            .shape = {nx, ny},
            .size = {3 * units::um, 1 * units::um},
            .heights = heights};
}

}  // namespace

std::vector<FormatSample> nanosurf_samples() {
    constexpr auto little = std::endian::little, big = std::endian::big;
    return {sample<std::int8_t>("int8", little),   sample<std::uint8_t>("uint8", little),
            sample<std::int16_t>("int16", little), sample<std::uint16_t>("uint16, big-endian", big),
            sample<std::int32_t>("int32", little), sample<std::int32_t>("int32, big-endian", big)};
}

}  // namespace setae::formats::tests
