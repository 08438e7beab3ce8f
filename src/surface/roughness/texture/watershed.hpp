// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

/// Which way is up.
enum class Up { hills = 1, dales = -1 };

/// The peak of a hill that counts.
struct Peak {
    Index i, j;
    double height;  ///< of the map [m]
};

/// Peaks of the hills (pits of the dales) that rise over their highest saddle by at least `least` [m] and lie inside
/// the map; see FeatureParameters. In the order of the points.
[[nodiscard]] std::vector<Peak> significant_peaks(const topography::HeightMap& map, Up up, double least,
                                                  parallel::Threads threads = {});

}  // namespace setae::texture
