// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/parallel/for_each.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::adhesion {

/// Elastic energy per apparent area [J/m²] of a half-space in full contact with an isotropic rough surface.
///
///   U_el/A_app = (E*/8) ∫ q C1D dq = (E*/8π) ∫ q² C_iso dq
///
/// contact_modulus: E* [Pa], > 0; conversion: of C1D curves, exact or by Eq. 11.  Source: [D19], Eq. 8; THEORY §4.1,
/// §7.
[[nodiscard]] double stored_energy(double contact_modulus, const spectra::Spectrum& curve,
                                   roughness::Conversion conversion = roughness::Conversion::exact);

/// U_el/A_app = (E*/4) Σ_q |q| |h_q|² over the Fourier modes of a map, taken as one period; waves of any direction,
/// without the assumption of isotropy.
///
/// Non-periodic maps are detrended by their best plane and windowed (Hann) as in spectra. A cosine of amplitude h0
/// gives E* q h0²/8.
/// @throws UndefinedDataError for maps with undefined heights.  Source: THEORY §7.
[[nodiscard]] double stored_energy(double contact_modulus, const topography::HeightMap& map,
                                   parallel::Threads threads = {});

/// Upper bound E* h_rms h'_rms/4 of U_el/A_app for any spectrum (Cauchy–Schwarz). Source: THEORY §7.
[[nodiscard]] double stored_energy_bound(double contact_modulus, double rms_height, double rms_slope);

}  // namespace setae::adhesion
