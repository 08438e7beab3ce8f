// SPDX-License-Identifier: GPL-3.0-or-later
#include "expression_text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include "setae/bytes/text.hpp"
#include "setae/core/number_text.hpp"
#include "setae/tables/header.hpp"

namespace setae::tables {
namespace {

bool in_name(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool in_number(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// A unit without blank and '*' behind a number, and the bytes it takes with the blank before it.
struct FoundUnit {
    Unit unit;
    std::size_t length = 0;
};

FoundUnit unit_behind(std::string_view text) {
    const std::size_t begin = text.starts_with(' ') ? 1 : 0;
    auto end = begin;
    const auto in_unit = [&](std::size_t at) {
        const auto byte = static_cast<unsigned char>(text[at]);
        return std::isalnum(byte) || byte >= 0x80 || text[at] == '/' || text[at] == '^' || text[at] == '%' ||
               (text[at] == '-' && at > 0 && text[at - 1] == '^');
    };
    while (end < text.size() && in_unit(end)) ++end;
    // "N/piezo" is a force over a column: without what follows its last '/'
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

ExpressionText expression_text(const std::string& text, std::size_t first) {
    ExpressionText result;
    for (std::size_t at = 0; at < text.size();) {
        const auto rest = std::string_view(text).substr(at);
        if (in_name(rest.front())) {
            std::size_t length = 1;
            while (length < rest.size() && (in_name(rest[length]) || in_number(rest[length]))) ++length;
            const std::string name(rest.substr(0, length));
            const bool function = rest.substr(length).starts_with('(') || name.front() == '_';
            if (!function && std::find(result.names.begin(), result.names.end(), name) == result.names.end())
                result.names.push_back(name);
            result.expression += name;
            at += length;
        } else if (in_number(rest.front())) {
            auto behind = rest;
            const auto number = leading<double>(behind);
            const auto found = unit_behind(behind);
            const auto length = rest.size() - behind.size();
            if (number && found.length > 0) {
                const auto name = fmt::format("quantity_{}", first + result.constants.size());
                result.constants.push_back({name, *number * found.unit.factor, found.unit.dimension});
                result.expression += name;
                at += length + found.length;
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
    for (const char c : bytes::lowered(header)) {
        if (in_name(c) || in_number(c)) name += c;
        else if (!name.empty() && name.back() != '_') name += '_';
    }
    while (name.ends_with('_')) name.pop_back();
    return name;
}

}  // namespace setae::tables
