// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace setae::imaging {

/// Checksum of a chunk's kind and content: CRC-32 of ISO 3309. Source: PNG specification (third edition), annex D.
[[nodiscard]] std::uint32_t png_checksum(std::string_view bytes);

/// Whether every chunk up to IEND exists with its checksum. Otherwise libpng is not called, because it prints errors.
[[nodiscard]] bool png_is_whole(std::string_view png);

/// Content of the first chunk of a kind; empty if there is none. The file must be complete.
[[nodiscard]] std::string_view png_chunk(std::string_view png, std::string_view kind);

}  // namespace setae::imaging
