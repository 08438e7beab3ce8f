// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/elasticity.hpp"
#include "setae/core/arrays.hpp"

/// Contact with adhesion of infinitely short range (Johnson, Kendall, Roberts) of a sphere and an elastic half-space.
///
/// Signs: F > 0 presses, δ > 0 is penetration beyond first contact of the undeformed bodies. W = 0 is Hertz's contact.
/// Valid for contact radius << R and Tabor parameter >> 1.
/// Sources: Johnson, Kendall, Roberts, Proc. R. Soc. A 324 (1971) 301; Maugis, Contact, Adhesion and Rupture of Elastic
/// Solids (2000), ch. 4; Dalvi et al., PNAS 116 (2019) 25484, Eqs. 1, S1, S2.
namespace setae::contact::jkr {

using Contact = AdhesiveContact;
using State = ContactState;
using contact::Branch;

/// Force F = 4E*a³/(3R) − √(8πE*W a³) [N] in equilibrium at contact radius a [m], >= 0.
/// @throws InvalidArgument for a < 0 or a contact outside its domain.
[[nodiscard]] double force(double contact_radius, const Contact& contact);

/// Displacement δ = a²/R − √(2πaW/E*) [m] in equilibrium at contact radius a [m], >= 0.
/// @throws InvalidArgument for a < 0 or a contact outside its domain.
[[nodiscard]] double displacement(double contact_radius, const Contact& contact);

/// Contact radius [m] under force F [N], Eq. 1.
///
///   a³ = (3R/4E*) (√P ± √(F + P))²,  P = 3/2 π R W
///
/// NaN where no equilibrium exists: F < −P, and for the inner branch F > 0. The inner branch is computed without
/// cancellation.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double contact_radius_at_force(double force, const Contact& contact, Branch branch = Branch::outer);
[[nodiscard]] Array1D contact_radius_at_force(const ArrayView1D& force, const Contact& contact,
                                              Branch branch = Branch::outer);

/// Contact radius [m] at displacement δ [m].
///
/// With a = a_c (1 + u)², a_c the radius at the pull-off under fixed grips and δ_c = −3a_c²/R, the equilibrium reads u²
/// (u² + 4u + 6) = 3 (1 − δ/δ_c), solved by Newton steps on |u| √(u² + 4u + 6), which is smooth through the fold; they
/// converge monotonically from the chosen start, so no bracket is needed. NaN where no equilibrium exists: δ < δ_c, and
/// for the inner branch δ > 0.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double contact_radius_at_displacement(double displacement, const Contact& contact,
                                                    Branch branch = Branch::outer);
[[nodiscard]] Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const Contact& contact,
                                                     Branch branch = Branch::outer);

/// Force [N] at displacement δ [m], through the contact radius; NaN where no equilibrium exists.
[[nodiscard]] double force_at_displacement(double displacement, const Contact& contact, Branch branch = Branch::outer);
[[nodiscard]] Array1D force_at_displacement(const ArrayView1D& displacement, const Contact& contact,
                                            Branch branch = Branch::outer);

/// Displacement [m] under force F [N], through the contact radius; NaN where no equilibrium exists.
[[nodiscard]] double displacement_at_force(double force, const Contact& contact, Branch branch = Branch::outer);
[[nodiscard]] Array1D displacement_at_force(const ArrayView1D& force, const Contact& contact,
                                            Branch branch = Branch::outer);

/// Force F = 2aE* (δ − a²/(3R)) [N] at given contact radius and displacement, in equilibrium or not; independent of W.
[[nodiscard]] double force_at(double contact_radius, double displacement, const SphereOnFlat& contact);

/// Contact radius [m] from force and displacement, without W: the root with a² >= Rδ of
/// a³ − 3Rδ a + 3RF/(2E*) = 0; NaN where there is none.
/// @throws InvalidArgument for E*, R <= 0.
[[nodiscard]] double contact_radius_at(double force, double displacement, const SphereOnFlat& contact);

/// Energy release rate G = (4E*a³/(3R) − F)² / (8πE*a³) [J/m²] at contact radius a [m], > 0, and force F [N].
[[nodiscard]] double energy_release_rate_at_force(double contact_radius, double force, const SphereOnFlat& contact);

/// Energy release rate G = E* (δ − a²/R)² / (2πa) [J/m²] at contact radius a [m], > 0, and displacement δ [m].
[[nodiscard]] double energy_release_rate_at_displacement(double contact_radius, double displacement,
                                                         const SphereOnFlat& contact);

/// Energy [J] of contact radius a and displacement δ, in equilibrium or not; zero for separated bodies.
///
///   U = E* [δ²a − 2/3 δa³/R + a⁵/(5R²)] − πWa²
[[nodiscard]] double total_energy(double contact_radius, double displacement, const Contact& contact);

/// Separation under a dead load: F = −3/2 πRW, a³ = 9πWR²/(8E*).
[[nodiscard]] State pull_off_at_fixed_load(const Contact& contact);

/// Separation in an infinitely stiff machine: F = −5/6 πRW, a³ = πWR²/(8E*), δ = −3a²/R. A machine of finite stiffness
/// lies between the two.
[[nodiscard]] State pull_off_at_fixed_grips(const Contact& contact);

/// Jump into contact on approach under fixed grips: δ = 0, a³ = 2πWR²/E*, F = −4/3 πRW.
[[nodiscard]] State jump_in_at_fixed_grips(const Contact& contact);

/// Energies [J] that a smooth ideal sphere loses in one closed loop under fixed grips, all in the two jumps.
struct LoopLoss {
    double jump_in = 0.0;   ///< 3/5 πW a0², a0 the radius after the jump into contact
    double jump_out = 0.0;  ///< 2/5 πW a_c², a_c the radius before pull-off
    double total = 0.0;     ///< 0.662996 πW a0²; 1.2749410291 in Maugis' units
};
[[nodiscard]] LoopLoss ideal_loop_loss(const Contact& contact);

/// Controlled quantity during separation.
enum class Control { fixed_load, fixed_grips };

/// Work of adhesion [J/m²] from the magnitude of the pull-off force [N]: W = 2|F|/(3πR) under a fixed load (Eq. S1),
/// 6|F|/(5πR) under fixed grips.
/// @throws InvalidArgument for R <= 0.
[[nodiscard]] double work_of_adhesion_from_pull_off(double pull_off_force, double radius,
                                                    Control control = Control::fixed_load);

/// Scales in which all JKR contacts are equal: R = 1, W = 1/π, K = 4E*/3 = 1.
struct MaugisUnits {
    double length = 0.0;  ///< (πWR²/K)^(1/3) [m], unit of contact radii
    double height = 0.0;  ///< (π²W²R/K²)^(1/3) [m], unit of displacements
    double force = 0.0;   ///< πRW [N]
    double energy = 0.0;  ///< force · height [J]
};

/// @throws InvalidArgument for W = 0, where the scales vanish, or a contact outside its domain.
[[nodiscard]] MaugisUnits maugis_units(const Contact& contact);

/// Tabor parameter μ = R^(1/3) (W/E*)^(2/3) / z0, z0 the range of the interaction [m], > 0: JKR applies for μ >> 1
/// (from about 5), the limit of Derjaguin, Muller and Toporov for μ << 1.
/// Source: Tabor, J. Colloid Interface Sci. 58 (1977) 2.
[[nodiscard]] double tabor_parameter(const Contact& contact, double interaction_range);

}  // namespace setae::contact::jkr
