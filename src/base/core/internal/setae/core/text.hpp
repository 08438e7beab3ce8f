// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace setae {

/// Text without leading and trailing white space (blank, tab, carriage return, line feed).
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The candidate with the smallest edit distance to `word`, for "did you mean"; empty where none is within half its
/// length.
[[nodiscard]] std::string nearest_match(std::string_view word, std::span<const std::string> candidates);

/// Bytes of the UTF-8 character that text, not empty, begins with; 0 where it begins with none. Source: RFC 3629.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// The number in Unicode of a character that utf8_length() has taken for one.
[[nodiscard]] char32_t code_point(std::string_view character);

/// Latin letters in lower case without accents, for comparing words: "Déplacement" is "deplacement", "Größe" "grosse".
[[nodiscard]] std::string folded(std::string_view text);

/// Text whose bytes that are no UTF-8 have become U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// Text that a terminal shows as it stands: valid UTF-8, with a blank for each control character but line feed and tab,
/// and for each mark that turns the direction of writing.
[[nodiscard]] std::string printable(std::string_view text);
/// The same on one line: line feeds and tabs are blanks, too.
[[nodiscard]] std::string one_line(std::string_view text);

/// A word as a POSIX shell takes it: in single quotes where it needs them.
[[nodiscard]] std::string shell_word(std::string_view word);

}  // namespace setae
