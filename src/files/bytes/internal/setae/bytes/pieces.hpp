// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/bytes/source.hpp"

namespace setae::bytes {

/// Bytes that stand side by side in a source.
struct Piece {
    std::uint64_t offset = 0, size = 0;
};

/// The pieces one after another, read from the source where asked.
/// @throws FormatError where the source ends before a piece does.
[[nodiscard]] Source joined(const Source& source, std::string name, const std::vector<Piece>& pieces);

}  // namespace setae::bytes
