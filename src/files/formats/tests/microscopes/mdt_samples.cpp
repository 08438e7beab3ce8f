// SPDX-License-Identifier: GPL-3.0-or-later
#include "mdt_samples.hpp"

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr Index nx = 7, ny = 4;
constexpr std::int32_t float32_type = -(4 + 23 * 256), float64_type = -(8 + 52 * 256);

/// A frame with its head: bytes, type, version 6.3, date, bytes of variables.
std::string frame(std::uint16_t type, const std::string& variables, const std::string& rest) {
    ByteBuilder file;
    file.number(static_cast<std::uint32_t>(22 + variables.size() + rest.size())).number(type).text("\x06\x03");
    for (const int part : {2015, 1, 17, 12, 34, 56}) file.number(static_cast<std::uint16_t>(part));
    return file.number(static_cast<std::uint16_t>(variables.size())).text(variables).text(rest).content();
}

std::string axis(float offset, float step, std::int16_t unit) {
    return ByteBuilder().number(offset).number(step).number(unit).content();
}

std::string variables(std::uint8_t signal, const std::string& axes) {
    ByteBuilder file;
    file.text(axes)
        .number(signal)
        .number(std::uint8_t{1})
        .number(static_cast<std::uint16_t>(nx))
        .number(static_cast<std::uint16_t>(ny));
    return file.pad_to(130).content();
}

std::string calibration(const std::string& name, const std::string& unit, double bias, double scale,
                        std::uint64_t points, std::int32_t type) {
    constexpr std::uint32_t fixed = 12 + 8 + 8 + 8 + 16 + 16 + 8;
    ByteBuilder file;
    file.number(static_cast<std::uint32_t>(8 + fixed + name.size() + unit.size())).number(fixed);
    file.number(static_cast<std::uint32_t>(name.size()))
        .number(std::uint32_t{0})
        .number(static_cast<std::uint32_t>(unit.size()));
    file.number(std::uint64_t{0x101})
        .number(0.0)
        .number(std::uint64_t{0})
        .number(bias)
        .number(scale)
        .number(std::uint64_t{0})
        .number(points - 1)
        .number(type)
        .number(std::uint32_t{0});
    return file.text(name).text(unit).content();
}

/// A self-describing frame, with the calibrations of the measurands and the cells row after row from the bottom.
std::string mda_frame(const std::string& title, const std::vector<std::string>& measurands, const std::string& cells) {
    constexpr std::uint32_t head = 4 + 4 + 32 + 4 + 8 * 4;
    const std::string comment = "c\0o\0", view(5, 'v'), specification(3, 's'), origin(2, 'o');
    ByteBuilder file;
    file.number(head).number(std::uint32_t{0}).text("", 32).number(std::uint32_t{0});
    for (const auto size : {title.size(), comment.size(), view.size(), specification.size(), origin.size()})
        file.number(static_cast<std::uint32_t>(size));
    file.number(std::uint32_t{0}).number(std::uint32_t{0}).number(static_cast<std::uint32_t>(cells.size()));
    file.text(title).text(comment).text(view).text(specification).text(origin);
    file.number(std::uint32_t{0})
        .number(std::uint32_t{20})
        .number(std::uint64_t{nx * ny})
        .number(std::uint32_t{0})
        .number(std::uint32_t{2})
        .number(static_cast<std::uint32_t>(measurands.size()));
    file.text(calibration("x", "\xb5m", 1.0, 0.002, nx, 4)).text(calibration("y", "nm", 0.0, 3.0, ny, 4));
    for (const auto& measurand : measurands) file.text(measurand);
    return frame(106, {}, file.text(cells).content());
}

template <class Number>
std::string cells_of(const Array2D& raw) {
    return ByteBuilder().rows<Number>(raw.rowwise().reverse()).content();
}

FormatSample sample(const std::string& name, const std::vector<std::string>& frames, std::size_t channel,
                    const Array2D& heights) {
    return {.format = "mdt",
            .name = name,
            .content = mdt_file(frames),
            .channel = channel,
            .shape = {nx, ny},
            .size = {2.0 * nx * units::nm, 3.0 * ny * units::nm},
            .heights = heights};
}

}  // namespace

std::string mdt_scan(const Array2D& raw, float step, float offset, std::int16_t unit, const std::string& title) {
    const auto vars =
        variables(unit < 1 ? 0 : 1, axis(0.0f, 2.0f, -1) + axis(0.0f, -3.0f, -1) + axis(offset, step, unit));
    ByteBuilder rest;
    rest.number(std::uint16_t{0})
        .number(static_cast<std::uint16_t>(raw.rows()))
        .number(static_cast<std::uint16_t>(raw.cols()))
        .number(std::uint16_t{0});
    rest.rows<std::int16_t>(raw.rowwise().reverse());
    rest.number(static_cast<std::uint32_t>(title.size())).text(title).number(std::uint32_t{0});
    return frame(0, vars, rest.content());
}

std::string mdt_spectrum() {
    ByteBuilder rest;
    rest.number(std::uint16_t{0}).number(std::uint16_t{5}).number(std::uint16_t{1}).number(std::uint16_t{0});
    for (std::int16_t i = 0; i < 5; ++i) rest.number(i);
    return frame(1, variables(1, axis(0.0f, 1.0f, -1) + axis(0.0f, 0.0f, 3) + axis(0.0f, 0.1f, 1)), rest.content());
}

std::string mdt_file(const std::vector<std::string>& frames) {
    std::string all;
    for (const auto& one : frames) all += one;
    ByteBuilder file;
    file.text("\x01\xb0\x93\xff")
        .number(static_cast<std::uint32_t>(all.size()))
        .number(std::uint32_t{0})
        .number(static_cast<std::uint16_t>(frames.size() - 1));
    return file.pad_to(33).text(all).content();
}

std::vector<FormatSample> mdt_samples() {
    const auto raw = lopsided_heights(nx, ny, 1.0);
    const Array2D scaled = (0.25 * raw + 10.0) * units::nm;
    const auto scan = mdt_scan(raw, 0.25f, 10.0f, -1, "\xc2\xfb\xf1\xee\xf2\xe0"),
               current = mdt_scan(2.0 * raw, 0.5f, 0.0f, 1, "DFL");  // "Высота"
    const auto floats =
        mda_frame("Height", {calibration("z", "nm", 10.0, 0.25, 1, float32_type)}, cells_of<float>(raw));
    ByteBuilder cells;
    for (Index j = ny - 1; j >= 0; --j)
        for (Index i = 0; i < nx; ++i) cells.number(static_cast<std::int16_t>(7)).number(raw(i, j));
    const auto two =
        mda_frame("", {calibration("mag", "nA", 0.0, 1.0, 1, -2), calibration("z", "", 0.0, 1e-9, 1, float64_type)},
                  cells.content());
    return {sample("scan", {scan}, 0, scaled), sample("several frames", {mdt_spectrum(), current, scan}, 2, scaled),
            sample("array of floats", {floats}, 0, scaled),
            sample("array of two measurands", {scan, two}, 2, raw * units::nm)};
}

}  // namespace setae::formats::tests
