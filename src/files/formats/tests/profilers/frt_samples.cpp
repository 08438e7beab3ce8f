// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "byte_builder.hpp"
#include "format_samples.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr double width = 0.03, height = 0.06, step = 2e-9;

struct Block {
    std::uint16_t tag;
    std::string content;
};

std::string file(const std::string& version, const std::vector<Block>& blocks) {
    ByteBuilder bytes;
    bytes.text("FRTM_GLIDERV").text(version).number(static_cast<std::uint16_t>(blocks.size()));
    for (const auto& block : blocks) {
        bytes.number(block.tag);
        if (version == "1.00") bytes.number(static_cast<std::uint32_t>(block.content.size()));
        else bytes.number(static_cast<std::uint64_t>(block.content.size()));
        bytes.text(block.content);
    }
    return bytes.content();
}

template <class T>
std::string values(const Array2D& raw) {
    return ByteBuilder().rows<T>(raw.rowwise().reverse()).content();  // from the bottom
}

template <class T>
std::string image(std::uint32_t type, const Array2D& raw) {
    return ByteBuilder()
        .number(type)
        .number<std::uint32_t>(nx)
        .number<std::uint32_t>(ny)
        .number<std::uint32_t>(8 * sizeof(T))
        .text(values<T>(raw))
        .content();
}

std::vector<Block> header(std::uint32_t bits) {
    return {{0x65, "a wafer"},
            {0x66, ByteBuilder().number<std::uint32_t>(nx).number<std::uint32_t>(ny).number(bits).content()},
            {0x67, ByteBuilder()
                       .number(width)
                       .number(-height)
                       .number(0.0)
                       .number(0.0)
                       .number(2.0)
                       .number<std::uint32_t>(1)
                       .content()},
            {0x6c, ByteBuilder().number<std::uint32_t>(5).number(step).content()},
            {0x72, ByteBuilder()
                       .number<std::uint32_t>(1687796545)
                       .number<std::uint32_t>(1687797050)
                       .number<std::uint32_t>(505)
                       .content()},
            {0x8e, ByteBuilder().number<std::uint32_t>(8).text("SN_1036", 8).pad_to(24).content()}};
}

Array2D raw_with_undefined() {
    Array2D raw = lopsided_heights(nx, ny, 10.0);
    raw(2, 1) = 1.0;
    return raw;
}

FormatSample sample(const std::string& name, const std::string& content) {
    Array2D heights = lopsided_heights(nx, ny, 10.0 * step);
    heights(2, 1) = undefined;
    return {.format = "frt",
            .name = name,
            .content = content,
            .shape = {nx, ny},
            .size = {width, height},
            .heights = heights};
}

template <class T>
FormatSample single(const std::string& name, const std::string& version) {
    auto blocks = header(8 * sizeof(T));
    blocks.push_back({0x0b, values<T>(raw_with_undefined())});
    return sample(name, file(version, blocks));
}

template <class T>
FormatSample multiple(const std::string& name, const std::string& version, std::uint32_t type, bool with_single) {
    auto blocks = header(8 * sizeof(T));
    const auto raw = raw_with_undefined();
    if (with_single) blocks.push_back({0x0b, values<T>(raw)});
    blocks.push_back({0x7d, std::string(8, '\0') + image<std::uint16_t>(2, raw * 3.0) + image<T>(type, raw)});
    return sample(name, file(version, blocks));
}

}  // namespace

std::vector<FormatSample> frt_samples() {
    return {single<std::uint16_t>("1.00, 16 bits", "1.00"), single<std::int32_t>("1.01, 32 bits", "1.01"),
            multiple<std::uint16_t>("1.00, images", "1.00", 4, true),
            multiple<std::int32_t>("1.01, images of 32 bits", "1.01", 0x10000080, false)};
}

}  // namespace setae::formats::tests
