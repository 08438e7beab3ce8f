// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/file_names.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "setae/core/text.hpp"

namespace setae::output {
namespace {

// with prefixes and suffixes, names stay below the 255 bytes of common file systems
constexpr std::size_t max_bytes = 120;

/// Letters beyond ASCII, by their position in Unicode: without signs, blanks, punctuation and private characters.
bool is_letter_beyond_ascii(std::string_view character) {
    constexpr std::string_view no_letters[][2] = {
        {"\u0080", "\u00bf"}, {"\u00d7", "\u00d7"}, {"\u00f7", "\u00f7"},        {"\u2000", "\u206f"},
        {"\u20a0", "\u2bff"}, {"\u3000", "\u3004"}, {"\ue000", "\uf8ff"},        {"\ufe00", "\ufe0f"},
        {"\ufeff", "\ufeff"}, {"\ufff0", "\uffff"}, {"\U000e0000", "\U0010ffff"}};
    // bytes of UTF-8 are in the order of the characters
    return character.size() > 1 && std::none_of(std::begin(no_letters), std::end(no_letters), [&](const auto& range) {
               return character >= range[0] && character <= range[1];
           });
}

/// One name by itself.
std::string readable(std::string_view name) {
    std::string result;
    while (!name.empty()) {
        const auto length = std::max<std::size_t>(1, utf8_length(name));
        const auto character = name.substr(0, length);
        const auto first = static_cast<unsigned char>(character.front());
        const bool kept = first < 0x80
                              ? std::isalnum(first) || std::string_view("-_.").find(character) != std::string_view::npos
                              : is_letter_beyond_ascii(character);
        if (result.size() + length > max_bytes) break;
        result += kept ? character : std::string_view("_");
        name.remove_prefix(length);
    }
    return result.empty() ? "_" : result;
}

/// The name without case, for file systems that ignore case.
std::string folded(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
        return c < 0x80 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c);
    });
    return name;
}

}  // namespace

std::vector<std::string> file_names(std::span<const std::string> names) {
    std::vector<std::string> result(names.size());
    std::set<std::string> taken;
    const auto take = [&](std::size_t i, const std::string& name) {
        if (!taken.insert(folded(name)).second) return false;
        result[i] = name;
        return true;
    };
    // a valid file name is unchanged
    for (std::size_t i = 0; i < names.size(); ++i)
        if (readable(names[i]) == names[i]) take(i, names[i]);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!result[i].empty()) continue;
        const auto name = readable(names[i]);
        for (int number = 1; result[i].empty(); ++number)
            take(i, number == 1 ? name : fmt::format("{}_{}", name, number));
    }
    return result;
}

}  // namespace setae::output
