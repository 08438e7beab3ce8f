// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sample_files.hpp"
#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

using namespace setae::tests;

/// Members of an archive of the nanomeasuring machine: scans of the same shape with heights [m], 0.5 µm × 2 µm per
/// pixel.
[[nodiscard]] Members nmm_members(const std::vector<Array2D>& scans);

}  // namespace setae::formats::tests
