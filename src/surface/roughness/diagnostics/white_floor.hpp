// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::diagnostics {

/// A power law with a white floor under it, fitted to the upper end of a spectrum.
///
///   E(x) = A s(x) + N,  x = q/q_Nyquist,  s = x^−α, or with its aliases Σ_m |x + 2m|^−α
///
/// The fit maximises the likelihood of gamma variates, Σ −ν (ln E + P/E), over A, N >= 0 and 1 < α < 8, for either s.
/// The results are averaged with their likelihoods as weights, and their difference is part of the error.
struct WhiteFloor {
    double amplitude = 0.0;       ///< A [m³]
    double exponent = 0.0;        ///< α
    double level = 0.0;           ///< N [m³]
    double level_error = 0.0;     ///< standard error of N [m³], from the Fisher information and from both s
    double surface_at_end = 0.0;  ///< A s(1) [m³]
    double gain = 0.0;            ///< of the log likelihood over N = 0 with ν = 1, the smaller one of both s
};

/// x: increasing, in (0, 1].  power > 0 [m³].  freedom: ν of the noise part of each value; cautious_freedom: ν of its
/// surface part.
[[nodiscard]] WhiteFloor white_floor(const ArrayView1D& x, const ArrayView1D& power, double freedom,
                                     double cautious_freedom);

}  // namespace setae::diagnostics
