// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fields/option.hpp"

#include <fmt/format.h>

namespace setae::fields {

std::string help_of(const Option& option) {
    std::string text(option.meaning);
    if (!option.example.empty()) text += fmt::format(", such as \"{}\"", option.example);
    if (option.named_each_time) text += "; may be repeated";
    if (!option.otherwise.empty()) text += fmt::format("; default: {}", option.otherwise);
    return text;
}

std::string spelled(std::string_view message, const Spelling& spelling) {
    std::string text;
    while (true) {
        const auto begin = message.find('`');
        const auto end = begin == message.npos ? begin : message.find('`', begin + 1);
        if (end == message.npos) return text.append(message);
        const auto quoted = message.substr(begin + 1, end - begin - 1);
        const auto equals = quoted.find(" = ");
        const auto value = equals == quoted.npos ? std::string_view() : quoted.substr(equals + 3);
        const auto there = spelling(quoted.substr(0, equals), value);
        text.append(message.substr(0, begin))
            .append(there.empty() ? std::string(message.substr(begin, end + 1 - begin)) : there);
        message.remove_prefix(end + 1);
    }
}

}  // namespace setae::fields
