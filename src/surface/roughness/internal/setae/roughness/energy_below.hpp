// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/roughness/spectral_moments.hpp"

namespace setae::roughness {

/// U_el/(A E*) [m] of the waves below a wavevector [1/m], linear between the nodes of at least two; 0 and all beyond
/// the ends.
[[nodiscard]] double energy_below(const CumulativeParameters& cumulative, double wavevector);

}  // namespace setae::roughness
