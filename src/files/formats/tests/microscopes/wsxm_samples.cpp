// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "wsxm_samples.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 6, ny = 4;

/// The header with its stated size, which includes its own digits.
std::string header(const WsxmFile& file) {
    std::string text;
    for (std::size_t announced = 0; text.size() != announced || announced == 0;) {
        announced = text.size();
        text = fmt::format(
            "{}\r\n{}\r\nImage header size: {}\r\n\r\n[Control]\r\n\r\n{}    X Offset: 12.5 nm\r\n    Z Offset: 136.524 nm\r\n\r\n[General Info]\r\n\r\n"
            "    Acquisition channel: Topography\r\n    Acquisition time: 03/11/2011, 20:23:46.484\r\n    Head type: AFM\r\n{}    Number of columns: {}\r\n"
            "    Number of rows: {}\r\n{}\r\n[Head Settings]\r\n\r\n    Head Name: AFM\r\n\r\n[Miscellaneous]\r\n\r\n    Dulcinea serial number: 24\r\n{}\r\n[Header end]\r\n",
            file.first_line, file.second_line, announced, file.lateral,
            file.type.empty() ? "" : "    Image Data Type: " + file.type + "\r\n", nx, ny, file.amplitude, file.range);
    }
    return text;
}

template <class Number>
FormatSample sample(const std::string& name, const WsxmFile& file, double step, double y_size = 400 * units::nm) {
    const Array2D raw = lopsided_heights(nx, ny, 1.0);
    return {.format = "wsxm",
            .name = name,
            .content = wsxm_file<Number>(file, raw),
            .shape = {nx, ny},
            .size = {600 * units::nm, y_size},
            .heights = raw * step};
}

}  // namespace

template <class Number>
std::string wsxm_file(const WsxmFile& file, const Array2D& raw) {
    ByteBuilder bytes;
    bytes.text(header(file));
    bytes.rows<Number>(raw.reverse());  // from the bottom, each from the right
    return bytes.content();
}

template std::string wsxm_file<std::int16_t>(const WsxmFile&, const Array2D&);
template std::string wsxm_file<double>(const WsxmFile&, const Array2D&);

std::vector<FormatSample> wsxm_samples() {
    const auto raw = lopsided_heights(nx, ny, 1.0);
    const double least = raw.minCoeff(), greatest = raw.maxCoeff();
    const auto range = fmt::format("    Maximum: {}\r\n    Minimum: {}\r\n", greatest, least);
    const WsxmFile integers{.type = "short", .amplitude = "    Z Amplitude: 18.5 nm\r\n", .range = range};
    auto no_range = integers, old_version = integers, floats = integers, doubles = integers;
    no_range.range = "";
    old_version.type = "";
    old_version.lateral = "    X Amplitude: 600 nm\r\n";
    floats.type = "float";
    doubles.type = "double";
    doubles.first_line = "WSxM file copyright UAM";
    doubles.amplitude = "    Z Amplitude: 18.5 \xc5\r\n";  // Å in Latin-1
    const double step = 18.5 * units::nm / (greatest - least);
    return {sample<std::int16_t>("integers, range stated", integers, step),
            sample<std::int16_t>("integers, range of the data", no_range, step),
            sample<std::int16_t>("no type, one amplitude", old_version, step, 600 * units::nm),
            sample<float>("floats", floats, units::nm),
            sample<double>("doubles in angstrom", doubles, units::angstrom)};
}

}  // namespace setae::formats::tests
