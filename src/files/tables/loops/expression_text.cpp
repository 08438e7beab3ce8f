// SPDX-License-Identifier: GPL-3.0-or-later
#include "expression_text.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"
#include "setae/tables/header.hpp"

namespace setae::tables {
namespace {

bool in_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_number(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A unit without blank and '*' after a number, and its length including the blank before it.
struct FoundUnit {
    Unit unit;
    std::size_t length = 0;
};

FoundUnit unit_at_beginning(std::string_view text) {
    const std::size_t begin = text.starts_with(' ') ? 1 : 0;
    auto end = begin;
    const auto in_unit = [&](std::size_t at) {
        const auto byte = static_cast<unsigned char>(text[at]);
        return std::isalnum(byte) || byte >= 0x80 || text[at] == '/' || text[at] == '^' || text[at] == '%' ||
               (text[at] == '-' && at > 0 && text[at - 1] == '^');
    };
    while (end < text.size() && in_unit(end)) ++end;
    // "N/piezo" is a force over a column: the part after the last '/' is removed
    while (end > begin) {
        const auto unit = text.substr(begin, end - begin);
        if (!in_number(unit.front()))
            if (const auto known = try_parse_unit(unit)) return {*known, end};
        const auto slash = unit.rfind('/');
        end = slash == std::string_view::npos ? begin : begin + slash;
    }
    return {};
}

}  // namespace

namespace {

/// Length of a name and the unit in brackets after it.
struct FoundName {
    std::string name;
    std::optional<std::string> unit;
    std::size_t length = 0;
};

FoundName leading_name(std::string_view text) {
    FoundName found;
    while (found.length < text.size() && (in_name(text[found.length]) || in_number(text[found.length]))) ++found.length;
    found.name = text.substr(0, found.length);
    const auto close = text.find(']', found.length);
    if (!text.substr(found.length).starts_with('[') || close == std::string_view::npos) return found;
    found.unit = trimmed(text.substr(found.length + 1, close - found.length - 1));
    found.length = close + 1;
    return found;
}

void add_name(const FoundName& found, ExpressionText& result) {
    if (std::find(result.names.begin(), result.names.end(), found.name) == result.names.end())
        result.names.push_back(found.name);
    if (!found.unit) return;
    const auto [known, added] = result.units.emplace(found.name, *found.unit);
    if (!added && known->second != *found.unit)
        throw InvalidArgument(fmt::format("column '{}' has the units {} and {}; give one of them", found.name,
                                          known->second, *found.unit));
}

/// Letters without accents, so names may be typed as in the header; Å is a unit.
std::string with_plain_names(const std::string& text) {
    std::string plain;
    std::string_view rest = text;
    while (!rest.empty()) {
        const auto character = rest.substr(0, std::max<std::size_t>(utf8_length(rest), 1));
        rest.remove_prefix(character.size());
        const auto base = folded(character);
        const bool letter =
            character != "Å" && (base.empty() || (base.size() <= 2 && std::all_of(base.begin(), base.end(), in_name)));
        plain += character.size() > 1 && letter ? base : std::string(character);
    }
    return plain;
}

}  // namespace

ExpressionText expression_text(const std::string& typed, std::size_t first) {
    const auto text = with_plain_names(typed);
    ExpressionText result;
    for (std::size_t at = 0; at < text.size();) {
        const auto rest = std::string_view(text).substr(at);
        if (in_name(rest.front())) {
            const auto found = leading_name(rest);
            const bool function = rest.substr(found.length).starts_with('(') || found.name.front() == '_';
            if (!function) add_name(found, result);
            result.expression += found.name;
            at += found.length;
        } else if (in_number(rest.front())) {
            auto after_number = rest;
            const auto number = leading<double>(after_number);
            const auto unit = unit_at_beginning(after_number);
            const auto length = rest.size() - after_number.size();
            if (number && unit.length > 0) {
                const auto name = fmt::format("quantity_{}", first + result.constants.size());
                result.constants.push_back({name, *number * unit.unit.factor, unit.unit.dimension});
                result.expression += name;
                at += length + unit.length;
            } else {
                result.expression += rest.substr(0, std::max<std::size_t>(length, 1));
                at += std::max<std::size_t>(length, 1);
            }
        } else {
            result.expression += rest.front();
            ++at;
        }
    }
    return result;
}

std::string name_in_expressions(const std::string& header) {
    std::string name;
    for (const char c : folded(header)) {
        if (in_name(c) || in_number(c)) name += c;
        else if (!name.empty() && name.back() != '_') name += '_';
    }
    while (name.ends_with('_')) name.pop_back();
    return name;
}

}  // namespace setae::tables
