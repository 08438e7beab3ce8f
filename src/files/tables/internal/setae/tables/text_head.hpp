// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "setae/bytes/source.hpp"

namespace setae::tables {

inline constexpr std::uint64_t longest_text_head = 1 << 20;

/// The text at the beginning of a file before `marker`; only as much of the file is read as needed.
/// @throws FormatError "<format>: …" at the end of the search, if the marker is neither in the file nor in its first 1
/// MiB.
[[nodiscard]] std::string head_until(const bytes::Source& source, std::string_view marker, const std::string& format);

/// A number in a header. @throws FormatError "<format>: '<key>' is …" for text that is no finite number.
[[nodiscard]] double header_number(std::string_view text, std::string_view key, const bytes::Source& source,
                                   const std::string& format);

/// A number of points in a header, at least 1 and below 2^31.
[[nodiscard]] std::uint64_t header_count(std::string_view text, std::string_view key, const bytes::Source& source,
                                         const std::string& format);

}  // namespace setae::tables
