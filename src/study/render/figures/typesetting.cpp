// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/figures/typesetting.hpp"

#include <cctype>
#include <string>

#include <fmt/format.h>

#include "setae/core/display_unit.hpp"

namespace setae::figures {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Operand of _ and ^: {group}, or letters and digits (ASCII, or any character beyond).
std::string_view taken_operand(std::string_view& text) {
    if (text.starts_with('{')) {
        const auto close = text.find('}');
        const auto group = text.substr(1, close == std::string_view::npos ? close : close - 1);
        text.remove_prefix(close == std::string_view::npos ? text.size() : close + 1);
        return group;
    }
    std::size_t end = 0;
    while (end < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[end])) || static_cast<unsigned char>(text[end]) >= 0x80))
        ++end;
    const auto word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
}

UnitFactor factor_of(std::string_view factor, bool divided) {
    auto split = factor.size();
    while (split > 0 && (is_digit(factor[split - 1]) || factor[split - 1] == '.')) --split;
    const bool negative = split > 0 && split < factor.size() && factor[split - 1] == '-';
    auto symbol = factor.substr(0, negative ? split - 1 : split);
    std::string exponent(factor.substr(split));
    if (symbol.ends_with('^')) symbol.remove_suffix(1);
    if (divided && exponent.empty()) exponent = "1";
    if (divided != negative) exponent = "-" + exponent;
    const bool micro = symbol.size() > 1 && symbol.starts_with('u');
    return {micro ? "µ" + std::string(symbol.substr(1)) : std::string(symbol), exponent};
}

}  // namespace

std::vector<Span> spans_of(std::string_view quantity) {
    std::vector<Span> spans;
    bool italic = false;
    const auto letters = [&]() -> std::string& {
        if (spans.empty() || spans.back().italic != italic || spans.back().place != Span::Place::line)
            spans.push_back({"", italic, Span::Place::line});
        return spans.back().text;
    };
    while (!quantity.empty()) {
        const char first = quantity.front();
        quantity.remove_prefix(1);
        if (first == '*') {
            italic = !italic;
        } else if (first == '_' || first == '^') {
            spans.push_back({std::string(taken_operand(quantity)), italic,
                             first == '_' ? Span::Place::lowered : Span::Place::raised});
        } else if (first == '\\' && !quantity.empty()) {
            letters() += quantity.front();
            quantity.remove_prefix(1);
        } else {
            letters() += first;
        }
    }
    return spans;
}

std::string plain_text(std::string_view quantity) {
    std::string text;
    for (const auto& span : spans_of(quantity))
        text += (span.place == Span::Place::lowered ? "_" : span.place == Span::Place::raised ? "^" : "") + span.text;
    return text;
}

std::string_view symbol_of(std::string_view quantity) {
    const auto italic = quantity.find('*');
    const auto blank = quantity.substr(0, italic).rfind(' ');
    return italic == std::string_view::npos || blank == std::string_view::npos ? quantity : quantity.substr(blank + 1);
}

std::string number_text(double value, int digits) {
    const auto text = fmt::format("{:.{}g}", value, digits);
    const auto e = text.find('e');
    if (e == std::string::npos) return text;
    return text.substr(0, e) + "·10" + superscript(std::stoi(text.substr(e + 1)));
}

std::vector<UnitFactor> factors_of(std::string_view unit) {
    std::vector<UnitFactor> factors;
    bool divided = false;
    while (!unit.empty()) {
        const auto end = unit.find_first_of("/* ");
        const auto factor = unit.substr(0, end);
        if (!factor.empty() && factor != "1") factors.push_back(factor_of(factor, divided));
        if (end == std::string_view::npos) break;
        divided = divided || unit[end] == '/';
        unit.remove_prefix(end + 1);
    }
    return factors;
}

}  // namespace setae::figures
