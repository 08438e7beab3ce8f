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

/// A contact in time, from the jump in to parting.
struct ContactHistory {
    Array1D time;            ///< [s], rising; the first is that of the jump in
    Array1D displacement;    ///< δ [m], from first touch of the undeformed bodies
    Array1D contact_radius;  ///< [m]: rises to the turn and falls behind it
    Index turn = 0;          ///< the sample at which the hold begins
};

/// Force beside that of an elastic sphere [N] at every time of a history, the bulk relaxing as its terms say.
///
///   F₁(t) = E∞ Σ g 2∫₀^a [u(x, t) − z(x, t)] dx + (E∞ − E*) 2∫₀^a u dx,  ∂z/∂t = (u − z)/τ,  u = δ − x²/R
///
/// E* is what loading shows. E∞ is that with which loading at a constant rate of a³, which takes T, shows it:
/// E* = E∞ [1 + Σ g (τ/T)(1 − e^(−T/τ))]. Contact radius and displacement are taken as given, and exactly; an element x
/// of the body touches from when the contact has reached it until it has left it. ν constant; history.turn ends the
/// loading.
///
/// contact_modulus: E* [Pa].
/// @throws InvalidArgument for R, E* <= 0, terms outside their domains, a time that does not rise.
/// Source: Lee, Radok, J. Appl. Mech. 27 (1960) 438; Popov, Heß, Method of Dimensionality Reduction (2015), ch. 7
/// (every element x by itself).
[[nodiscard]] Array1D relaxation_force(const ContactHistory& history, double radius, double contact_modulus,
                                       const std::vector<RelaxationTerm>& terms);

/// ∮ F₁ dδ [J]: what the loop loses because the bulk relaxes, at given radii and displacements. What relaxes at the
/// edge itself, as it closes and opens, is in W_app and W_ret as they are measured.
/// @throws as relaxation_force().
[[nodiscard]] double relaxation_loss(const ContactHistory& history, double radius, double contact_modulus,
                                     const std::vector<RelaxationTerm>& terms);

}  // namespace setae::contact
