// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectral_fit {

/// Distance of neighbouring nodes of C_iso in ln q: forty a decade.
inline constexpr double node_spacing = 0.05756462732485115;

/// One node of C_iso at wavevector 1, of height 1, on a logarithmic grid of spacing h = node_spacing:
///
///   C(q) = q^−2 max(0, 1 − |ln q|/h)
///
/// A curve of C_iso on nodes q_i is C(q) = Σ f_i C(q/q_i); against the closed form of a self-affine surface its C1D is
/// within 0.1 %. The functions below are the node's autocovariance and the integrals of its line spectrum; those of a
/// node at q_i follow by scaling. Tables are made once, on first use; any thread may ask. Derived here; the hat's
/// integrals are second differences of the twofold logarithmic integral of J0 − 1.
namespace hat_node {

/// Autocovariance at distance z, ∫_{−h}^{h} (1 − |u|/h) J0(z e^u) du = 2π R(z); of a node at q_i: R(x) = q_i²/2π ·
/// this(q_i x). 0 beyond z = 3000, where it is below 1e-6 of its value at 0. Relative to that value, exact to 1e-9.
[[nodiscard]] double autocovariance(double distance);

/// The same of the half below the node alone (the last node of a spectrum that ends there).
[[nodiscard]] double autocovariance_of_lower_half(double distance);

/// The same of a disc, C = 1 for q < 1: ∫_0^1 J0(z q) q dq = J1(z)/z; the flat part below the lowest node.
[[nodiscard]] double autocovariance_of_disc(double distance);

/// ∫_0^q C1D dq' of the node, and ∫_0^q q' C1D dq', C1D(q) = (1/π) ∫_q^∞ C(p) p dp/√(p² − q²). Exact to 1e-7 of the
/// whole.
struct LineIntegrals {
    double zeroth = 0.0;
    double first = 0.0;
};
[[nodiscard]] LineIntegrals line_integrals(double wavevector);
[[nodiscard]] LineIntegrals line_integrals_of_lower_half(double wavevector);
[[nodiscard]] LineIntegrals line_integrals_of_disc(double wavevector);

}  // namespace hat_node

}  // namespace setae::spectral_fit
