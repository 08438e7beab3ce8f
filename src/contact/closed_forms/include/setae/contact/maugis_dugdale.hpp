// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/elasticity.hpp"
#include "setae/core/arrays.hpp"

/// Contact with adhesion of any range: a constant attraction σ0 acts across gaps below W/σ0 around the contact (Maugis
/// with Dugdale's cohesive zone), between DMT (λ → 0) and JKR (λ → ∞).
///
/// Signs as in jkr.hpp. With A, F̄, δ̄ the contact radius, force and displacement in jkr::MaugisUnits, m = c/a the
/// outer divided by the inner radius of the cohesive zone and s = √(m² − 1):
///
///   1 = (λA²/2) [s + (m² − 2) atan s] + (4λ²A/3) [s atan s − m + 1]
///   F̄ = A³ − λA² [s + m² atan s],   δ̄ = A² − (4/3) λ A s
///
/// The first equation is a quadratic in A, so the whole curve is explicit in s, along which A decreases monotonically;
/// each inverse is one bracketed root in s (TOMS 748), on either branch. Domain: 1e-30 <= λ <= 1e30. Limits: λ → 0 is
/// DMT to O(λ^1.5) in pull-off, λ → ∞ is JKR to O(λ^-2). At a = 0 the cohesive zone still acts: force and displacement
/// of a vanishing contact are finite; attraction without contact beyond that state is not part of the model. Source:
/// Maugis, J. Colloid Interface Sci. 150 (1992) 243.
namespace setae::contact::maugis_dugdale {

using State = ContactState;

struct Contact {
    double radius = 0.0;            ///< R [m], > 0
    double contact_modulus = 0.0;   ///< E* [Pa], > 0
    double work_of_adhesion = 0.0;  ///< W [J/m²], > 0
    double cohesive_stress = 0.0;   ///< σ0 [Pa], > 0
};

/// A state of equilibrium in jkr::MaugisUnits.
struct ReducedState {
    double force = 0.0;           ///< F̄
    double displacement = 0.0;    ///< δ̄
    double contact_radius = 0.0;  ///< A
    double zone_ratio = 1.0;      ///< m = c/a, >= 1; infinity at a = 0
};

/// State at reduced contact radius A >= 0. @throws InvalidArgument for A < 0 or λ outside its domain.
[[nodiscard]] ReducedState reduced_state(double reduced_radius, double transition_parameter);

/// A state with its derivatives by A and by λ, each with the other fixed.
struct ReducedSlopes {
    ReducedState state;
    double force_by_radius = 0.0;
    double force_by_transition = 0.0;
    double displacement_by_radius = 0.0;
    double displacement_by_transition = 0.0;
};

/// State at reduced contact radius A, 1e-9 <= A, with its derivatives. @throws InvalidArgument outside the domain.
[[nodiscard]] ReducedSlopes reduced_slopes(double reduced_radius, double transition_parameter);

/// State of smallest force: separation under a dead load. For λ < 1e-5 its force is resolved, but not its contact
/// radius (about 2.1 λ). @throws InvalidArgument for λ outside its domain.
[[nodiscard]] ReducedState reduced_pull_off_at_fixed_load(double transition_parameter);

/// State of smallest displacement: separation in an infinitely stiff machine. It is the fold of δ̄(A), or A = 0 for
/// λ below about 0.938, where there is no fold. @throws InvalidArgument for λ outside its domain.
[[nodiscard]] ReducedState reduced_pull_off_at_fixed_grips(double transition_parameter);

/// λ = 2σ0 (R/(πWK²))^(1/3), K = 4E*/3. @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double transition_parameter(const Contact& contact);

/// Cohesive stress σ0 = λ (πWK²/R)^(1/3)/2 [Pa] that gives λ. @throws InvalidArgument outside the domain, and for W =
/// 0.
[[nodiscard]] double cohesive_stress(double transition_parameter, const AdhesiveContact& contact);

/// Force [N], displacement [m] in equilibrium at contact radius a [m], >= 0.
/// @throws InvalidArgument for a < 0 or a contact outside its domain.
[[nodiscard]] double force(double contact_radius, const Contact& contact);
[[nodiscard]] double displacement(double contact_radius, const Contact& contact);
[[nodiscard]] Array1D force(const ArrayView1D& contact_radius, const Contact& contact);
[[nodiscard]] Array1D displacement(const ArrayView1D& contact_radius, const Contact& contact);

/// Contact radius [m] under force F [N]; NaN where no equilibrium exists: below the pull-off at fixed load, and for the
/// inner branch above the force at a = 0.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double contact_radius_at_force(double force, const Contact& contact, Branch branch = Branch::outer);
[[nodiscard]] Array1D contact_radius_at_force(const ArrayView1D& force, const Contact& contact,
                                              Branch branch = Branch::outer);

/// Contact radius [m] at displacement δ [m]; NaN where no equilibrium exists: below the pull-off at fixed grips, and
/// for the inner branch above the displacement at a = 0, and everywhere for λ below about 0.938.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double contact_radius_at_displacement(double displacement, const Contact& contact,
                                                    Branch branch = Branch::outer);
[[nodiscard]] Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const Contact& contact,
                                                     Branch branch = Branch::outer);

/// Force [N] at displacement δ [m], displacement [m] under force F [N]; NaN where no equilibrium exists.
[[nodiscard]] double force_at_displacement(double displacement, const Contact& contact, Branch branch = Branch::outer);
[[nodiscard]] Array1D force_at_displacement(const ArrayView1D& displacement, const Contact& contact,
                                            Branch branch = Branch::outer);
[[nodiscard]] double displacement_at_force(double force, const Contact& contact, Branch branch = Branch::outer);
[[nodiscard]] Array1D displacement_at_force(const ArrayView1D& force, const Contact& contact,
                                            Branch branch = Branch::outer);

/// Separation under a dead load; a machine of finite stiffness lies between this state and that under fixed grips.
[[nodiscard]] State pull_off_at_fixed_load(const Contact& contact);

/// Separation in an infinitely stiff machine; contact radius 0 for λ below about 0.938.
[[nodiscard]] State pull_off_at_fixed_grips(const Contact& contact);

}  // namespace setae::contact::maugis_dugdale
