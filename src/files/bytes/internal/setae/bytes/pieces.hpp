// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// A contiguous range of bytes in a source.
struct Piece {
    std::uint64_t offset = 0, size = 0;
};

/// The pieces in sequence, read from the source on request.
/// @throws FormatError if the source ends before a piece does.
[[nodiscard]] Source joined(const Source& source, std::string name, const std::vector<Piece>& pieces);

}  // namespace setae::bytes
