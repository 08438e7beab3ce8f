// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include "setae/core/text.hpp"

namespace setae {

/// The number at the beginning of a text, as std::from_chars reads it; the text is shortened by it. Empty, with the
/// text unchanged, if there is none or it is out of range.
template <class Number>
[[nodiscard]] std::optional<Number> leading(std::string_view& text) {
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{}) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return value;
}

/// The number that is the whole text; empty for any other text.
template <class Number>
[[nodiscard]] std::optional<Number> spelled(std::string_view text) {
    const auto value = leading<Number>(text);
    return text.empty() ? value : std::nullopt;
}

/// `count` numbers with a separator between them; blanks around them are ignored.
template <class Number, std::size_t count>
[[nodiscard]] std::optional<std::array<Number, count>> spelled_list(std::string_view text, char separator) {
    std::array<Number, count> numbers{};
    for (std::size_t i = 0; i < count; ++i) {
        const auto end = i + 1 < count ? text.find(separator) : text.size();
        const auto number =
            end == std::string_view::npos ? std::nullopt : spelled<Number>(trimmed(text.substr(0, end)));
        if (!number) return std::nullopt;
        numbers[i] = *number;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return numbers;
}

}  // namespace setae
