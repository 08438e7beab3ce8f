// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/spreadsheet_text.hpp"

#include <algorithm>
#include <initializer_list>

#include "setae/core/text.hpp"

namespace setae {
namespace {

bool is_any(char32_t character, std::initializer_list<char32_t> of) {
    return std::find(of.begin(), of.end(), character) != of.end();
}

/// Blanks of every width, and invisible characters.
bool is_blank(char32_t character) {
    return character <= 0x20 || is_any(character, {0x7f, 0xa0, 0xad, 0x1680, 0x202f, 0x205f, 0x2060, 0x3000, 0xfeff}) ||
           (character >= 0x2000 && character <= 0x200f);
}

bool begins_formula(std::string_view text) {
    while (!text.empty()) {
        const auto length = utf8_length(text);
        if (length == 0) return false;
        const auto character = code_point(text.substr(0, length));
        if (!is_blank(character))
            return is_any(character, {U'=', U'+', U'-', U'@', U'＝', U'＋', U'－', U'＠', U'﹦', U'﹢', U'﹣', U'﹫'});
        text.remove_prefix(length);
    }
    return false;
}

}  // namespace

std::string spreadsheet_cell(std::string_view text) {
    auto line = one_line(text);
    if (begins_formula(line)) line.insert(line.begin(), '\'');
    if (line.find_first_of(",\"") == std::string::npos) return line;
    std::string quoted = "\"";
    for (const char letter : line) quoted += letter == '"' ? "\"\"" : std::string(1, letter);
    return quoted + '"';
}

}  // namespace setae
