// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// MD5 digest as 32 lower-case hexadecimal digits: the checksum of X3P files, no protection against manipulation.
/// Source: RFC 1321.
[[nodiscard]] std::string md5(std::string_view bytes);
/// MD5 digest of a whole source, read piece by piece. @throws exceptions of the source.
[[nodiscard]] std::string md5(const Source& source);

/// SHA-256 digest as 64 lower-case hexadecimal digits. Source: FIPS 180-4.
[[nodiscard]] std::string sha256(std::string_view bytes);
/// SHA-256 digest of a whole source, read piece by piece. @throws exceptions of the source.
[[nodiscard]] std::string sha256(const Source& source);

}  // namespace setae::bytes
