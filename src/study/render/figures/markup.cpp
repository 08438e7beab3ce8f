// SPDX-License-Identifier: GPL-3.0-or-later
#include "markup.hpp"

#include <fmt/format.h>

#include "drawn_characters.hpp"
#include "setae/core/text.hpp"
#include "setae/figures/typesetting.hpp"

namespace setae::figures {
namespace {

/// Takes the first character off text, escaped for gnuplot's markup inside single quotes.
std::string taken_character(std::string_view& text) {
    const auto length = utf8_length(text);
    std::string character(text.substr(0, length == 0 ? 1 : length));
    text.remove_prefix(character.size());
    const auto first = static_cast<unsigned char>(character.front());
    if (length == 0 || first < 0x20 || first == 0x7f) return " ";
    if (character == "'") return "''";
    if (!is_drawn(character)) return "□";
    if (std::string_view(R"({}^_@&~\)").find(character) != std::string_view::npos) return "\\" + character;
    return character;
}

std::string escaped(std::string_view text) {
    std::string result;
    while (!text.empty()) result += taken_character(text);
    return result;
}

std::string typeset(std::string_view quantity) {
    std::string result;
    bool italic = false;
    const auto turn = [&](bool wanted) {
        if (wanted != italic) result += wanted ? "{/:Italic " : "}";
        italic = wanted;
    };
    for (const auto& span : spans_of(quantity)) {
        turn(span.italic);
        const auto text = escaped(span.text);
        result +=
            span.place == Span::Place::line ? text : (span.place == Span::Place::lowered ? "_{" : "^{") + text + "}";
    }
    turn(false);
    return result;
}

std::string typeset_unit(std::string_view unit) {
    std::string result;
    for (const auto& factor : factors_of(unit)) {
        result += (result.empty() ? "" : " ") + escaped(factor.symbol);
        const bool negative = factor.exponent.starts_with('-');
        if (!factor.exponent.empty())
            result += fmt::format("^{{{}{}}}", negative ? "−" : "", factor.exponent.substr(negative ? 1 : 0));
    }
    return result;
}

/// Markup in gnuplot's quotes. Release 5.4 ends a text at two apostrophes in a row, and at one next to the text's own:
/// an empty group separates them.
std::string in_quotes(std::string markup) {
    constexpr std::string_view apostrophe = "''", two = "''''";
    for (auto at = markup.find(two); at != std::string::npos; at = markup.find(two, at)) markup.insert(at + 2, "{}");
    return "'" + std::string(markup.starts_with(apostrophe) ? "{}" : "") + markup +
           (markup.ends_with(apostrophe) ? "{}" : "") + "'";
}

}  // namespace

std::string quoted_verbatim(std::string_view text) { return in_quotes(escaped(text)); }

std::string quoted_heading(std::string_view letter, std::string_view words) {
    if (letter.empty()) return in_quotes("{/:Bold " + escaped(words) + "}");
    return in_quotes("{/:Bold " + escaped(letter) + "}" + (words.empty() ? "" : "  " + escaped(words)));
}

std::string quoted_tick(std::string_view text) {
    std::string doubled;
    for (const char c : text) doubled += c == '%' ? "%%" : std::string(1, c);
    return quoted_verbatim(doubled);
}

std::string quoted_axis_title(std::string_view quantity, std::string_view unit) {
    const auto set = typeset_unit(unit);
    return in_quotes(typeset(quantity) + (set.empty() ? "" : " (" + set + ")"));
}

}  // namespace setae::figures
