// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/elasticity.hpp"
#include "setae/core/arrays.hpp"

/// JKR contact of a sphere, not of the paraboloid with its curvature: contact radii comparable to R.
///
///   F = E*R² [(1 + x²) artanh x − x] − √(8πE*W a³)
///   δ = a artanh x − √(2πaW/E*),   x = a/R < 1,   artanh x = ½ ln((R + a)/(R − a))
///
/// The shape is exact, the elasticity stays linear: strains of a rigid sphere in rubber, of order a/R, are not
/// corrected for. Signs as in jkr.hpp; contacts as there, and W <= 1e6 E*R. Limits: a/R → 0 is JKR, with F and δ of the
/// Hertzian part larger by 2/5 x² and 1/3 x²; W = 0 is Sneddon's sphere. Every inverse is a bracketed root (TOMS 748).
/// Sources: Sneddon, Int. J. Eng. Sci. 3 (1965) 47; Maugis, Langmuir 11 (1995) 679.
namespace setae::contact::large_strain {

using Contact = AdhesiveContact;
using State = ContactState;

/// Force [N] in equilibrium at contact radius a [m], 0 <= a < R.
/// @throws InvalidArgument for a outside [0, R) or a contact outside its domain.
[[nodiscard]] double force(double contact_radius, const Contact& contact);

/// Displacement [m] in equilibrium at contact radius a [m], 0 <= a < R.
/// @throws InvalidArgument for a outside [0, R) or a contact outside its domain.
[[nodiscard]] double displacement(double contact_radius, const Contact& contact);

/// Energy release rate G = (F_H(a) − F)²/(8πE*a³) [J/m²] at contact radius a [m], 0 < a < R, and force F [N]; F_H is
/// the force of the same contact without adhesion.
/// @throws InvalidArgument for a outside (0, R) or E*, R <= 0.
[[nodiscard]] double energy_release_rate_at_force(double contact_radius, double force, const SphereOnFlat& contact);

/// Contact radius [m] under force F [N]; NaN where no equilibrium exists (beyond pull-off, for the inner branch F > 0)
/// and where it would exceed (1 − 1e-9) R, at forces of about 20 E*R² and more.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double contact_radius_at_force(double force, const Contact& contact, Branch branch = Branch::outer);
[[nodiscard]] Array1D contact_radius_at_force(const ArrayView1D& force, const Contact& contact,
                                              Branch branch = Branch::outer);

/// Contact radius [m] at displacement δ [m]; NaN where no equilibrium exists (beyond pull-off, for the inner branch δ >
/// 0) and where it would exceed (1 − 1e-9) R.
/// @throws InvalidArgument for a contact outside its domain.
[[nodiscard]] double contact_radius_at_displacement(double displacement, const Contact& contact,
                                                    Branch branch = Branch::outer);
[[nodiscard]] Array1D contact_radius_at_displacement(const ArrayView1D& displacement, const Contact& contact,
                                                     Branch branch = Branch::outer);

/// Force [N] at displacement δ [m]; NaN where no equilibrium exists.
[[nodiscard]] double force_at_displacement(double displacement, const Contact& contact, Branch branch = Branch::outer);
[[nodiscard]] Array1D force_at_displacement(const ArrayView1D& displacement, const Contact& contact,
                                            Branch branch = Branch::outer);

/// Separation under a dead load, dF/da = 0. Unlike in JKR, the force depends on E*.
[[nodiscard]] State pull_off_at_fixed_load(const Contact& contact);

/// Separation in an infinitely stiff machine, dδ/da = 0.
[[nodiscard]] State pull_off_at_fixed_grips(const Contact& contact);

}  // namespace setae::contact::large_strain
