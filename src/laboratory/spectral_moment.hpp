// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/synthesis/spectral_density.hpp"

namespace setae::laboratory {

/// ∫ q^(n+1) C_iso dq [m^(2−n)] from 0 to an upper end; C_iso is constant below the roll-off. Midpoints in ln q, 1000 a
/// factor of e: to a relative 1e-6 where C_iso is smooth or bends.
[[nodiscard]] double spectral_moment(const synthesis::SpectralDensity& C_iso, double order, double rolloff, double upper);

}  // namespace setae::laboratory
