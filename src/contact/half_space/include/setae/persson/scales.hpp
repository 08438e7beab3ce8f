// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/half_space/body.hpp"
#include "setae/spectra/spectrum.hpp"

namespace setae::persson {

/// Full contact with the waves up to q, for increasing q: the scales of Persson's theory, ζ = q/q_0.
///
///   V(q) = (1/2π) ∫_{q_0}^{q} k² C_iso q' dq',   U(q) = (1/4π) ∫_{q_0}^{q} k C_iso q' dq'
///
/// k(q): half_space::stiffness, E* q/2 of a half-space, where V = E*² h'²/4 and U at the end of the band is
/// adhesion::stored_energy. V is the variance of the pressure, U the elastic energy per area.
struct Scales {
    Array1D wavevector;         ///< q [1/m], increasing from the lower to the upper end of the band
    Array1D stiffness;          ///< k [Pa/m]
    Array1D pressure_variance;  ///< V [Pa²]; 0 at the first q
    Array1D stored_energy;      ///< U [J/m²]; 0 at the first q
};

/// The scales of a spectrum, C_iso or C1D, at least a hundred per decade between power laws and finer where V begins.
///
/// @throws InvalidArgument for a body outside its domain, or a band without an end; UndefinedDataError as
/// roughness::cumulative_parameters.
/// Source: Persson, J. Chem. Phys. 115 (2001) 3840; layers: Carbone, Mangialardi, J. Mech. Phys. Solids 56 (2008) 684.
[[nodiscard]] Scales scales_of(const spectra::Spectrum& spectrum, const half_space::Body& body);

}  // namespace setae::persson
