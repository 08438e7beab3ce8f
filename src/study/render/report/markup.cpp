// SPDX-License-Identifier: GPL-3.0-or-later
#include "markup.hpp"

#include <array>
#include <cctype>
#include <regex>

#include <nlohmann/json.hpp>

#include "setae/core/text.hpp"
#include "setae/figures/typesetting.hpp"

namespace setae::report {
namespace {

/// Takes the first character off text, escaped.
std::string taken_character(std::string_view& text) {
    const auto length = utf8_length(text);
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

}  // namespace

std::string escaped(std::string_view text) {
    std::string result;
    while (!text.empty()) result += taken_character(text);
    return result;
}

std::string prose(std::string_view text) {
    static const std::regex power(
        "(^|[^A-Za-z0-9_./-])(-?[0-9]+(?:\\.[0-9]+)?)e([+-]?)0*([0-9]+)(?![A-Za-z0-9_./-]*[A-Za-z_/])");
    static const std::regex symbol("\\b(W|U|A|h|E|C)_(int|app|ret|x|el|true|rms|loss|iso|1D)\\b");
    static const std::regex energy("\\bmJ/m(?:2\\b|²)");
    std::string whole = escaped(text), result;
    auto from = whole.cbegin();
    for (std::sregex_iterator found(whole.cbegin(), whole.cend(), power), end; found != end; ++found) {
        const auto& m = *found;
        result.append(from, m[0].first);
        result += m[1].str() + (m[2].str() == "1" ? "" : m[2].str() + "×") + "10" +
                  raised((m[3].str() == "-" ? "-" : "") + m[4].str());
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

std::string script_json(const output::Json& json) {
    std::string result;
    for (const char c : json.dump(-1, ' ', false, output::Json::error_handler_t::replace)) {
        if (c == '<') result += "\\u003c";
        else result += c;
    }
    return result;
}

std::string typeset(std::string_view quantity) {
    std::string result;
    for (const auto& span : figures::spans_of(quantity)) {
        auto text = escaped(span.text);
        if (span.place != figures::Span::Place::line) {
            const std::string tag = span.place == figures::Span::Place::lowered ? "sub" : "sup";
            text = "<" + tag + ">" + text + "</" + tag + ">";
        }
        result += span.italic ? "<i>" + text + "</i>" : text;
    }
    return result;
}

std::string plain(std::string_view quantity) {
    std::string result;
    for (const auto& span : figures::spans_of(quantity)) {
        if (span.place != figures::Span::Place::line) result += span.place == figures::Span::Place::lowered ? "_" : "^";
        result += escaped(span.text);
    }
    return result;
}

std::string typeset_unit(std::string_view unit) {
    std::string result;
    for (const auto& factor : figures::factors_of(unit))
        result += (result.empty() ? "" : " ") + escaped(factor.symbol) + raised(factor.exponent);
    return result;
}

}  // namespace setae::report
