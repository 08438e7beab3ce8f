// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::contact {

/// One term of E(t)/E∞ = 1 + Σ g e^(−t/τ), Prony's series.
struct RelaxationTerm {
    double share = 0.0;  ///< g, >= 0
    double time = 0.0;   ///< τ [s], > 0
};

/// A contact in time, from the jump in to separation.
struct ContactHistory {
    Array1D time;            ///< [s], increasing; the first is that of the jump in
    Array1D displacement;    ///< δ [m], from first contact of the undeformed bodies
    Array1D contact_radius;  ///< [m]: increases to the turn and decreases after it
    Index turn = 0;          ///< the sample at which the hold begins
};

/// Additional force of a relaxing bulk relative to an elastic sphere [N] at every time of a history.
///
///   F₁(t) = E∞ Σ g 2∫₀^a [u(x, t) − z(x, t)] dx + (E∞ − E*) 2∫₀^a u dx,  ∂z/∂t = (u − z)/τ,  u = δ − x²/R
///
/// E* is the modulus measured on loading. E∞ follows from loading at a constant rate of a³ with duration T:
/// E* = E∞ [1 + Σ g (τ/T)(1 − e^(−T/τ))]. Contact radius and displacement are given and exact; an element x of the body
/// is in contact from the time at which the contact reaches it until it leaves it. ν constant; history.turn ends the
/// loading.
///
/// contact_modulus: E* [Pa].
/// @throws InvalidArgument for R, E* <= 0, terms outside their domains, a time that does not increase.
/// Source: Lee, Radok, J. Appl. Mech. 27 (1960) 438; Popov, Heß, Method of Dimensionality Reduction (2015), ch. 7
/// (independent elements x).
[[nodiscard]] Array1D relaxation_force(const ContactHistory& history, double radius, double contact_modulus,
                                       const std::vector<RelaxationTerm>& terms);

/// ∮ F₁ dδ [J]: energy loss of the loop by bulk relaxation, at given radii and displacements. Relaxation at the edge
/// itself, on closing and opening, is part of the measured W_app and W_ret.
/// @throws as relaxation_force().
[[nodiscard]] double relaxation_loss(const ContactHistory& history, double radius, double contact_modulus,
                                     const std::vector<RelaxationTerm>& terms);

}  // namespace setae::contact
