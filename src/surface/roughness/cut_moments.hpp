// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "setae/core/arrays.hpp"
#include "setae/core/quantity.hpp"

namespace setae::roughness {

/// C1D = level · (q/left)^exponent from left to right; right may be infinite.
struct LinePiece {
    double left, right, level, exponent;
};

/// ∫_a^b q^n C_iso dq for n = 1, 2, 3, 5 of the isotropic surface whose lines have this C1D, its waves cut to a … b:
///
///   C_iso(q) = −2 ∫_q^∞ C1D'(s) ds/√(s² − q²)
///   ∫_a^b q^n C_iso dq = −2 ∫_a^∞ C1D'(s) K_n(s) ds,   K_n(s) = ∫_a^{min(s, b)} q^n dq/√(s² − q²)
///
/// C1D at s contains waves of all |q| > s, so the identities ∫_0^∞ q^{n+1} C_iso dq = π k_n ∫_0^∞ q^n C1D dq are not
/// valid between limits. pieces: in order, without gaps, to infinity or to the end of C1D; parts below a are not used.
/// Relative error 1e-8.  Source: Bracewell (2000), ch. 13; exchanged integrals derived here.
struct CutMoments {
    double first = 0.0, second = 0.0, third = 0.0, fifth = 0.0;
};
[[nodiscard]] CutMoments cut_moments(std::span<const LinePiece> pieces, const Band& band);

}  // namespace setae::roughness
