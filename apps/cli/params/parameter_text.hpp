// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/answers/texture.hpp"

namespace setae::cli {

/// "md", "tsv", "latex" or "text", whose lines have at most `width` characters. TSV contains SI numbers, the others
/// numbers with prefixes for readers.
[[nodiscard]] std::string parameter_text(const std::vector<answers::MeasuredTexture>& list, const std::string& format,
                                         std::size_t width);

/// The page docs/reference/parameters.md from the table of parameters, up to its marker.
[[nodiscard]] std::string parameter_page();

/// The page with the text after its marker in `existing`.
[[nodiscard]] std::string parameter_page(const std::string& existing);

}  // namespace setae::cli
