// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/numerics/random_numbers.hpp"
#include "setae/simulation/known_surface.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// A map slightly larger than the measurement.
struct PatchShape {
    Index nx = 0, ny = 0;
    double pixel = 0.0;   ///< [m]
    double window = 0.0;  ///< longest side of a measurement [m]; the map is longer
    Index lanes = 1;      ///< number of stripes along x, each at another position on the surface
    bool pointwise =
        false;  ///< waves shorter than two pixels are there, too, as white noise: for points read without a tip
};

/// A piece of a surface with all its waves down to two pixels, for measurements that keep away from its ends.
///
/// Short waves are periodic over the map. Where the spectrum is not yet flat at a sixth of the window (or of the map's
/// width), longer waves come from wider patches, the last one eight windows wide (LongWaves): a map of only this size
/// would have no wave between its modes, and none longer than itself, which dominate detrended scans. Waves longer than
/// eight windows are missing: in a window they are tilt and a parabola, with a remainder of 1e-3 of the power after
/// subtracting a parabola.
[[nodiscard]] topography::HeightMap window_patch(const KnownSurface& surface, const PatchShape& shape,
                                                 numerics::RandomKey key);

}  // namespace setae::simulation
