// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace setae {

/// Columns of a text on a screen: one per UTF-8 character, none for combining marks.
[[nodiscard]] std::size_t display_width(std::string_view text);

/// Text in lines of at most `width` characters, broken at blanks; lines after the first begin with `indent` blanks. A
/// word longer than a line is not broken. No line break at the end.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t width, std::size_t indent = 0);

/// Text that begins after `column` characters, in lines of at most `width` characters that also begin there.
[[nodiscard]] std::string wrapped_from(std::size_t column, std::string_view text, std::size_t width);

/// The beginning of a text, at most so many characters wide, with "…" if text is left out.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t width);

/// The end of a text, at most so many characters wide, after "…" if text is left out. It begins after a blank or a dot,
/// other than the dot of a number, where there is one.
[[nodiscard]] std::string last_words(std::string_view text, std::size_t width);

}  // namespace setae
