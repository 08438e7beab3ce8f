// SPDX-License-Identifier: GPL-3.0-or-later
#include "vk_samples.hpp"

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;

std::string image(const Array2D& raw, int bits) {
    ByteBuilder bytes;
    bytes.number(static_cast<std::uint32_t>(raw.rows()))
        .number(static_cast<std::uint32_t>(raw.cols()))
        .number(static_cast<std::uint32_t>(bits))
        .number(0u);
    bytes.number(static_cast<std::uint32_t>(raw.size() * bits / 8)).number(0u).number(0xffffu).pad_to(28 + 768);
    if (bits == 8) bytes.rows<std::uint8_t>(raw);
    if (bits == 16) bytes.rows<std::uint16_t>(raw);
    if (bits == 32) bytes.rows<std::uint32_t>(raw);
    return bytes.content();
}

std::string conditions(int minutes_ahead_of_utc) {
    ByteBuilder bytes;
    bytes.number(304u);
    for (const std::uint32_t field : {2014u, 9u, 29u, 10u, 58u, 26u}) bytes.number(field);
    bytes.number(minutes_ahead_of_utc).number_at(4 * 18, 10u).number_at(4 * 24, 500u);
    bytes.number_at(4 * 42, 500'000u)
        .number_at(4 * 43, 250'000u)
        .number_at(4 * 44, 2'000u)
        .number_at(4 * 56, 950u)
        .pad_to(304);
    return bytes.content();
}

std::string texts() {
    ByteBuilder bytes;
    for (const std::string_view text : {"wafer 3", "Plan 50x"}) {
        bytes.number(static_cast<std::uint32_t>(text.size()));
        for (const char c : text) bytes.text(std::string{c, '\0'});
    }
    return bytes.content();
}

FormatSample sample(const std::string& name, const std::string& content, const Array2D& raw, std::size_t channel = 0) {
    return {.format = "vk",
            .name = name,
            .content = content,
            .channel = channel,
            .shape = {nx, ny},
            .size = {nx * 500 * units::nm, ny * 250 * units::nm},
            .heights = raw * (2.0 * units::nm)};
}

}  // namespace

std::string bmp_picture() {
    ByteBuilder bytes;
    bytes.text("BM")
        .number(70u)
        .number(0u)
        .number(54u)
        .number(40u)
        .number(2)
        .number(2)
        .number(std::uint16_t{1})
        .number(std::uint16_t{24})
        .pad_to(70);
    return bytes.content();
}

std::string vk4_file(const VkFile& file) {
    const std::size_t begin = file.version == 3 ? 80 : 84;  // version 4 has one more entry in the table
    ByteBuilder bytes;
    bytes.text(file.version == 3 ? "VK3_" : "VK4_")
        .number(0x01020304u)
        .pad_to(begin)
        .number_at(12, static_cast<std::uint32_t>(begin));
    bytes.text(conditions(file.minutes_ahead_of_utc));
    if (file.light) {
        bytes.number_at(24, static_cast<std::uint32_t>(bytes.size()));
        bytes.text(image(file.heights[0], 16));
    }
    for (std::size_t i = 0; i < file.heights.size(); ++i) {
        bytes.number_at(36 + 4 * i, static_cast<std::uint32_t>(bytes.size()));
        bytes.text(image(file.heights[i], file.bits));
    }
    bytes.number_at(76, static_cast<std::uint32_t>(bytes.size()));
    return bytes.text(texts()).content();
}

std::string vk6_file(const VkFile& file, char version) {
    return ByteBuilder()
               .text("VK")
               .text(std::string(1, version))
               .number(static_cast<std::uint32_t>(bmp_picture().size()))
               .text(bmp_picture())
               .content() +
           zip_archive({{"Vk4File", vk4_file(file)}, {"Vk6ImageData", "not read"}});
}

std::vector<FormatSample> vk_samples() {
    const Array2D raw = lopsided_heights(nx, ny, 1.0), small = lopsided_heights(nx, ny, 0.5).floor();
    const Array2D other = raw + 1000.0;
    return {sample("VK4, 16 bits", vk4_file({.heights = {raw}, .light = true}), raw),
            sample("VK4, 32 bits", vk4_file({.heights = {raw * 1000.0}, .bits = 32}), raw * 1000.0),
            sample("VK4, 8 bits", vk4_file({.heights = {small}, .bits = 8}), small),
            sample("VK4, third image", vk4_file({.heights = {raw, raw, other}, .bits = 32}), other, 2),
            sample("VK3", vk4_file({.heights = {raw}, .version = 3}), raw),
            sample("VK6", vk6_file({.heights = {raw}}), raw),
            sample("VK7", vk6_file({.heights = {raw * 1000.0}, .bits = 32}, '7'), raw * 1000.0)};
}

}  // namespace setae::formats::tests
