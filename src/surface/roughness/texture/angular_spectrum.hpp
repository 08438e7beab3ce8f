// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::texture {

struct StrongestDirection {
    double angle = 0.0;           ///< of the wavevectors against x [rad], 0 <= angle < π
    double directionality = 1.0;  ///< largest over mean angular spectrum
};

/// The direction of the waves with the most power: see SpatialParameters.
[[nodiscard]] StrongestDirection strongest_direction(const topography::HeightMap& map, double mean,
                                                     parallel::Threads threads);

}  // namespace setae::texture
