// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/spectra/self_affine.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::spectra {

/// Self-affine spectrum with a gradual cutoff.
///
///   C_iso(q) = C_0 max(1, q/q_r)^(−2−2H) exp(−(q/q_s)²)
struct SoftCutoff {
    double plateau = 0.0;             ///< C_0 [m⁴]
    double rolloff_wavevector = 0.0;  ///< q_r [1/m]
    double hurst_exponent = 0.8;      ///< H, in (0, 1]
    double short_wavevector = 0.0;    ///< q_s > q_r [1/m], where C_iso is 1/e of the power law
};

/// Two self-affine ranges that meet at a crossover.
///
///   C_iso(q) = C_0                                          q < q_r
///            = C_0 (q/q_r)^(−2−2H)                          q_r <= q < q_x
///            = C_0 (q_x/q_r)^(−2−2H) (q/q_x)^(−2−2H_x)      q_x <= q <= q_s,  0 above
struct TwoSlopes {
    double plateau = 0.0;               ///< C_0 [m⁴]
    double rolloff_wavevector = 0.0;    ///< q_r [1/m]
    double hurst_exponent = 0.8;        ///< H of the longer wavelengths, in (0, 1]
    double crossover_wavevector = 0.0;  ///< q_x [1/m], q_r < q_x < q_s
    double short_hurst_exponent = 0.8;  ///< H_x of the shorter wavelengths, in (0, 1]
    double short_wavevector = 0.0;      ///< q_s [1/m]
};

/// A log-normal bump on a self-affine spectrum: grains of one size, a machining mark.
///
///   C_iso(q) = C_self-affine(q) (1 + b exp(−ln²(q/q_b)/(2 w²)))
struct Bump {
    SelfAffine base;
    double excess = 0.0;      ///< b, > −1: relative height of the bump
    double wavevector = 0.0;  ///< q_b [1/m]
    double width = 0.3;       ///< w, > 0, in ln q
};

/// C_iso [m⁴] of a model.
/// @throws InvalidArgument for parameters outside the domains above, with the contradiction.
[[nodiscard]] SpectralDensity density(const SoftCutoff& model);
[[nodiscard]] SpectralDensity density(const TwoSlopes& model);
[[nodiscard]] SpectralDensity density(const Bump& model);

}  // namespace setae::spectra
