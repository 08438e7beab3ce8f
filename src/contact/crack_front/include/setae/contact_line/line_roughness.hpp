// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact_line/contact_line.hpp"
#include "setae/core/estimate.hpp"

namespace setae::contact_line {

/// Fitted part of the spectrum of a line.
struct RoughnessBand {
    Index smallest_mode = 3;  ///< n: 1 is the position of the centre, 2 an ellipse
    Index largest_mode = 0;   ///< 0: N/4
};

/// Roughness of a line, averaged over frames.
///
/// With r_n = (1/N) Σ_j r_j exp(−2πi jn/N)
///
///   power_n = ⟨|r_n|²⟩ = A n^−(1 + 2ζ) + σ²/N,  σ: place_error
///   structure(Δθ) = ⟨(r(θ + Δθ) − r(θ))²⟩^½ ∝ Δθ^ζ for 0 < ζ < 1
///
/// ζ is the line's roughness exponent: 0.39 for a quasi-static elastic line with the long-range elasticity of cracks
/// (Rosso, Krauth, Phys. Rev. E 65 (2002) 025101), 1/2 for a random walk.
struct LineRoughness {
    Array1D mode, power;                        ///< n = 1 … N/2; ⟨|r_n|²⟩ [m²]
    Array1D lag, structure;                     ///< Δθ = 2πk/N, k = 1 … N/2 [rad]; [m], without n = 1, 2
    Estimate exponent;                          ///< ζ
    double amplitude = 0.0;                     ///< A [m²]
    Index smallest_mode = 0, largest_mode = 0;  ///< band of the fit
};

/// ζ and A by Whittle's likelihood of the modes of the band, each of which is exponentially distributed about its
/// expectation: Σ_n ln P_n + power_n/P_n is minimised. The standard error is the delete-one jackknife over at most 16
/// blocks of consecutive frames, because frames close in time are nearly equal; it is missing for fewer than two
/// frames. @throws InvalidArgument as require_valid, or for a band of fewer than 4 modes or beyond N/2.
/// @throws UndefinedDataError where the line is not rougher than its noise.
/// Source: Whittle, Ark. Mat. 2 (1953) 423.
[[nodiscard]] LineRoughness line_roughness(const ContactLine& line, const RoughnessBand& band = {});

}  // namespace setae::contact_line
