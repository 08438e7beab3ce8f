// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/persson/scales.hpp"

/// Persson's theory of the elastic contact of a randomly rough surface without adhesion.
namespace setae::persson {

/// Probability density [1/Pa] of the pressure p > 0 in contact with waves of pressure variance V under the mean
/// pressure p_0 > 0, the solution of ∂P/∂V = ½ ∂²P/∂p² with P(0) = 0 and all of the area at p_0 for V = 0:
///
///   P = (exp(−(p − p_0)²/2V) − exp(−(p + p_0)²/2V))/√(2πV)
///
/// ∫ P dp over p > 0 is the area in contact, ∫ p P dp = p_0.
/// @throws InvalidArgument for a mean pressure or a variance that is not positive.
/// Source: Persson, J. Chem. Phys. 115 (2001) 3840.
[[nodiscard]] double pressure_density(double pressure, double mean_pressure, double pressure_variance);

/// Area in contact divided by the nominal area, erf(p_0/√(2V)): √(8/π) p_0/(E* h') at low load on a half-space.
/// @throws as pressure_density, but V = 0 is full contact, 1.
[[nodiscard]] double area_fraction(double mean_pressure, double pressure_variance);

/// γ of the stored energy of partial contact as found for self-affine surfaces.
/// Source: Yang, Persson, J. Phys.: Condens. Matter 20 (2008) 215214.
inline constexpr double usual_energy_factor = 0.45;

/// A contact with only the waves up to each q; the last entry is the contact with the whole spectrum.
///
///   U = ∫ W dU_full,   W = A (γ + (1 − γ) A²)
///   mean gap ū = ∫_{p_0}^∞ (dU/dp) dp/p,   stiffness K = −dp/dū = p_0/(dU/dp)
///
/// A: area fraction at that q; U_full: Scales::stored_energy. p = −dU/dū: the work of the load on approach is stored. γ
/// = 1 assumes the energy density of full contact on the area in contact (Persson 2007); the area does not depend on
/// it. At low load ū = u_0 ln(p_c/p_0) and K = p_0/u_0, u_0 = γ √(2/π) ∫ dh'/q on a half-space.
struct ContactAtScales {
    Array1D area_fraction;
    Array1D stored_energy;      ///< U [J/m²]
    Array1D mean_gap;           ///< ū [m]; 0 at the first q
    Array1D contact_stiffness;  ///< K [Pa/m]; infinite in full contact
};

/// pressure: p_0 [Pa], > 0.  energy_factor: γ, in (0, 1].
/// @throws InvalidArgument outside the domain.
/// Source: Persson, Phys. Rev. Lett. 99 (2007) 125502; Yang, Persson (2008).
[[nodiscard]] ContactAtScales contact_at_scales(double pressure, const Scales& scales,
                                                double energy_factor = usual_energy_factor);

}  // namespace setae::persson
