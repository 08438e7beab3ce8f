// SPDX-License-Identifier: GPL-3.0-or-later
#include "hdf5_heaps.hpp"

#include <string_view>

#include <fmt/format.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

constexpr std::string_view heap_signature("GCOL\x01\x00\x00\x00", 8);
constexpr std::uint64_t header_bytes = 16, object_header_bytes = 16, alignment = 8;

/// The problem of the heap at the start of these bytes; empty if there is none.
std::string fault(std::string_view bytes) {
    if (bytes.size() < header_bytes) return "ends early";
    const auto size = bytes::load<std::uint64_t>(bytes.data() + heap_signature.size(), std::endian::little);
    if (size < header_bytes || size > bytes.size())
        return fmt::format("states {} bytes, but {} are present", size, bytes.size());
    for (auto at = header_bytes; at + object_header_bytes <= size;) {
        const auto index = bytes::load<std::uint16_t>(bytes.data() + at, std::endian::little);
        const auto length = bytes::load<std::uint64_t>(bytes.data() + at + 8, std::endian::little);
        if (length > size - at) return fmt::format("states {} bytes at {} of {}", length, at, size);
        if (index == 0) return length == size - at ? "" : "has free space before its end";
        at += object_header_bytes + (length + alignment - 1) / alignment * alignment;
        if (at > size) return fmt::format("has an object that ends at {} of {}", at, size);
    }
    return {};
}

}  // namespace

void require_sound_heaps(const Source& source) {
    if (source.size > max_searched_for_heaps) return;
    const auto content = source.all();
    const std::string_view bytes(content);
    for (auto at = bytes.find(heap_signature); at != std::string_view::npos;
         at = bytes.find(heap_signature, at + alignment))
        if (const auto what = fault(bytes.substr(at)); !what.empty())
            throw FormatError(source.name, {.offset = at}, fmt::format("HDF5: a heap {}; the file is damaged", what));
}

}  // namespace setae::bytes
