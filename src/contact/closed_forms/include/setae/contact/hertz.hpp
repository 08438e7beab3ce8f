// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/elasticity.hpp"

/// Contact without adhesion of a sphere (a paraboloid of the same curvature) and an elastic half-space; valid for
/// contact radius << R. Source of all: Hertz 1881; Johnson, Contact Mechanics (1985), ch. 4.
namespace setae::contact::hertz {

/// Normal force F = 4/3 E* √R d^(3/2) [N] at penetration d [m]. @throws InvalidArgument for d < 0 or E*, R <= 0.
[[nodiscard]] double force(double penetration, const SphereOnFlat& contact);

/// Contact radius a = (3RF/4E*)^(1/3) [m] under force F [N]. @throws InvalidArgument for F < 0 or E*, R <= 0.
[[nodiscard]] double contact_radius(double force, const SphereOnFlat& contact);

/// Penetration d = a²/R [m] under force F [N]. @throws InvalidArgument for F < 0 or E*, R <= 0.
[[nodiscard]] double penetration(double force, const SphereOnFlat& contact);

/// Stored elastic energy U = 8/15 E* √R d^(5/2) [J]. @throws InvalidArgument for d < 0 or E*, R <= 0.
[[nodiscard]] double energy(double penetration, const SphereOnFlat& contact);

}  // namespace setae::contact::hertz
