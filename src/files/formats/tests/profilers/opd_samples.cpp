// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr double wavelength = 600.0, pixel = 0.25;  // [nm], [mm]

struct Block {
    std::string name;
    int type;
    std::string content;
};

template <class T>
std::string bytes(T value) {
    return ByteBuilder().number(value).content();
}

std::string array(int item_bytes, const std::string& values) {
    return ByteBuilder()
        .number<std::uint16_t>(nx)
        .number<std::uint16_t>(ny)
        .number(static_cast<std::uint16_t>(item_bytes))
        .text(values)
        .content();
}

/// Column after column, each from the bottom.
template <class T>
std::string columns(const Array2D& raw) {
    ByteBuilder values;
    for (Index i = 0; i < raw.rows(); ++i)
        for (Index j = raw.cols() - 1; j >= 0; --j) values.number(static_cast<T>(raw(i, j)));
    return values.content();
}

std::string opd_file(const std::vector<Block>& blocks) {
    ByteBuilder file;
    const auto entry = [&](const std::string& name, int type, std::size_t length) {
        file.text(name, 16)
            .number(static_cast<std::uint16_t>(type))
            .number(static_cast<std::int32_t>(length))
            .number<std::uint16_t>(0xffff);
    };
    file.number<std::uint16_t>(1);
    entry("Directory", 1, 24 * (blocks.size() + 2));
    entry("Unused", 5, 0);
    for (const auto& block : blocks) entry(block.name, block.type, block.content.size());
    for (const auto& block : blocks) file.text(block.content);
    return file.content();
}

std::vector<Block> blocks_around(const std::string& name, const std::string& heights) {
    return {{"Wavelength", 7, bytes(static_cast<float>(wavelength))},
            {"Mult", 6, bytes<std::int16_t>(4)},
            {"Aspect", 7, bytes(2.0f)},
            {"Pixel_size", 7, bytes(static_cast<float>(pixel))},
            {"Date", 5, "7/7/2015"},
            {"Time", 5, "16:19:48"},
            {name, 3, heights},
            {"Image", 3, array(1, std::string(nx * ny, 'i'))},
            {"MeasMode", 15, std::string("\x12\x01\x03PSI")}};
}

template <class T>
FormatSample sample(const std::string& name, const std::string& block, double undefined_raw) {
    const Array2D raw = lopsided_heights(nx, ny, sizeof(T) == 1 ? 0.5 : 1.0).round();
    Array2D heights = raw * (wavelength * units::nm / 4.0), stored = raw;
    if (undefined_raw != 0.0) {
        stored(2, 1) = undefined_raw;
        heights(2, 1) = undefined;
    }
    return {.format = "opd",
            .name = name,
            .content = opd_file(blocks_around(block, array(sizeof(T), columns<T>(stored)))),
            .shape = {nx, ny},
            .size = {nx * pixel * units::mm, ny * 2.0 * pixel * units::mm},
            .heights = heights};
}

}  // namespace

std::vector<FormatSample> opd_samples() {
    return {sample<std::uint8_t>("1 byte", "OPD", 0.0), sample<std::int16_t>("2 bytes", "RAW_DATA", 32766.0),
            sample<float>("4 bytes", "Raw", 1e38),
            sample<float>("4 bytes, infinite", "SAMPLE_DATA", std::numeric_limits<double>::infinity())};
}

}  // namespace setae::formats::tests
