// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/elasticity.hpp"
#include "setae/core/arrays.hpp"

/// Contact with adhesion of long range (Derjaguin, Muller, Toporov) of a sphere and an elastic half-space: Hertz's
/// contact under the force F + 2πRW.
///
/// Signs and limits as in jkr.hpp. Valid for contact radius << R and Tabor parameter << 1 (below about 0.1).
/// Sources: Derjaguin, Muller, Toporov, J. Colloid Interface Sci. 53 (1975) 314; Maugis, J. Colloid Interface Sci. 150
/// (1992) 243, the limit λ → 0.
namespace setae::contact::dmt {

/// Force F = 4E*a³/(3R) − 2πRW [N] in equilibrium at contact radius a [m], >= 0.
/// @throws InvalidArgument for a < 0 or a contact outside its domain.
[[nodiscard]] double force(double contact_radius, const AdhesiveContact& contact);

/// Displacement δ = a²/R [m] at contact radius a [m], >= 0.
/// @throws InvalidArgument for a < 0 or a contact outside its domain.
[[nodiscard]] double displacement(double contact_radius, const AdhesiveContact& contact);

/// Contact radius a = (3R(F + 2πRW)/4E*)^(1/3) [m] under force F [N]; NaN where no equilibrium exists, F < −2πRW.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double contact_radius_at_force(double force, const AdhesiveContact& contact);
[[nodiscard]] Array1D contact_radius_at_force(const ArrayView1D& force, const AdhesiveContact& contact);

/// Contact radius a = √(Rδ) [m] at displacement δ [m]; NaN for δ < 0, where the bodies do not touch.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double contact_radius_at_displacement(double displacement, const AdhesiveContact& contact);
[[nodiscard]] Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const AdhesiveContact& contact);

/// Force F = 4/3 E* √R δ^(3/2) − 2πRW [N] at displacement δ [m]; NaN for δ < 0.
[[nodiscard]] double force_at_displacement(double displacement, const AdhesiveContact& contact);
[[nodiscard]] Array1D force_at_displacement(const ArrayView1D& displacement, const AdhesiveContact& contact);

/// Displacement [m] under force F [N], through the contact radius; NaN for F < −2πRW.
[[nodiscard]] double displacement_at_force(double force, const AdhesiveContact& contact);
[[nodiscard]] Array1D displacement_at_force(const ArrayView1D& force, const AdhesiveContact& contact);

/// Separation, for a dead load and for an infinitely stiff machine: F = −2πRW, a = 0, δ = 0.
[[nodiscard]] ContactState pull_off(const AdhesiveContact& contact);

/// Work of adhesion W = |F|/(2πR) [J/m²] from the magnitude of the pull-off force [N].
/// @throws InvalidArgument for R <= 0 or a force that is no number.
[[nodiscard]] double work_of_adhesion_from_pull_off(double pull_off_force, double radius);

}  // namespace setae::contact::dmt
