// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// MD5 digest as 32 lower-case hexadecimal digits: the checksum X3P files carry, no protection against intent.
/// Source: RFC 1321.
[[nodiscard]] std::string md5(std::string_view bytes);
/// Of a whole source, read piece by piece. @throws what reading it throws.
[[nodiscard]] std::string md5(const Source& source);

/// SHA-256 digest as 64 lower-case hexadecimal digits. Source: FIPS 180-4.
[[nodiscard]] std::string sha256(std::string_view bytes);
/// Of a whole source, read piece by piece. @throws what reading it throws.
[[nodiscard]] std::string sha256(const Source& source);

}  // namespace setae::bytes
