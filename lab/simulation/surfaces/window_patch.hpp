// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/numerics/random_numbers.hpp"
#include "setae/simulation/known_surface.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::simulation {

/// A map a little larger than what is measured on it.
struct PatchShape {
    Index nx = 0, ny = 0;
    double pixel = 0.0;   ///< [m]
    double window = 0.0;  ///< longest side of a measurement [m]; the map is longer
    Index lanes = 1;      ///< stripes along x, each of which lies elsewhere on the surface
    bool pointwise =
        false;  ///< waves shorter than two pixels are there, too, as white noise: for points read without a tip
};

/// A piece of a surface with all its waves down to two pixels, for measurements that keep off its ends.
///
/// Short waves are periodic over the map. Where the spectrum is not yet flat at a sixth of the window (or of the map's
/// width), longer waves come from wider patches, the last one eight windows wide (LongWaves): a map alone would have no
/// wave between its modes, and none longer than itself, which is what detrended scans show first. Waves longer than
/// eight windows are missing: in a window they are tilt and a parabola, and 1e-3 of the power a parabola leaves.
[[nodiscard]] topography::HeightMap window_patch(const KnownSurface& surface, const PatchShape& shape,
                                                 numerics::RandomKey key);

}  // namespace setae::simulation
