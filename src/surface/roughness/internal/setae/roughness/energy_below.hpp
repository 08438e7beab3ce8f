// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/roughness/spectral_moments.hpp"

namespace setae::roughness {

/// U_el/(A E*) [m] of the waves below a wavevector [1/m], linear between at least two nodes; 0 below the first and the
/// total beyond the last.
[[nodiscard]] double energy_below(const CumulativeParameters& cumulative, double wavevector);

}  // namespace setae::roughness
