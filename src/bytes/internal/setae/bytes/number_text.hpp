// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

namespace setae::bytes {

/// The number a text spells from its first character to its last, as std::from_chars reads it; nothing for any other
/// text and for numbers out of range.
template <class Number>
[[nodiscard]] std::optional<Number> spelled(std::string_view text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

}  // namespace setae::bytes
