// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/text.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace setae {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const auto first = text.find_first_not_of(blank);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        auto diagonal = std::exchange(row[0], i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const auto substitution = diagonal + std::size_t{a[i - 1] == b[j - 1] ? 0u : 1u};
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
        }
    }
    return row.back();
}

}  // namespace

std::string nearest_match(std::string_view word, std::span<const std::string> candidates) {
    std::string best;
    auto best_distance = std::max<std::size_t>(2, word.size() / 2) + 1;
    for (const auto& candidate : candidates) {
        const auto distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

std::size_t utf8_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xc2 && first < 0xe0   ? 2
                               : first >= 0xe0 && first < 0xf0 ? 3
                               : first >= 0xf0 && first < 0xf5 ? 4
                                                               : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
    const auto second = static_cast<unsigned char>(text[1]);
    const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
    return overlong || no_character ? 0 : length;
}

char32_t code_point(std::string_view character) {
    constexpr unsigned char first_bits[] = {0, 0x7f, 0x1f, 0x0f, 0x07};
    char32_t code = static_cast<unsigned char>(character.front()) & first_bits[character.size()];
    for (const char c : character.substr(1)) code = (code << 6) | (static_cast<unsigned char>(c) & 0x3f);
    return code;
}

namespace {

/// C0, C1, separators of lines and paragraphs, marks of direction.
bool controls(char32_t code) {
    return code < 0x20 || (code >= 0x7f && code < 0xa0) || (code >= 0x200e && code <= 0x200f) ||
           (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

/// Applies `change` to the bytes of every character; invalid UTF-8 becomes U+FFFD.
template <class Change>
std::string changed(std::string_view text, const Change& change) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const auto length = utf8_length(text);
        const auto character = text.substr(0, std::max<std::size_t>(1, length));
        result += length == 0 ? std::string_view("\uFFFD") : change(character);
        text.remove_prefix(character.size());
    }
    return result;
}

}  // namespace

namespace {

/// Letters U+00C0 to U+017F in lower case without accents; digits mean two letters.
constexpr std::string_view base_letters =
    "aaaaaa1ceeeeiiiidnooooo*ouuuuy42aaaaaa1ceeeeiiiidnooooo*ouuuuy4y"
    "aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiii55jjkkklllllll"
    "lllnnnnnnnnnoooooo33rrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs";
constexpr std::array<std::string_view, 5> letter_pairs{"ae", "ss", "oe", "th", "ij"};
constexpr char32_t first_letter = 0xc0, last_letter = 0x17f, first_accent = 0x300, last_accent = 0x36f;

}  // namespace

std::string folded(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const auto length = std::max<std::size_t>(utf8_length(text), 1);
        const auto character = text.substr(0, length);
        text.remove_prefix(length);
        const auto code = length > 1 ? code_point(character) : char32_t{0};
        if (code >= first_letter && code <= last_letter) {
            const char base = base_letters[code - first_letter];
            if (base >= '1' && base <= '5') result += letter_pairs[static_cast<std::size_t>(base - '1')];
            else result += base;
        } else if (code < first_accent || code > last_accent) {
            const char c = character.front();
            if (length == 1 && c >= 'A' && c <= 'Z') result += static_cast<char>(c - 'A' + 'a');
            else result += character;
        }
    }
    return result;
}

std::string valid_utf8(std::string_view text) {
    return changed(text, [](std::string_view character) { return character; });
}

std::string printable(std::string_view text) {
    return changed(text, [](std::string_view character) {
        const bool layout = character == "\n" || character == "\t";
        return !layout && controls(code_point(character)) ? std::string_view(" ") : character;
    });
}

std::string one_line(std::string_view text) {
    return changed(text, [](std::string_view character) {
        return controls(code_point(character)) ? std::string_view(" ") : character;
    });
}

std::string shell_word(std::string_view word) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./+,:@%=";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos) return std::string(word);
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

}  // namespace setae
