// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace setae::loops {

/// Rough modulus [Pa] of a rubber from its network, E ~ ρRT/M_c: a check of plausibility, not a measurement (the shear
/// modulus of an affine network; entanglements and network defects change it by a factor).
///
/// density: ρ [kg/m³], > 0 (PDMS about 970).  temperature: T [K], > 0.  molar_mass_between_crosslinks: M_c [kg/mol], >
/// 0.
/// @throws InvalidArgument outside the domain.
/// Source: Treloar, The Physics of Rubber Elasticity (1975), ch. 4.
[[nodiscard]] double rubber_modulus(double density, double temperature, double molar_mass_between_crosslinks);

}  // namespace setae::loops
