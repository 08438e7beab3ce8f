// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/layout.hpp"

#include <algorithm>

#include "setae/core/text.hpp"

namespace setae {
namespace {

bool combines(char32_t code) { return code >= 0x300 && code < 0x370; }

/// Whether a blank, or a dot that is not in a number, is before this place.
bool begins_word(std::string_view text, std::size_t at) {
    const char before = text[at - 1];
    return before == ' ' || (before == '.' && !(text[at] >= '0' && text[at] <= '9'));
}

/// Bytes of the next character; 1 for invalid UTF-8.
std::size_t step_of(std::string_view text) { return std::max<std::size_t>(utf8_length(text), 1); }

}  // namespace

std::size_t display_width(std::string_view text) {
    std::size_t width = 0;
    while (!text.empty()) {
        const auto length = utf8_length(text);
        if (length == 0 || !combines(code_point(text.substr(0, length)))) ++width;
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return width;
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
    std::string result, line;
    for (std::size_t at = 0; at < text.size();) {
        const auto end = std::min(text.find(' ', at), text.size());
        const auto word = text.substr(at, end - at);
        at = end + 1;
        if (word.empty()) continue;
        const bool begins = line.find_first_not_of(' ') == std::string::npos;
        if (!begins && display_width(line) + 1 + display_width(word) > width) {
            result += line + "\n";
            line = std::string(indent, ' ');
            line += word;
        } else {
            line += begins ? "" : " ";
            line += word;
        }
    }
    return result + line;
}

std::string wrapped_from(std::size_t column, std::string_view text, std::size_t width) {
    std::string result;
    for (const char c : wrapped(text, width > column ? width - column : 1)) {
        result += c;
        if (c == '\n') result.append(column, ' ');
    }
    return result;
}

std::string shortened(std::string_view text, std::size_t width) {
    if (display_width(text) <= width) return std::string(text);
    std::string result;
    for (std::size_t taken = 0; taken + 1 < width; ++taken) {
        const auto length = step_of(text);
        result += text.substr(0, length);
        text.remove_prefix(length);
    }
    return result + "…";
}

std::string last_words(std::string_view text, std::size_t width) {
    if (display_width(text) <= width) return std::string(text);
    std::size_t begin = 0;
    while (display_width(text.substr(begin)) >= std::max<std::size_t>(width, 1)) begin += step_of(text.substr(begin));
    for (std::size_t at = std::max<std::size_t>(begin, 1); at < text.size(); ++at)
        if (begins_word(text, at)) return "…" + std::string(text.substr(at));
    return "…" + std::string(text.substr(begin));
}

}  // namespace setae
