// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <bit>
#include <vector>

#include <fmt/format.h>

#include "picture_decoders.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/stored_numbers.hpp"

namespace setae::imaging {
namespace {

constexpr std::uint64_t core_header = 12, masks_at = 54;
enum Packing : std::uint64_t { none = 0, runs_of_8 = 1, runs_of_4 = 2, masks = 3 };

struct Layout {
    PictureSize size;
    bool top_down = false;
    std::uint64_t bits = 0, packing = none, pixels_at = 0;
    std::vector<float> palette;               ///< grey levels
    std::array<std::uint32_t, 3> channels{};  ///< masks of red, green and blue in a pixel of 16 or 32 bits

    [[nodiscard]] std::uint64_t row_bytes() const {
        return (static_cast<std::uint64_t>(size.width) * bits + 31) / 32 * 4;
    }
};

FrameRead refused(std::string why) { return {{}, std::move(why)}; }

/// Up to 256 entries of 3 or 4 bytes, blue first; missing ones are black.
std::vector<float> palette_in(std::string_view bytes, std::uint64_t at, std::uint64_t entry_bytes, std::uint64_t bits) {
    std::vector<float> palette(std::size_t{1} << bits, 0.0f);
    for (auto& grey : palette) {
        if (at + 3 > bytes.size()) break;
        grey = luminance_of(static_cast<unsigned char>(bytes[at + 2]), static_cast<unsigned char>(bytes[at + 1]),
                            static_cast<unsigned char>(bytes[at]));
        at += entry_bytes;
    }
    return palette;
}

/// The part of a pixel that a mask marks, in 8 bits.
double channel_of(std::uint32_t pixel, std::uint32_t mask) {
    if (mask == 0) return 0;
    const auto value = (pixel & mask) >> std::countr_zero(mask);
    const int width = std::bit_width(mask) - std::countr_zero(mask);
    return width > 8 ? value >> (width - 8) : value << (8 - width);
}

/// One index of the palette per pixel, rows in the order of the file; skipped pixels remain 0. False for damaged ones.
bool expand_runs(std::string_view runs, const Layout& layout, std::vector<std::uint8_t>& places) {
    const auto width = static_cast<std::uint64_t>(layout.size.width),
               height = static_cast<std::uint64_t>(layout.size.height);
    std::uint64_t at = 0, x = 0, y = 0;
    const bool pairs = layout.packing == runs_of_4;
    while (at + 2 <= runs.size()) {
        const auto count = static_cast<std::uint8_t>(runs[at]), value = static_cast<std::uint8_t>(runs[at + 1]);
        at += 2;
        if (count == 0 && value == 0) {
            x = 0;
            ++y;
        } else if (count == 0 && value == 1) return true;
        else if (count == 0 && value == 2) {
            if (at + 2 > runs.size()) return false;
            x += static_cast<std::uint8_t>(runs[at]);
            y += static_cast<std::uint8_t>(runs[at + 1]);
            at += 2;
        } else {
            const std::uint64_t some = count > 0 ? count : value, stored = pairs ? (some + 1) / 2 : some;
            if (y >= height || x > width || some > width - x || (count == 0 && stored > runs.size() - at)) return false;
            for (std::uint64_t k = 0; k < some; ++k, ++x) {
                const auto byte = count > 0 ? value : static_cast<std::uint8_t>(runs[at + (pairs ? k / 2 : k)]);
                places[y * width + x] = static_cast<std::uint8_t>(!pairs ? byte : k % 2 == 0 ? byte >> 4 : byte & 15);
            }
            if (count == 0) at += stored + stored % 2;
        }
    }
    return y >= height || (y + 1 == height && x == width);
}

float grey_at(std::string_view row, std::uint64_t column, const Layout& layout) {
    const auto byte = [&](std::uint64_t at) { return static_cast<unsigned char>(row[at]); };
    if (layout.bits <= 8) {
        const auto bit = column * layout.bits;
        return layout.palette[(byte(bit / 8) >> (8 - layout.bits - bit % 8)) & ((1U << layout.bits) - 1)];
    }
    if (layout.bits == 24) return luminance_of(byte(3 * column + 2), byte(3 * column + 1), byte(3 * column));
    const auto pixel = static_cast<std::uint32_t>(bytes::number_in(row, column * layout.bits / 8, layout.bits / 8));
    return luminance_of(channel_of(pixel, layout.channels[0]), channel_of(pixel, layout.channels[1]),
                        channel_of(pixel, layout.channels[2]));
}

}  // namespace

FrameRead decoded_bmp(std::string_view bytes, PictureSize size) {
    const auto header = bytes::number_in(bytes, 14, 4);
    const bool core = header == core_header;
    if (!core && (header < 40 || 14 + header > bytes.size()))
        return refused(fmt::format("a header of {} bytes cannot be decoded; it is damaged", header));
    Layout layout{.size = size,
                  .top_down = !core && static_cast<std::int32_t>(bytes::number_in(bytes, 22, 4)) < 0,
                  .bits = bytes::number_in(bytes, core ? 24 : 28, 2),
                  .packing = core ? std::uint64_t{none} : bytes::number_in(bytes, 30, 4),
                  .pixels_at = bytes::number_in(bytes, 10, 4)};
    const auto bits = layout.bits, packing = layout.packing;
    const bool known = packing == none ? bits == 1 || bits == 4 || bits == 8 || bits == 16 || bits == 24 || bits == 32
                       : packing == masks     ? bits == 16 || bits == 32
                       : packing == runs_of_8 ? bits == 8
                                              : packing == runs_of_4 && bits == 4;
    if (!known)
        return refused(
            fmt::format("{} bits per pixel packed as {} cannot be decoded; save the picture as PNG", bits, packing));
    if (bits <= 8) layout.palette = palette_in(bytes, 14 + header, core ? 3 : 4, bits);
    if (bits == 16) layout.channels = {0x7C00, 0x03E0, 0x001F};
    if (bits == 32) layout.channels = {0xFF0000, 0xFF00, 0xFF};
    if (packing == masks) {
        if (masks_at + 12 > bytes.size()) return refused("truncated: it ends in its header");
        for (std::size_t k = 0; k < 3; ++k)
            layout.channels[k] = static_cast<std::uint32_t>(bytes::number_in(bytes, masks_at + 4 * k, 4));
    }
    if (layout.pixels_at > bytes.size()) return refused("truncated: it ends before its pixels");
    auto rows = bytes.substr(layout.pixels_at);
    auto stride = layout.row_bytes();
    std::vector<std::uint8_t> places;
    if (packing == runs_of_8 || packing == runs_of_4) {
        places.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
        if (!expand_runs(rows, layout, places)) return refused("its runs are damaged and cannot be decoded");
        rows = {reinterpret_cast<const char*>(places.data()), places.size()};
        stride = static_cast<std::uint64_t>(size.width);
        layout.bits = 8;
    }
    const auto height = static_cast<std::uint64_t>(size.height);
    if (stride * height > rows.size())
        return refused(fmt::format("truncated: {} of {} bytes of pixels", rows.size(), stride * height));
    FramePixels pixels(size.height, size.width);
    for (std::uint64_t row = 0; row < height; ++row) {
        const auto line = rows.substr((layout.top_down ? row : height - 1 - row) * stride, stride);
        for (long column = 0; column < size.width; ++column)
            pixels(static_cast<long>(row), column) = grey_at(line, static_cast<std::uint64_t>(column), layout);
    }
    return {std::move(pixels), {}};
}

}  // namespace setae::imaging
