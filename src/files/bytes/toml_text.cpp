// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/toml_text.hpp"

#include <fmt/format.h>

namespace setae::bytes {

std::string toml_quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (c == '\n') result += "\\n";
        else if (byte < 0x20 || byte == 0x7f) result += fmt::format("\\u{:04X}", byte);
        else result += c;
    }
    return result + '"';
}

}  // namespace setae::bytes
