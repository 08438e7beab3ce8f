// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/roughness/spectral_moments.hpp"

namespace setae::roughness {

/// A self-affine spectrum told by three published moments and a short cutoff.
///
///   C_iso = C_r for q < q_r,  C_r (q/q_r)^(−2−2H) for q_r < q < q_s,  0 above
struct SelfAffineReconstruction {
    double hurst_exponent = 0.0;
    double rolloff_wavevector = 0.0;  ///< q_r [1/m]
    double plateau = 0.0;             ///< C_r [m⁴]
    double short_wavevector = 0.0;    ///< q_s [1/m]

    /// (1/2π) ∫ q^{order+1} C_iso dq from `lower` to q_s: order 0 is h_rms², 2 is h'², 4 is 4 h''².
    [[nodiscard]] double moment(double order, double lower = 0.0) const;

    /// The four parameters of the surface, wavevectors from `lower` [1/m] on. U_el/(A E*) = (1/8π) ∫ q² C_iso dq.
    [[nodiscard]] SpectralParameters parameters(double lower = 0.0) const;
};

/// The three parameters H, q_r, C_r that give exactly these rms height, slope and curvature (§ of SpectralParameters).
///
/// Domain: 0 < H < 2 and a roll-off between 2π/(1 m) and q_s; the moments of Table S1 of [D19] lie well inside.
/// Method: for each H the ratio slope/height fixes q_r (monotone, bracketed), the ratio curvature/slope then fixes H
/// (bracketed); C_r scales.
/// @throws InvalidArgument for values that are not positive, or that no such spectrum has.
[[nodiscard]] SelfAffineReconstruction reconstruct_self_affine(double rms_height, double rms_slope, double rms_curvature,
                                                               double short_wavevector);

}  // namespace setae::roughness
