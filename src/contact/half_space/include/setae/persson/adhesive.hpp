// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/persson/scales.hpp"

namespace setae::persson {

struct AdhesiveOptions {
    /// α of σ_a² = 2α k(q) γ_eff, > 0: 1/2 is a penny-shaped crack as wide as the wave is long, G = 2σ² a/(πE*) with a
    /// = π/q. The theory does not determine this factor of order one.
    double crack_factor = 0.5;
    int max_rounds = 400;
    double tolerance = 1e-6;  ///< change of γ_eff per iteration, divided by w
};

/// Contact under adhesion of zero range, with the waves up to each q.
///
///   σ_a(q) = √(2α k(q) γ_eff(q))                 tension that separates a contact with γ_eff at the scale q
///   A(q)   by stress_diffusion() with that σ_a    area fraction
///   A(q) γ_eff(q) = w A(q_1) − ∫_q^{q_1} A dU     effective work: shorter waves reduce w and store energy
///
/// U: Scales::stored_energy; q_1: end of the band. For full contact γ_eff(q) = w − U(q_1) + U(q): Persson–Tosatti
/// balance, scale by scale. w is per projected area: slopes are small. Where the balance would be negative γ_eff is 0,
/// and for w = 0 the contact is that of contact_at_scales(). The three equations are iterated from full contact, so
/// that of several solutions that with most contact is found: that of retraction, not of approach.
struct AdhesiveContactAtScales {
    Array1D area_fraction;
    Array1D effective_work;     ///< γ_eff [J/m²]
    Array1D detachment_stress;  ///< σ_a [Pa]
    int rounds = 0;
    bool converged = false;
};

/// pressure: p_0 [Pa], of either sign.  work_of_adhesion: w [J/m²], >= 0.
/// @throws InvalidArgument outside the domain.
/// Source: Persson, Eur. Phys. J. E 8 (2002) 385; Persson, Surf. Sci. Rep. 61 (2006) 201, section 8.
[[nodiscard]] AdhesiveContactAtScales adhesive_contact_at_scales(double pressure, double work_of_adhesion,
                                                                 const Scales& scales,
                                                                 const AdhesiveOptions& options = {});

}  // namespace setae::persson
