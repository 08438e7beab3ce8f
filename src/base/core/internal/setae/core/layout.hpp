// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace setae {

/// Characters that a text takes on a screen: one for each of UTF-8, none for marks that combine.
[[nodiscard]] std::size_t display_width(std::string_view text);

/// Text in lines of at most so many characters, broken at blanks; lines after the first begin with `indent` blanks. A
/// word longer than a line stays whole. Without a line break at the end.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

/// Text that begins behind so many characters, in lines of at most `width` characters that begin there, too.
[[nodiscard]] std::string wrapped_from(std::size_t column, std::string_view text, std::size_t width);

/// The beginning of a text that takes at most so many characters, with "…" where something is left out.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t width);

}  // namespace setae
