// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/contact/elasticity.hpp"
#include "setae/contact_line/contact_line.hpp"

namespace setae::contact_line {

/// Energy release rate along the edge [J/m²], shape (M, N): local resistance of the surface at the edge.
///
///   G(θ) = G_J(r(θ), δ) (1 + (1/r̄) Σ_{n≠0} |n| r_n e^{inθ}),  G_J = E*(δ − r²/R)²/(2πr)
///
/// the first order of the front's elasticity about a circle, with the displacement δ [m] of each frame, the axis of the
/// sphere in the centre. Modes above `largest_mode` are treated as noise and are left out of the sum; 0 keeps all
/// modes. displacement: M numbers [m]. sphere: E* and R.
/// @throws InvalidArgument as require_valid, for other than M displacements, E* or R <= 0.
/// Source: Gao, Rice, J. Appl. Mech. 54 (1987) 627: K there, so that |n|/2 for K is |n| for G.
[[nodiscard]] Array2D local_release_rate(const ContactLine& line, const ArrayView1D& displacement,
                                         const contact::SphereOnFlat& sphere, Index largest_mode = 0);

}  // namespace setae::contact_line
