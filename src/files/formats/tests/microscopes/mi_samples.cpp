// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 8, ny = 5;
constexpr double range = 3.0;

std::string line(const char* key, const std::string& value) { return fmt::format("{:<14}{}\n", key, value); }

std::string header(const std::string& encoding) {
    return line("fileType", "Image") + line("version", "PicoView 0x10c04") +
           line("dateAcquired", "Tue Feb 18 15:00:51 2014") + line("mode", "Contact AFM") +
           line("xPixels", std::to_string(nx)) + line("yPixels", std::to_string(ny)) + line("xLength", "1.6e-005") +
           line("yLength", "1.0e-005") + line("scanUp", "FALSE") + line("bufferLabel", "Deflection") +
           line("bufferRange", "1.0e+001") + line("bufferUnit", "V") + line("trace", "Trace") +
           line("bufferLabel", "Topography") + line("bufferRange", "3.0e+000") + line("bufferUnit", "um") +
           line("trace", "Retrace") + line("data", encoding);
}

FormatSample sample(const std::string& encoding, const std::string& data, const Array2D& heights) {
    return {.format = "mi",
            .name = encoding.empty() ? "no encoding" : encoding,
            .content = header(encoding) + data,
            .channel = 1,
            .shape = {nx, ny},
            .size = {16 * units::um, 10 * units::um},
            .heights = heights};
}

template <class Integer>
std::string binary(const Array2D& raw) {
    return ByteBuilder().rows<Integer>(Array2D::Zero(nx, ny)).template rows<Integer>(raw.rowwise().reverse()).content();
}

/// Numbers of both channels as text: in sequence, or one column each.
std::string words(const Array2D& values, bool columns) {
    std::string first, second, both;
    for (Index j = ny - 1; j >= 0; --j)
        for (Index i = 0; i < nx; ++i) {
            first += "0\n";
            second += fmt::format("{}\n", values(i, j));
            both += fmt::format("0.5 {}\n", values(i, j));
        }
    return columns ? both : first + second;
}

}  // namespace

std::vector<FormatSample> mi_samples() {
    const Array2D raw = lopsided_heights(nx, ny, 7.0), small = raw * (range * units::um / 32768.0),
                  wide = raw * (range * units::um / 2147483648.0);
    return {sample("BINARY", binary<std::int16_t>(raw), small),
            sample("", binary<std::int16_t>(raw), small),
            sample("BINARY_32", binary<std::int32_t>(raw), wide),
            sample("ASCII", words(raw, false), small),
            sample("ASCII_ABSOLUTE", words(raw, false), raw * units::um),
            sample("ASCII_MULTICOLUMN", words(raw, true), raw * units::um)};
}

}  // namespace setae::formats::tests
