// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace setae::bytes {

/// A number from bytes in the given byte order. `from` must contain sizeof(T) bytes.
template <class T>
[[nodiscard]] T load(const char* from, std::endian order) {
    std::array<char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), from, sizeof(T));
    if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
}

/// An integer of `count` ≤ 8 bytes; the caller has checked their existence.
[[nodiscard]] inline std::uint64_t number_in(std::string_view bytes, std::size_t offset, std::size_t count,
                                             bool big_endian = false) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[offset + (big_endian ? i : count - 1 - i)]);
        value = (value << 8) | byte;
    }
    return value;
}

}  // namespace setae::bytes
