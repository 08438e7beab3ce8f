// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <string_view>

#include "error_message.hpp"
#include "format_samples.hpp"
#include "setae/formats/format.hpp"

namespace setae::formats::tests {

using namespace setae::tests;

/// A file's bytes with one number replaced.
template <class T>
std::string with_number(std::string content, std::size_t offset, T value, std::endian order = std::endian::little) {
    std::array<char, sizeof(T)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(T));
    if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
    return content.replace(offset, sizeof(T), bytes.data(), sizeof(T));
}

/// A text with the first `old` in it replaced.
inline std::string replaced(std::string text, std::string_view old, std::string_view with) {
    return text.replace(text.find(old), old.size(), with);
}

inline std::vector<Channel> channels_of(const std::string& content, const ReadOptions& options = {}) {
    return open(bytes::memory_source("file", content), options);
}

inline topography::HeightMap map_of(const Channel& channel) { return std::get<topography::HeightMap>(channel.read()); }

/// Error of opening and reading the bytes of a file, or "no error".
inline std::string refusal(const std::string& content, const ReadOptions& options = {}) {
    return message_of([&] {
        for (const auto& channel : channels_of(content, options))
            if (channel.info.is_height) (void)channel.read();
    });
}

}  // namespace setae::formats::tests
