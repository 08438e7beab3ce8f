// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/error_parts.hpp"

#include <charconv>

#include "setae/core/text.hpp"

namespace setae {
namespace {

/// A text that is a whole number and nothing else.
std::optional<std::uint64_t> whole_number(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    return failure == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

/// Removes the path and the position at the beginning of a message.
std::string_view without_place(std::string_view message, ErrorParts& parts) {
    constexpr std::string_view at_byte = "at byte ";
    const auto end = message.find(": ");
    if (end == std::string_view::npos) return message;
    auto path = message.substr(0, end);
    auto rest = message.substr(end + 2);
    if (const auto colon = path.rfind(':'); colon != std::string_view::npos) {
        parts.position.line = whole_number(path.substr(colon + 1));
        if (parts.position.line) path = path.substr(0, colon);
    }
    parts.file = path;
    if (rest.starts_with(at_byte)) {
        const auto stop = rest.find(": ");
        parts.position.offset = whole_number(rest.substr(at_byte.size(), stop - at_byte.size()));
        if (parts.position.offset) rest = rest.substr(stop + 2);
    }
    return rest;
}

}  // namespace

ErrorParts error_parts(std::string_view message, bool of_file) {
    constexpr std::string_view word = "expected ";
    ErrorParts parts;
    if (of_file) message = without_place(message, parts);
    const auto at = message.find(word);
    if (at == std::string_view::npos) return parts;
    auto got = trimmed(message.substr(0, at));
    while (!got.empty() && (got.back() == ';' || got.back() == ',')) got.remove_suffix(1);
    parts.got = got;
    const auto expected = message.substr(at + word.size());
    parts.expected = trimmed(expected.substr(0, expected.find(';')));
    return parts;
}

}  // namespace setae
