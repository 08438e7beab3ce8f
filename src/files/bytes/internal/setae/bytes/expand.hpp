// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// The most bytes that compressed ones may become: 8 MiB and a hundredfold. Measured surfaces compress less; what
/// expands more is an attack, or a map of one value.
[[nodiscard]] constexpr std::uint64_t max_expanded(std::uint64_t compressed) {
    return (std::uint64_t{8} << 20) + 100 * compressed;
}

/// The same of text, which compresses less: 32 MiB and thirty-twofold.
[[nodiscard]] constexpr std::uint64_t max_expanded_text(std::uint64_t compressed) {
    return (std::uint64_t{32} << 20) + 32 * compressed;
}

/// The content of a zlib or gzip stream; bytes behind it are left alone.
/// @throws FormatError "<format>: …" at `offset`, where the stream stands in its source, for one that is damaged, ends
/// early or becomes more than max_expanded. Once `enough` bytes are there it stops, and nothing behind them is looked
/// at.
[[nodiscard]] std::string inflated(std::string_view stream, const Source& source, std::uint64_t offset,
                                   const std::string& format,
                                   std::uint64_t enough = std::numeric_limits<std::uint64_t>::max());

/// The content of a Zstandard stream; otherwise as inflated.
[[nodiscard]] std::string expanded_zstd(std::string_view stream, const Source& source, std::uint64_t offset,
                                        const std::string& format);

/// The first `count` bytes of a Zstandard stream of which `stream` may be only a part, or all where there are fewer.
/// @throws FormatError for a damaged stream.
[[nodiscard]] std::string expanded_zstd_head(std::string_view stream, std::uint64_t count, const Source& source,
                                             std::uint64_t offset, const std::string& format);

/// Whether bytes begin as gzip.
[[nodiscard]] bool is_gzip(std::string_view head);

/// What a gzip file holds, under the file's own name; any other source as it is. @throws as inflated.
[[nodiscard]] Source unpacked(const Source& source);

}  // namespace setae::bytes
