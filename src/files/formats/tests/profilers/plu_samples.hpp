// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// A PLu file of the kind numbered (1 profile, 3 topography), its layers' heights [µm] with NaN if undefined; 1.5 × 2
/// µm per pixel. Each layer has a picture after it.
[[nodiscard]] std::string plu_file(std::uint32_t kind, const std::vector<Array2D>& layers);

}  // namespace setae::formats::tests
