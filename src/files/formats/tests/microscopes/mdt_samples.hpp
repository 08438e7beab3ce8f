// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// A frame of type 0: steps of 2 nm along x and 0.003 µm along y, z of the step, offset and unit numbered (−1 nm, 1
/// nA).
[[nodiscard]] std::string mdt_scan(const Array2D& raw, float step, float offset, std::int16_t unit,
                                   const std::string& title);
/// A frame of type 1: a spectrum.
[[nodiscard]] std::string mdt_spectrum();
/// The file of some frames.
[[nodiscard]] std::string mdt_file(const std::vector<std::string>& frames);

}  // namespace setae::formats::tests
