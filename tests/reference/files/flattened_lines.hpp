// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/processing/level.hpp"

namespace setae::tests {

/// A map without the best polynomial of this degree of every line along x.
inline topography::HeightMap flattened_lines(topography::HeightMap map, Index degree) {
    auto level = processing::apply(processing::LevelLines{.degree = degree}, std::move(map));
    return std::get<topography::HeightMap>(std::move(level.measurement));
}

}  // namespace setae::tests
