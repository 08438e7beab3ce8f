// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// C_iso from C1D by the approximation of [D19].
///
///   C_iso(q) ≈ π C1D(q)/(q √(1 − (q/q_s)²))
///
/// wavevector [1/m], C1D [m³], shortest_wavevector q_s [1/m]. NaN for q >= q_s. With q_s infinite: π C1D/q. h_rms² of
/// the result is about π/2 times too large (THEORY: ratio to the exact value); moments need no conversion.
/// @throws InvalidArgument for sizes that differ or q_s <= 0.
/// Source: [D19] Eq. (11).
[[nodiscard]] Array1D isotropic_from_profile_eq11(const ArrayView1D& wavevector, const ArrayView1D& C1D,
                                                  double shortest_wavevector);

/// C1D from C_iso by the Abel integral of an isotropic surface.
///
///   C1D(q_x) = (1/π) ∫_{q_x}^{q_s} C_iso(q) q dq/√(q² − q_x²)
///
/// C_iso [m⁴] at increasing nodes [1/m], a power law between them, constant below the first, zero above the last (q_s).
/// Exact to 1e-10 for that curve: close to q_x Gauss points in v, q² = q_x² + v², a series beyond.
/// Cost: linear in the nodes once, then in the nodes up to 1.5 q_x for each q_x.
/// @throws InvalidArgument for fewer than two nodes, nodes that do not increase, or C_iso <= 0.
[[nodiscard]] Array1D profile_from_isotropic(const ArrayView1D& nodes, const ArrayView1D& C_iso,
                                             const ArrayView1D& wavevector);

/// C_iso at the wavevectors of C1D whose Abel integral is C1D, by multiplicative correction of Eq. (11): C_iso ← C_iso
/// · C1D/Abel(C_iso), rounds times. From the last wavevector to q_s the power law of the last two continues. A small
/// number of rounds regularises: noise between neighbouring wavevectors grows with each round. wavevector: increasing,
/// below q_s = shortest_wavevector [1/m]. C1D > 0 [m³].
/// @throws InvalidArgument as profile_from_isotropic, for a wavevector not below q_s, or for rounds < 0.
[[nodiscard]] Array1D isotropic_from_profile(const ArrayView1D& wavevector, const ArrayView1D& C1D,
                                             double shortest_wavevector, int rounds = 10);

}  // namespace setae::spectra
