// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Maximum number of bytes after expansion: 8 MiB plus a hundredfold. Measured surfaces compress less; larger expansion
/// is an attack, or a map of one value.
[[nodiscard]] constexpr std::uint64_t max_expanded(std::uint64_t compressed) {
    return (std::uint64_t{8} << 20) + 100 * compressed;
}

/// Maximum number of bytes of text after expansion, which compresses less: 32 MiB plus thirty-twofold.
[[nodiscard]] constexpr std::uint64_t max_expanded_text(std::uint64_t compressed) {
    return (std::uint64_t{32} << 20) + 32 * compressed;
}

/// The content of a zlib or gzip stream; bytes after it are ignored. @throws FormatError "<format>: …" at `offset`, the
/// place of the stream in its source, for a stream that is damaged, ends early or expands to more than max_expanded.
/// Expansion stops after `enough` bytes, and the rest is not checked.
[[nodiscard]] std::string inflated(std::string_view stream, const Source& source, std::uint64_t offset,
                                   const std::string& format,
                                   std::uint64_t enough = std::numeric_limits<std::uint64_t>::max());

/// The content of a Zstandard stream; otherwise as inflated.
[[nodiscard]] std::string expanded_zstd(std::string_view stream, const Source& source, std::uint64_t offset,
                                        const std::string& format);

/// The first `count` bytes of a Zstandard stream, or all bytes of a shorter one; `stream` may be only a part of it.
/// @throws FormatError for a damaged stream.
[[nodiscard]] std::string expanded_zstd_head(std::string_view stream, std::uint64_t count, const Source& source,
                                             std::uint64_t offset, const std::string& format);

/// Whether bytes begin as gzip.
[[nodiscard]] bool is_gzip(std::string_view head);

/// The content of a gzip file, with the name of the file; any other source is returned unchanged. @throws as inflated.
[[nodiscard]] Source unpacked(const Source& source);

}  // namespace setae::bytes
