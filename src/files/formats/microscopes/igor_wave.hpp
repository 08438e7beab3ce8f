// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "setae/bytes/source.hpp"
#include "storage/raster.hpp"

namespace setae::formats {

/// What the headers of an Igor binary wave say: its numbers, their scale and units, and where note and labels lie.
struct IgorWave {
    int version = 0;  ///< 2 (one dimension) or 5 (up to four)
    std::endian order = std::endian::little;
    std::string name;
    Sample sample = Sample::float32;
    std::uint64_t data_at = 0;
    std::array<std::uint64_t, 4> points{};  ///< along each dimension, the first the fastest; 0: none
    std::array<double, 4> step{};           ///< a point's distance to the next, in units
    std::array<std::string, 4> units;       ///< of the dimensions; empty: nobody said
    std::string data_unit;
    std::uint32_t created = 0;  ///< seconds since 1904 in local time; 0: nobody said
    std::string note;
    std::array<std::vector<std::string>, 4> labels;  ///< of the points along each dimension; empty: none

    [[nodiscard]] std::uint64_t count() const;
};

/// Byte order where the head is that of an Igor binary wave of version 1, 2, 3 or 5 whose checksum is right.
[[nodiscard]] std::optional<std::endian> igor_order(std::string_view head);

/// @throws FormatError "Igor: …" for a version other than 2 and 5, text or complex numbers, headers that contradict one
/// another, or a file that ends before its numbers, note or labels do.
[[nodiscard]] IgorWave igor_wave(const bytes::Source& source);

}  // namespace setae::formats
