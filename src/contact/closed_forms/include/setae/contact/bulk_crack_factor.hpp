// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "setae/contact/relaxation.hpp"

/// Energy release rate of a moving crack divided by that of a crack at rest, due to bulk relaxation around the tip.
///
///   E(t)/E∞ = 1 + Σ g e^(−t/τ)
///
/// Source: Persson, Brener, Phys. Rev. E 71 (2005) 036123.
namespace setae::contact::crack_speed {

/// Upper limit of G(v)/G(0) by bulk relaxation, at any speed: E(0)/E∞ = 1 + Σ g. A measured G(v)/G(0) above it is not
/// due to the bulk only.
/// @throws InvalidArgument for terms outside their domains.
[[nodiscard]] double largest_bulk_factor(const std::vector<RelaxationTerm>& terms);

/// G(v)/G(0) at a crack speed v [m/s], >= 0.
///
///   1/f = 1 − (2/π) ∫₀^ω₁ dω/ω √(1 − (ω/ω₁)²) E∞ Im E(ω)/|E(ω)|²,  ω₁ = 2π v/(a0 f)
///
/// The radius of the tip grows in proportion to the energy, a = a0 f. Slow cracks: f = 1 + π (v/a0) Σ g τ; fast cracks:
/// 1 + Σ g.
///
/// tip_radius: a0 [m], > 0, of the crack at rest.
/// @throws InvalidArgument outside these domains.
[[nodiscard]] double bulk_factor(double speed, const std::vector<RelaxationTerm>& terms, double tip_radius);

}  // namespace setae::contact::crack_speed
