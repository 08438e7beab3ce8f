// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// One byte a point of a map, rows from the top, that tells which heights are none.
struct PointMask {
    bytes::Source source;
    std::uint64_t offset = 0;        ///< of the first point
    std::uint64_t row_distance = 0;  ///< bytes from row to row
    std::uint8_t bits = 0xff;        ///< that count
    std::uint8_t defined = 0;        ///< their value where a height is one
};

/// The channel of a map with the heights made undefined that the mask tells.
/// @throws FormatError "<format>: …" now, where the mask is not wholly in its source; (read) UndefinedDataError where
/// no height is left.
[[nodiscard]] Channel masked(Channel channel, const PointMask& mask);

}  // namespace setae::formats
