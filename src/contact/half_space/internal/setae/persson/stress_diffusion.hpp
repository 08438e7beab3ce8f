// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::persson {

/// Loss of contact as waves are added that separate where their tension exceeds the adhesive limit.
struct StressDiffusion {
    Array1D area_fraction;  ///< at each scale
    Array1D pressure;       ///< [Pa], from −σ_a on, at the last scale; empty where contact is full or lost
    Array1D density;        ///< [1/Pa] of the pressure there
};

/// Area in contact where pressures diffuse and those below −σ_a are lost, by finite volumes.
///
///   ∂P/∂V = ½ ∂²P/∂p²,   P(−σ_a(V), V) = 0,   P = δ(p − p_0) at V = 0,   A = ∫_{−σ_a}^∞ P dp
///
/// For constant σ_a A = erf((p_0 + σ_a)/√(2V)). In y = (p + σ_a)/√V and ln V the equation is one of drift and
/// diffusion, solved by Scharfetter and Gummel's fluxes and the trapezoidal rule; it begins with the solution of
/// constant σ_a where less than 1e-7 of the area is lost, at the first scale at the latest. Against the closed form the
/// area holds 1e-4, by the second order in both steps.
///
/// pressure_variance V [Pa²]: 0, then rising; scales that add nothing repeat it.  detachment_stress: σ_a [Pa], >= 0, at
/// the same scales.  mean_pressure: p_0 [Pa], of either sign; contact is lost at the first scale where p_0 + σ_a <= 0
/// if all area is still at p_0 there.
/// @throws InvalidArgument for arrays of different length or a variance that falls.
/// Source: Persson, Eur. Phys. J. E 8 (2002) 385; fluxes: Scharfetter, Gummel, IEEE Trans. Electron Devices 16
/// (1969) 64. Cost: 700 cells a scale.
[[nodiscard]] StressDiffusion stress_diffusion(const ArrayView1D& pressure_variance,
                                               const ArrayView1D& detachment_stress, double mean_pressure);

}  // namespace setae::persson
