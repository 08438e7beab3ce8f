// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// A soft flat against a sine wave with adhesion of no range (Johnson 1995).
namespace setae::contact::wavy {

/// Mean pressure at which the last gap closes by itself, over the pressure p* = E* q h/2 that makes full contact
/// without adhesion (h the amplitude):
///
///   p/p* = max over 0 < a < 1/2 of sin²(πa) − α √tan(πa),   α = 1/√(2π e)
///
/// e: energy stored in full contact over the work of adhesion, (E* q h²/8)/w, > 0; infinite: no adhesion. 1 without
/// adhesion; not positive where the contact closes without pressure, e <= closing_energy.
/// @throws InvalidArgument for e <= 0.
/// Source: Johnson, Int. J. Solids Struct. 32 (1995) 423.
[[nodiscard]] double closing_pressure(double energy_ratio);

/// e below which the contact closes by itself: 0.4901, α = 0.5699.
[[nodiscard]] double closing_energy();

}  // namespace setae::contact::wavy
