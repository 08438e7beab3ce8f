// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/bytes/source.hpp"
#include "setae/formats/channel.hpp"

namespace setae::formats {

/// One byte per point of a map, rows from the top, that marks undefined heights.
struct PointMask {
    bytes::Source source;
    std::uint64_t offset = 0;        ///< of the first point
    std::uint64_t row_distance = 0;  ///< bytes between rows
    std::uint8_t bits = 0xff;        ///< bits that are evaluated
    std::uint8_t defined = 0;        ///< their value for a defined height
};

/// The channel of a map with the heights undefined that the mask marks.
/// @throws FormatError "<format>: …" now, if the mask is not completely in its source; (read) UndefinedDataError if no
/// height remains.
[[nodiscard]] Channel masked(Channel channel, const PointMask& mask);

}  // namespace setae::formats
