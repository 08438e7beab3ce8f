// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// Upward direction.
enum class Up { hills = 1, dales = -1 };

/// The peak of a significant hill.
struct Peak {
    Index i, j;
    double height;  ///< of the map [m]
};

/// Peaks of the hills (pits of the dales) with a height of at least `least` [m] above their highest saddle and inside
/// the map; see FeatureParameters. In the order of the points.
[[nodiscard]] std::vector<Peak> significant_peaks(const topography::HeightMap& map, Up up, double least,
                                                  parallel::Threads threads = {});

}  // namespace setae::texture
