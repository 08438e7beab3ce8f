// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace setae::bytes {

/// A number from bytes of the order named. `from` must hold sizeof(T) bytes.
template <class T>
[[nodiscard]] T load(const char* from, std::endian order) {
    std::array<char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), from, sizeof(T));
    if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return value;
}

}  // namespace setae::bytes
