// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace setae::bytes {

/// Maximum nesting of structured text (JSON, XML, TOML, YAML). Files of measured surfaces have about ten levels;
/// parsers and functions for their results recurse once per level.
inline constexpr std::size_t max_levels = 64;

/// The byte at which JSON exceeds max_levels; empty if it does not. Brackets inside texts are ignored; the result is
/// undefined for text that is no JSON.
[[nodiscard]] std::optional<std::uint64_t> json_too_deep(std::string_view text);

/// The byte at which XML elements exceed max_levels; comments, CDATA sections and instructions are ignored.
[[nodiscard]] std::optional<std::uint64_t> xml_too_deep(std::string_view text);

/// The byte at which TOML exceeds max_levels, by arrays, inline tables, and names with dots, "a.b.c", each of which
/// opens a level.
[[nodiscard]] std::optional<std::uint64_t> toml_too_deep(std::string_view text);

}  // namespace setae::bytes
