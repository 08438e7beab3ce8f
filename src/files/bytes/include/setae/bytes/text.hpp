// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace setae::bytes {

/// Encoding of a text whose bytes do not state it.
enum class Encoding { detect, utf8, utf16, latin1 };

/// Bytes of a text as UTF-8 with '\n' line ends, without byte order mark.
[[nodiscard]] std::string decoded(std::string bytes, Encoding encoding);

/// The text of a field of fixed width: up to its first zero, Latin-1 or UTF-8 converted to UTF-8.
[[nodiscard]] std::string field_text(std::string_view bytes);

/// UTF-16 code units up to the first zero as UTF-8; invalid code units become U+FFFD.
[[nodiscard]] std::string utf16_field_text(std::string_view bytes, bool big_endian);

/// Whether bytes can be text: a UTF-16 byte order mark, or no control characters except white space.
[[nodiscard]] bool looks_like_text(std::string_view bytes);

/// ASCII letters in lower case.
[[nodiscard]] std::string lowered(std::string_view text);

[[nodiscard]] std::vector<std::string_view> split_lines(std::string_view text);

/// The number of a cell: true with NaN for an empty cell and for words for a missing value ("nan", "N/A", "null",
/// "bad", "-", "***", "1.#QNAN", spreadsheets' "#NV", "#N/A" …); false for any other text that is no number.
[[nodiscard]] bool parse_cell(std::string_view cell, char decimal_point, double& value);

}  // namespace setae::bytes
