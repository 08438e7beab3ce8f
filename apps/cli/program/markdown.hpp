// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::cli {

/// Text in a cell of a table of Markdown.
[[nodiscard]] inline std::string markdown_cell(const std::string& text) {
    std::string result;
    for (const char character : text) result += character == '|' ? std::string("\\|") : std::string(1, character);
    return result;
}

}  // namespace setae::cli
