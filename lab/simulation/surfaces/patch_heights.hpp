// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/numerics/random_numbers.hpp"
#include "setae/simulation/known_surface.hpp"
#include "setae/synthesis/height_transform.hpp"

namespace setae::simulation {

/// Converts heights of a patch of the Gaussian parent to those of the surface. The waves that are longer than the patch
/// determine its mean height, which is drawn here and subtracted again.
class PatchHeights {
public:
    /// patch_size: longest wavelength that the patch holds [m].
    PatchHeights(const KnownSurface& surface, double patch_size, numerics::RandomKey key);

    void operator()(double* heights, Index count) const;

private:
    synthesis::HeightTransform transform_;  ///< empty for Gaussian heights
    double rms_height_ = 0.0;
    double level_ = 0.0;
};

}  // namespace setae::simulation
