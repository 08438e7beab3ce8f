// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace setae::bytes {

/// Levels that texts of structure (JSON, XML, TOML, YAML) may have one inside another. What measures and describes
/// surfaces has about ten; parsers and what walks through their results call themselves once a level.
inline constexpr std::size_t max_levels = 64;

/// The byte at which JSON opens one level more than max_levels; nothing where it never does. Brackets inside texts do
/// not count; text that is no JSON gives any answer.
[[nodiscard]] std::optional<std::uint64_t> json_too_deep(std::string_view text);

/// The same of XML and its elements; comments, sections of characters and instructions do not count.
[[nodiscard]] std::optional<std::uint64_t> xml_too_deep(std::string_view text);

/// The same of TOML: of arrays and inline tables, and of names with dots, "a.b.c", each of which opens a level.
[[nodiscard]] std::optional<std::uint64_t> toml_too_deep(std::string_view text);

}  // namespace setae::bytes
