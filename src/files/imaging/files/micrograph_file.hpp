// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Number of bytes used to detect a picture.
inline constexpr std::uint64_t picture_head_bytes = 2048;

/// Whether bytes begin as a file that read_micrograph can read.
[[nodiscard]] bool is_micrograph(std::string_view head);

/// read_micrograph of an open file, possibly in memory.
[[nodiscard]] Micrograph read_micrograph_file(const bytes::Source& file, const MicrographOptions& options);

}  // namespace setae::imaging
