// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// Variable parts of the objects of a SUR file; spacings 0.5 µm, 0.25 µm and 2 nm, z offset 3 nm.
struct SurObject {
    Array2D raw;  ///< h(x, y)
    std::uint16_t type = 2, objects = 1, channels = 1, bits = 16, special_points = 0, inversion = 0;
    int least = 0;
    std::string z_unit = "nm", comment = {}, private_zone = {};
    int streams = 0;  ///< 0: plain
    std::endian order = std::endian::little;
    bool dated = false;
    std::uint16_t acquisition = 0;
};

/// The bytes of an object.
[[nodiscard]] std::string sur_object(const SurObject& object);

}  // namespace setae::formats::tests
