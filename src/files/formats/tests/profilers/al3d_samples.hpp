// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// An AL3D file: tags in addition to those of the image, which are made from the heights [m]; rows are padded with 1e9.
[[nodiscard]] std::string al3d_file(const Array2D& heights, std::vector<std::pair<std::string, std::string>> tags);

}  // namespace setae::formats::tests
