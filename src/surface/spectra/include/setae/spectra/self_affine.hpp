// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// Isotropic self-affine surface with roll-off.
///
///   C_iso(q) = C_0                     for q < q_r
///            = C_0 (q/q_r)^(−2−2H)     for q_r <= q <= q_s,  0 above
struct SelfAffine {
    double plateau = 0.0;             ///< C_0 [m⁴]
    double rolloff_wavevector = 0.0;  ///< q_r [1/m]
    double hurst_exponent = 0.8;      ///< H, 0 < H < 1.5
    double short_wavevector = 0.0;    ///< q_s > q_r [1/m]
};

/// C_iso [m⁴]. @throws InvalidArgument for a model outside the domain above (all functions here).
[[nodiscard]] Array1D isotropic_power_spectrum(const SelfAffine& model, const ArrayView1D& wavevector);

/// C1D [m³] of line scans, by quadrature of the Abel integral, relative error below 1e-10.
[[nodiscard]] Array1D profile_power_spectrum(const SelfAffine& model, const ArrayView1D& wavevector);

/// ∫_0^∞ q^(n+1) C_iso dq [m^(2−n)], closed form, n > −2.
[[nodiscard]] double moment(const SelfAffine& model, double order);

[[nodiscard]] double rms_height(const SelfAffine& model);     ///< h_rms [m], ((1/2π) moment 0)^½
[[nodiscard]] double rms_slope(const SelfAffine& model);      ///< h'_rms, ((1/2π) moment 2)^½
[[nodiscard]] double rms_curvature(const SelfAffine& model);  ///< h''_rms [1/m], ((1/8π) moment 4)^½

/// The model with given height, slope and curvature, for a given q_s.
/// @throws InvalidArgument if no H in (0, 1.5) and q_r < q_s give them.
[[nodiscard]] SelfAffine self_affine_with_moments(double rms_height, double rms_slope, double rms_curvature,
                                                  double short_wavevector);

}  // namespace setae::spectra
