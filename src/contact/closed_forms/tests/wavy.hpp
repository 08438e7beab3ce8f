// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/numerics/bracketing.hpp"
#include "setae/numerics/minimum.hpp"

/// A soft flat against a sine wave with adhesion of no range (Johnson 1995).
namespace setae::contact::wavy {

/// Mean pressure at which the last gap closes by itself, over the pressure p* = E* q h/2 that makes full contact
/// without adhesion (h the amplitude):
///
///   p/p* = max over 0 < a < 1/2 of sin²(πa) − α √tan(πa),   α = 1/√(2π e)
///
/// e: energy stored in full contact over the work of adhesion, (E* q h²/8)/w, > 0; infinite: no adhesion. 1 without
/// adhesion; not positive where the contact closes without pressure, e <= closing_energy.
/// Source: Johnson, Int. J. Solids Struct. 32 (1995) 423.
inline double closing_pressure(double energy_ratio) {
    if (std::isinf(energy_ratio)) return 1.0;
    const double alpha = 1.0 / std::sqrt(2.0 * pi * energy_ratio);
    // beyond a = 1/4 the curve has one maximum, the last before full contact
    const auto less = [alpha](double a) { return alpha * std::sqrt(std::tan(pi * a)) - std::pow(std::sin(pi * a), 2); };
    constexpr int bits = 50;
    return -numerics::minimum_between(less, 0.25, 0.5 - 1e-9, bits).value;
}

/// e below which the contact closes by itself: 0.4901, α = 0.5699.
inline double closing_energy() {
    static const double energy = [] {
        constexpr int bits = 50;
        return numerics::bracketed_root([](double e) { return closing_pressure(e); }, 0.3, 0.8, bits);
    }();
    return energy;
}

}  // namespace setae::contact::wavy
