// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace setae {

/// Text without leading and trailing white space (blank, tab, carriage return, line feed).
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The candidate with the smallest edit distance to `word`, for "did you mean"; empty if none is within half its
/// length.
[[nodiscard]] std::string nearest_match(std::string_view word, std::span<const std::string> candidates);

/// Bytes of the UTF-8 character at the beginning of a non-empty text; 0 if there is none. Source: RFC 3629.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Unicode code point of a character accepted by utf8_length().
[[nodiscard]] char32_t code_point(std::string_view character);

/// Latin letters in lower case without accents, for comparing words: "Déplacement" becomes "deplacement", "Größe"
/// becomes "grosse".
[[nodiscard]] std::string folded(std::string_view text);

/// Text with U+FFFD instead of bytes that are not UTF-8.
[[nodiscard]] std::string valid_utf8(std::string_view text);

/// Text safe for a terminal: valid UTF-8, with a blank for each control character except line feed and tab, and for
/// each mark that changes the direction of writing.
[[nodiscard]] std::string printable(std::string_view text);
/// Text safe for a terminal on one line: line feeds and tabs become blanks, too.
[[nodiscard]] std::string one_line(std::string_view text);

/// A word for a POSIX shell: in single quotes if needed.
[[nodiscard]] std::string shell_word(std::string_view word);

}  // namespace setae
