// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/spectra/log_grid.hpp"
#include "setae/spectra/options.hpp"
#include "setae/spectra/spectrum.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::spectra {

/// C_iso of a map: mean of C2D over all (q_x, q_y) with |q| in a bin of the grid, from 2π/max(L_x, L_y) to the smaller
/// Nyquist wavevector.
///
///   C2D(q) = |h̃(q)|²/A,  h̃ = ∫∫ w h exp(−iq·r) d²r
///
/// The wavevector of a bin is the mean |q| of its members, the count that of (q_x, q_y) of both signs; bins without a
/// member are left out. Additional memory: the half spectrum.
/// @throws UndefinedDataError if a height is undefined.
/// Source: [J17].
[[nodiscard]] MeasuredSpectrum isotropic_power_spectrum(const topography::HeightMap& map,
                                                        const SpectrumOptions& options = {}, const LogGrid& grid = {});

/// Elastic energy of a half-space in full contact with the waves of a map, over area and modulus,
///
///   U_el/(A E*) = ¼ Σ |q| |h_q|²    [m]
///
/// over its modes inside a band of |q| [1/m], h_q the amplitude of exp(iq·r): Eq. (8) of [D19] without the assumption
/// of isotropy. One wave A cos(q·r) has |q| A²/8.
/// @throws as isotropic_power_spectrum.
/// Source: [D19] Eq. (8); Persson, Tosatti, J. Chem. Phys. 115 (2001) 5597.
[[nodiscard]] double energy_per_modulus_of_modes(const topography::HeightMap& map, const Band& band,
                                                 const SpectrumOptions& options = {});

/// C2D [m⁴] on the full grid of modes, shape (nx, ny), entry (k, m) at q_x = 2πk/L_x for k <= nx/2, 2π(k − nx)/L_x
/// above.
[[nodiscard]] Array2D power_spectrum_map(const topography::HeightMap& map, const SpectrumOptions& options = {});

}  // namespace setae::spectra
