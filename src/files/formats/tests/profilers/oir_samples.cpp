// SPDX-License-Identifier: GPL-3.0-or-later
#include "oir_samples.hpp"

#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr const char* height_image = "1f0c2a34-0000-4000-8000-00000000000a";
constexpr const char* light_image = "1f0c2a34-0000-4000-8000-00000000000b";
constexpr const char* prefix = "t001_0_1";

std::string text(std::string_view content) {
    return ByteBuilder().number(static_cast<std::uint32_t>(content.size())).text(content).content();
}
std::string chunk(std::int32_t kind, const std::string& content) {
    return ByteBuilder().number(static_cast<std::int32_t>(content.size())).number(kind).text(content).content();
}

/// Kind, header of eight numbers, payload.
std::string block(std::uint32_t kind, const std::string& payload) {
    ByteBuilder bytes;
    for (const std::uint32_t number : {kind, 2u, 1u, 4u, 0u, 1u, 1u, 1u, 1u}) bytes.number(number);
    return bytes.text(payload).content();
}

std::string xml(const std::string& content) { return "<?xml version=\"1.0\" encoding=\"ASCII\"?>" + content; }

std::string channel(const char* identifier, const char* kind, int depth) {
    return fmt::format(
        "<commonphase:channel id=\"{}\"><commonphase:imageDefinition><commonphase:imageType>{}</commonphase:imageType><commonphase:depth>{}</commonphase:depth>"
        "<commonphase:bitCounts>12</commonphase:bitCounts></commonphase:imageDefinition>"
        "<commonphase:length><commonparam:x>0.5</commonparam:x><commonparam:y>0.25</commonparam:y><commonparam:z>0.01</commonparam:z></commonphase:length>"
        "<commonphase:pixelUnit><commonphase:x>MICRO_METER</commonphase:x><commonphase:y>MICRO_METER</commonphase:y><commonphase:z>MICRO_METER</commonphase:z></commonphase:pixelUnit>"
        "</commonphase:channel>",
        identifier, kind, depth);
}

std::string properties(const OirFile& file) {
    if (file.camera) return xml("<cameraimage:imageProperties xmlns:cameraimage=\"c\"/>");
    return xml(fmt::format(
        "<lsmimage:imageProperties xmlns:lsmimage=\"l\" xmlns:commonimage=\"i\" xmlns:commonphase=\"p\" xmlns:commonparam=\"m\" xmlns:base=\"b\">"
        "<commonimage:general><base:creationDateTime>2019-06-21T14:03:11.208+09:00</base:creationDateTime></commonimage:general>"
        "<commonimage:microscope><base:name>OLS5000</base:name></commonimage:microscope>"
        "<commonimage:imageInfo><commonimage:width>{}</commonimage:width><commonimage:height>{}</commonimage:height><commonimage:phase><commonphase:group>{}{}</commonphase:group>"
        "</commonimage:phase></commonimage:imageInfo><commonimage:acquisition><commonimage:microscopeConfiguration><commonimage:pixelCalibration>"
        "<commonparam:x>1</commonparam:x><commonparam:y>2</commonparam:y><commonparam:z>3</commonparam:z>"
        "</commonimage:pixelCalibration></commonimage:microscopeConfiguration></commonimage:acquisition></lsmimage:imageProperties>",
        file.raw.rows(), file.raw.cols(), channel(light_image, "INTENSITY", 2),
        channel(height_image, "HEIGHT", file.depth)));
}

std::string metadata(const OirFile& file) {
    const auto one = ByteBuilder().number(1u).content(), zero = ByteBuilder().number(0u).content();
    return chunk(
        0, block(1, text(xml("<version/>"))) + block(2, text(properties(file))) +
               block(5, one + text("lut") + text(xml("<lut/>"))) + block(6, one + text(prefix) + zero) +
               block(7, zero) +
               block(8, ByteBuilder().number(2u).content() + text(light_image) + zero + text(height_image) + zero) +
               block(9, one + zero + text("a") + text("b")) +
               block(10, one + text(light_image) + zero + text(xml("<camera/>")) + text(xml("<image/>"))) +
               block(11, one + text("u") + text(xml("<lut/>"))) + block(14, text(xml("<events/>"))));
}

std::string image(const char* identifier, int part, const std::string& points) {
    const auto size = static_cast<std::uint32_t>(points.size());
    return chunk(3, ByteBuilder()
                        .number(0u)
                        .number(size)
                        .text(text(fmt::format("{}_{}_{}", prefix, identifier, part)))
                        .content()) +
           ByteBuilder().number(size).number(4u).text(points).content();
}

std::string points_of(const Array2D& raw, int depth) {
    ByteBuilder bytes;
    return depth == 1 ? bytes.rows<std::uint8_t>(raw).content() : bytes.rows<std::uint16_t>(raw).content();
}

FormatSample described(const std::string& format, const std::string& name, const std::string& content,
                       const Array2D& raw, std::size_t channel) {
    return {.format = format,
            .name = name,
            .content = content,
            .channel = channel,
            .shape = {nx, ny},
            .size = {nx * 0.5 * units::um, ny * 0.5 * units::um},
            .heights = raw * (0.03 * units::um)};
}

}  // namespace

std::string oir_file(const OirFile& file) {
    const auto points = points_of(file.raw, file.depth);
    auto chunks = chunk(2, std::string("BMP\0BM\x0a\0\0\0abcd", 14)) + metadata(file) + chunk(5, "") +
                  image(light_image, 0, points_of(file.raw * 0.0, 2));
    for (int part = 0; part < file.parts; ++part) {
        const auto size = points.size() / static_cast<std::size_t>(file.parts),
                   first = size * static_cast<std::size_t>(part);
        chunks += image(height_image, part, points.substr(first, part + 1 < file.parts ? size : std::string::npos));
    }
    chunks += chunk(1, block(3, text(xml("<frame/>")))) + ByteBuilder().number(-1).content() + std::string(136, '\x60');
    ByteBuilder header;
    header.text("OLYMPUSRAWFORMAT")
        .number(12u)
        .number(0u)
        .number(1u)
        .number(2u)
        .number(static_cast<std::uint32_t>(96 + chunks.size()))
        .number(2u);
    header.number(static_cast<std::uint32_t>(chunks.size() + 96 - 140))
        .number(0u)
        .number(17u)
        .number(0u)
        .number(1u)
        .number(0u)
        .number(96u)
        .number(0u)
        .text("UNKNOWN", 8);
    header.number(1u).number(1u).number(0xffffffffu).number(0xffffffffu);
    return header.content() + chunks;
}

std::vector<FormatSample> oir_samples() {
    const Array2D raw = lopsided_heights(nx, ny, 100.0), small = lopsided_heights(nx, ny, 0.5).floor();
    return {described("oir", "2 bytes", oir_file({.raw = raw}), raw, 1),
            described("oir", "2 bytes in three parts", oir_file({.raw = raw, .parts = 3}), raw, 1),
            described("oir", "1 byte", oir_file({.raw = small, .depth = 1}), small, 1)};
}

std::vector<FormatSample> poir_samples() {
    const Array2D raw = lopsided_heights(nx, ny, 100.0);
    return {described("poir", "camera and laser",
                      zip_archive({{"a^XY_Camera.oir", oir_file({.raw = raw, .camera = true})},
                                   {"a^3D_LSM.oir", oir_file({.raw = raw})}}),
                      raw, 2)};
}

}  // namespace setae::formats::tests
