// SPDX-License-Identifier: GPL-3.0-or-later
#include "markup.hpp"

#include <cctype>
#include <cstddef>

namespace setae::figures {
namespace {

/// Bytes of the UTF-8 character text begins with; 0 where it begins with none or with a control character.
std::size_t character_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) return first < 0x20 || first == 0x7f ? 0 : 1;
    const std::size_t length = first >= 0xc2 && first < 0xe0 ? 2 : first >= 0xe0 && first < 0xf0 ? 3 : first >= 0xf0 && first < 0xf5 ? 4 : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
    const auto second = static_cast<unsigned char>(text[1]);
    const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
    return overlong || no_character ? 0 : length;
}

/// Takes the first character off text, escaped for gnuplot's markup inside single quotes.
std::string taken_character(std::string_view& text) {
    const auto length = character_length(text);
    std::string character(text.substr(0, length == 0 ? 1 : length));
    text.remove_prefix(character.size());
    if (length == 0) return " ";
    if (character == "'") return "''";
    if (std::string_view(R"({}^_@&~\)").find(character) != std::string_view::npos) return "\\" + character;
    return character;
}

std::string escaped(std::string_view text) {
    std::string result;
    while (!text.empty()) result += taken_character(text);
    return result;
}

/// What _ and ^ apply to: {group}, or letters and digits (ASCII, or any character beyond).
std::string_view taken_operand(std::string_view& text) {
    std::size_t end = 0;
    if (text.starts_with('{')) {
        const auto close = text.find('}');
        const auto group = text.substr(1, close == std::string_view::npos ? close : close - 1);
        text.remove_prefix(close == std::string_view::npos ? text.size() : close + 1);
        return group;
    }
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || static_cast<unsigned char>(text[end]) >= 0x80)) ++end;
    const auto word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
}

std::string typeset(std::string_view text) {
    std::string result;
    bool italic = false;
    while (!text.empty()) {
        const char first = text.front();
        if (first == '*') {
            text.remove_prefix(1);
            result += italic ? "}" : "{/:Italic ";
            italic = !italic;
        } else if (first == '_' || first == '^') {
            text.remove_prefix(1);
            result += std::string(1, first) + "{" + escaped(taken_operand(text)) + "}";
        } else {
            if (first == '\\' && text.size() > 1) text.remove_prefix(1);
            result += taken_character(text);
        }
    }
    return italic ? result + "}" : result;
}

/// One factor of a unit with its power: "m2" below the stroke is m^{−2}.
std::string typeset_factor(std::string_view factor, bool divided) {
    auto split = factor.size();
    while (split > 0 && std::isdigit(static_cast<unsigned char>(factor[split - 1]))) --split;
    const bool negative = split > 0 && split < factor.size() && factor[split - 1] == '-';
    auto base = factor.substr(0, negative ? split - 1 : split);
    std::string exponent(factor.substr(split));
    if (base.ends_with('^')) base.remove_suffix(1);
    if (divided && exponent.empty()) exponent = "1";
    if (divided != negative) exponent = "−" + exponent;
    const std::string micro = base.size() > 1 && base.starts_with('u') ? "µ" + escaped(base.substr(1)) : escaped(base);
    return exponent.empty() ? micro : micro + "^{" + exponent + "}";
}

std::string typeset_unit(std::string_view unit) {
    std::string result;
    bool divided = false;
    while (!unit.empty()) {
        const auto end = unit.find_first_of("/* ");
        const auto factor = unit.substr(0, end);
        if (!factor.empty() && factor != "1") result += (result.empty() ? "" : " ") + typeset_factor(factor, divided);
        if (end == std::string_view::npos) break;
        divided = divided || unit[end] == '/';
        unit.remove_prefix(end + 1);
    }
    return result;
}

}  // namespace

std::string quoted_verbatim(std::string_view text) { return "'" + escaped(text) + "'"; }

std::string quoted_bold(std::string_view text) { return "'{/:Bold " + escaped(text) + "}'"; }

std::string quoted_tick(std::string_view text) {
    std::string doubled;
    for (const char c : text) doubled += c == '%' ? "%%" : std::string(1, c);
    return quoted_verbatim(doubled);
}

std::string quoted_axis_title(std::string_view quantity, std::string_view unit) {
    const auto set = typeset_unit(unit);
    return "'" + typeset(quantity) + (set.empty() ? "" : " (" + set + ")") + "'";
}

}  // namespace setae::figures
