// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "periodic_patch.hpp"

namespace setae::synthesis {

/// A periodic patch on the plane, rotated.
struct Octave {
    double cosine = 1.0, sine = 0.0;  ///< of the patch's first axis
    double period = 0.0;              ///< [m]
    PeriodicPatch patch;
};

/// Mean squares of height [m²] and slope.
struct ScaleMoments {
    double height = 0.0, slope = 0.0;
};

}  // namespace setae::synthesis
