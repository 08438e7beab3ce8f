// SPDX-License-Identifier: GPL-3.0-or-later
#include "png_chunks.hpp"

#include <array>
#include <optional>

#include "setae/bytes/source.hpp"
#include "setae/bytes/stored_numbers.hpp"

namespace setae::imaging {
namespace {

constexpr std::size_t signature_bytes = 8;

constexpr std::array<std::uint32_t, 256> remainders = [] {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
        auto value = byte;
        for (int bit = 0; bit < 8; ++bit) value = value & 1 ? 0xEDB88320U ^ (value >> 1) : value >> 1;
        table[byte] = value;
    }
    return table;
}();

/// Kind, content and checksum of the chunk at a place; empty if it is incomplete.
std::optional<std::string_view> chunk_at(std::string_view png, std::size_t at) {
    if (at + 12 > png.size()) return std::nullopt;
    const auto length = bytes::number_in(png, at, 4, true);
    if (length > png.size() - at - 12) return std::nullopt;
    return png.substr(at + 4, length + 8);
}

}  // namespace

std::uint32_t png_checksum(std::string_view bytes) {
    std::uint32_t value = 0xFFFFFFFFU;
    for (const char byte : bytes) value = remainders[(value ^ static_cast<unsigned char>(byte)) & 255U] ^ (value >> 8);
    return ~value;
}

bool png_is_whole(std::string_view png) {
    auto at = signature_bytes;
    for (auto chunk = chunk_at(png, at); chunk; chunk = chunk_at(png, at)) {
        const auto content = chunk->substr(0, chunk->size() - 4);
        if (png_checksum(content) != bytes::number_in(*chunk, content.size(), 4, true)) return false;
        if (content.starts_with("IEND")) return true;
        at += chunk->size() + 4;
    }
    return false;
}

std::string_view png_chunk(std::string_view png, std::string_view kind) {
    auto at = signature_bytes;
    for (auto chunk = chunk_at(png, at); chunk; chunk = chunk_at(png, at)) {
        if (chunk->starts_with(kind)) return chunk->substr(4, chunk->size() - 8);
        at += chunk->size() + 4;
    }
    return {};
}

}  // namespace setae::imaging
