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

/// Header of an Igor binary wave: its numbers, their scale and units, and the places of note and labels.
struct IgorWave {
    int version = 0;  ///< 2 (one dimension) or 5 (up to four)
    std::endian order = std::endian::little;
    std::string name;
    Sample sample = Sample::float32;
    std::uint64_t data_at = 0;
    std::array<std::uint64_t, 4> points{};  ///< along each dimension, the first the fastest; 0: none
    std::array<double, 4> step{};           ///< distance of neighbouring points, in units
    std::array<std::string, 4> units;       ///< of the dimensions; empty: not given
    std::string data_unit;
    std::uint32_t created = 0;  ///< seconds since 1904 in local time; 0: not given
    std::string note;
    std::array<std::vector<std::string>, 4> labels;  ///< of the points along each dimension; empty: none

    [[nodiscard]] std::uint64_t count() const;
};

/// Byte order if the head is that of an Igor binary wave of version 1, 2, 3 or 5 with a correct checksum.
[[nodiscard]] std::optional<std::endian> igor_order(std::string_view head);

/// @throws FormatError "Igor: …" for a version other than 2 and 5, text or complex numbers, contradictory headers, or a
/// file that ends before its numbers, note or labels.
[[nodiscard]] IgorWave igor_wave(const bytes::Source& source);

}  // namespace setae::formats
