// SPDX-License-Identifier: GPL-3.0-or-later
#include "markup.hpp"

#include <array>
#include <cctype>
#include <cstddef>
#include <regex>

namespace setae::report {
namespace {

/// Bytes of the UTF-8 character text begins with; 0 where it begins with none.
std::size_t character_length(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xc2 && first < 0xe0 ? 2 : first >= 0xe0 && first < 0xf0 ? 3 : first >= 0xf0 && first < 0xf5 ? 4 : 0;
    if (length == 0 || length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
    const auto second = static_cast<unsigned char>(text[1]);
    const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
    const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
    return overlong || no_character ? 0 : length;
}

/// Takes the first character off text, escaped.
std::string taken_character(std::string_view& text) {
    const auto length = character_length(text);
    std::string character(text.substr(0, length == 0 ? 1 : length));
    text.remove_prefix(character.size());
    if (length == 0) return "\uFFFD";
    const auto first = static_cast<unsigned char>(character.front());
    if (first < 0x20 || first == 0x7f) return first == '\n' ? "\n" : " ";
    switch (first) {
        case '&': return "&amp;";
        case '<': return "&lt;";
        case '>': return "&gt;";
        case '"': return "&quot;";
        case '\'': return "&#39;";
        default: return character;
    }
}

/// What _ and ^ apply to: {group}, or letters and digits.
std::string_view taken_operand(std::string_view& text) {
    if (text.starts_with('{')) {
        const auto close = text.find('}');
        const auto group = text.substr(1, close == std::string_view::npos ? close : close - 1);
        text.remove_prefix(close == std::string_view::npos ? text.size() : close + 1);
        return group;
    }
    std::size_t end = 0;
    while (end < text.size() && (std::isalnum(static_cast<unsigned char>(text[end])) || static_cast<unsigned char>(text[end]) >= 0x80)) ++end;
    const auto word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
}

std::string set(std::string_view text, bool html) {
    std::string result;
    bool italic = false;
    while (!text.empty()) {
        const char first = text.front();
        if (first == '*') {
            text.remove_prefix(1);
            if (html) result += italic ? "</i>" : "<i>";
            italic = !italic;
        } else if (first == '_' || first == '^') {
            text.remove_prefix(1);
            const auto operand = escaped(taken_operand(text));
            const std::string tag = first == '_' ? "sub" : "sup";
            result += html ? "<" + tag + ">" + operand + "</" + tag + ">" : std::string(1, first) + operand;
        } else {
            if (first == '\\' && text.size() > 1) text.remove_prefix(1);
            result += taken_character(text);
        }
    }
    return italic && html ? result + "</i>" : result;
}

/// One factor of a unit with its power: "m2" below the stroke is m⁻².
std::string typeset_factor(std::string_view factor, bool divided) {
    auto split = factor.size();
    while (split > 0 && (std::isdigit(static_cast<unsigned char>(factor[split - 1])) || factor[split - 1] == '.')) --split;
    const bool negative = split > 0 && split < factor.size() && factor[split - 1] == '-';
    auto base = factor.substr(0, negative ? split - 1 : split);
    std::string exponent(factor.substr(split));
    if (base.ends_with('^')) base.remove_suffix(1);
    if (divided && exponent.empty()) exponent = "1";
    if (divided != negative) exponent = "-" + exponent;
    return (base.size() > 1 && base.starts_with('u') ? "µ" + escaped(base.substr(1)) : escaped(base)) + raised(exponent);
}

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    while (!text.empty()) result += taken_character(text);
    return result;
}

std::string prose(std::string_view text) {
    static const std::regex power("(^|[^A-Za-z0-9_./-])(-?[0-9]+(?:\\.[0-9]+)?)e([+-]?)0*([0-9]+)(?![A-Za-z0-9_./-]*[A-Za-z_/])");
    static const std::regex symbol("\\b(W|U|A|h|E|C)_(int|app|el|true|rms|loss|iso|1D)\\b");
    static const std::regex energy("\\bmJ/m2\\b");
    std::string whole = escaped(text), result;
    auto from = whole.cbegin();
    for (std::sregex_iterator found(whole.cbegin(), whole.cend(), power), end; found != end; ++found) {
        const auto& m = *found;
        result.append(from, m[0].first);
        result += m[1].str() + (m[2].str() == "1" ? "" : m[2].str() + "×") + "10" + raised((m[3].str() == "-" ? "-" : "") + m[4].str());
        from = m[0].second;
    }
    result.append(from, whole.cend());
    result = std::regex_replace(result, symbol, "<i>$1</i><sub>$2</sub>");
    return std::regex_replace(result, energy, "mJ\u00A0m⁻²");
}

std::string raised(std::string_view digits) {
    static constexpr std::array<const char*, 10> letters{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string result;
    for (const char c : digits) {
        if (c == '-') result += "⁻";
        else if (std::isdigit(static_cast<unsigned char>(c))) result += letters[static_cast<std::size_t>(c - '0')];
        else result += c;
    }
    return result;
}

std::string script_json(const workflow::Json& json) {
    std::string result;
    for (const char c : json.dump(-1, ' ', false, workflow::Json::error_handler_t::replace)) {
        if (c == '<') result += "\\u003c";
        else result += c;
    }
    return result;
}

std::string typeset(std::string_view quantity) { return set(quantity, true); }

std::string plain(std::string_view quantity) { return set(quantity, false); }

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

}  // namespace setae::report
