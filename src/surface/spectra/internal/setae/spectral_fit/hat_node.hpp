// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectral_fit {

/// Distance of neighbouring nodes of C_iso in ln q: forty per decade.
inline constexpr double node_spacing = 0.05756462732485115;

/// One node of C_iso at wavevector 1, of height 1, on a logarithmic grid of spacing h = node_spacing:
///
///   C(q) = q^−2 max(0, 1 − |ln q|/h)
///
/// A curve of C_iso on nodes q_i is C(q) = Σ f_i C(q/q_i); its C1D agrees with the closed form of a self-affine surface
/// within 0.1 %. The functions below are the autocovariance of the node and the integrals of its line spectrum; those
/// of a node at q_i follow by scaling. Tables are computed once, on first use, from any thread. Derived here; the
/// integrals of the hat function are second differences of the twofold logarithmic integral of J0 − 1.
namespace hat_node {

/// Autocovariance at distance z, ∫_{−h}^{h} (1 − |u|/h) J0(z e^u) du = 2π R(z); for a node at q_i: R(x) = q_i²/2π ·
/// autocovariance(q_i x). 0 beyond z = 3000, where it is below 1e-6 of its value at 0. Relative to that value, exact to
/// 1e-9.
[[nodiscard]] double autocovariance(double distance);

/// Autocovariance of the lower half of the node (the last node of a spectrum that ends there).
[[nodiscard]] double autocovariance_of_lower_half(double distance);

/// Autocovariance of a disc, C = 1 for q < 1: ∫_0^1 J0(z q) q dq = J1(z)/z; the constant part below the lowest node.
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
