// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4, header_characters = 2048;
enum class Text { latin1, utf16_little, utf16_little_marked, utf16_big_marked };

std::string encoded(const std::string& characters, Text text) {
    if (text == Text::latin1) return ByteBuilder().text(characters, header_characters, ' ').content();
    const bool marked = text != Text::utf16_little;
    ByteBuilder bytes(text == Text::utf16_big_marked ? std::endian::big : std::endian::little);
    if (marked) bytes.number<std::uint16_t>(0xfeff);
    const std::string filled = ByteBuilder().text(characters, header_characters - (marked ? 1 : 0), ' ').content();
    for (const char c : filled) bytes.number<std::uint16_t>(static_cast<unsigned char>(c));
    return bytes.content();
}

std::string header(const std::string& format, const std::string& more) {
    return fmt::format(
        "fileformat = {}\n% a remark = of no account\nxpixels = {}\nypixels = {}\nxlength = {}\nylength = {}\n{}starttime = 07 04 98 13:09:52\nforcecurve = 0\n",
        format, nx, ny, nx * 100.0, ny * 200.0, more);
}

/// Sizes of 100 and 200 nm per point; n/(n − 1) times as much if the file counts from the first to the last point.
std::vector<double> sizes(bool between_points) {
    return {nx * 100.0 * units::nm * (between_points ? nx / (nx - 1.0) : 1.0),
            ny * 200.0 * units::nm * (between_points ? ny / (ny - 1.0) : 1.0)};
}

template <class T>
FormatSample sample(const std::string& name, const std::string& head, Text text, std::endian order, double step,
                    double void_value, bool between_points = false) {
    Array2D raw = lopsided_heights(nx, ny, 1.0);
    raw(0, 0) = 0.0;
    Array2D heights = raw * step;
    raw(3, 1) = void_value;
    heights(3, 1) = undefined;
    ByteBuilder values(order);
    values.rows<T>(raw);
    return {.format = "bcr",
            .name = name,
            .content = encoded(head, text) + values.content(),
            .shape = {nx, ny},
            .size = sizes(between_points),
            .heights = heights};
}

}  // namespace

std::vector<FormatSample> bcr_samples() {
    const auto little = std::endian::little, big = std::endian::big;
    return {
        sample<std::int16_t>("integers", header("bcrstm", "bit2nm = 0.25\nvoidpixels = 1\nintelmode = 1\n"),
                             Text::latin1, little, 0.25 * units::nm, 32767.0),
        sample<std::int16_t>("integers, big-endian, no count of voids",
                             header("bcrstm", "bit2nm = 0.25\nvoidpixels = 0\nintelmode = 0\nzunit = um\n"),
                             Text::latin1, big, 0.25 * units::um, 32767.0),
        sample<float>("floating point", header("bcrf", "bit2nm = 5\nvoidpixels = 1\n"), Text::latin1, little, units::nm,
                      1.7014118e38),
        sample<float>("floating point, big-endian", header("bcrf", "intelmode = 0\n"), Text::latin1, big, units::nm,
                      1.7014118e38),
        sample<float>(
            "NanoFocus",
            header("bcrf_unicode",
                   "headersize = 2048\nvoidpixels = 3.402823E+38\n xunit = nm\n yunit = nm\n zunit = um\nbit2nm = 1\n"),
            Text::utf16_little, little, units::um, 3.4028235e38, true),
        sample<float>("UTF-16 with its mark", header("bcrf_unicode", ""), Text::utf16_little_marked, little, units::nm,
                      1.7014118e38),
        sample<std::int16_t>("UTF-16, big-endian", header("bcrstm_unicode", "bit2nm = 2\n"), Text::utf16_big_marked,
                             little, 2.0 * units::nm, 32767.0)};
}

}  // namespace setae::formats::tests
