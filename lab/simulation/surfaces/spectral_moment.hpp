// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/quantity.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::simulation {

/// ∫ q^(n+1) C_iso dq [m^(2−n)] over a band that may begin at 0; C_iso is constant below 1/1000 of the roll-off.
/// Midpoints in ln q, 1000 a factor of e: to a relative 1e-6 where C_iso is smooth or bends.
[[nodiscard]] double spectral_moment(const spectra::SpectralDensity& C_iso, double order, double rolloff,
                                     const Band& band);

}  // namespace setae::simulation
