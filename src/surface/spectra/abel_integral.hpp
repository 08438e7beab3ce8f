// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::spectra {

/// Abel integrals of one curve of power laws between nodes, for many q_x.
///
///   (1/π) ∫_{q_x}^{q_s} C q dq/√(q² − q_x²), C constant below the first node, zero above the last (q_s)
///
/// From the first node beyond 1.5 q_x on the integrand is expanded by 1/√(q² − q_x²) = (1/q) Σ_k c_k (q_x/q)^2k, c_k =
/// (2k)!/(4^k k!²), with sums of the integrals of C q^−2k computed once; below, Gauss points on each piece in v = √(q²
/// − q_x²). Relative error below 1e-10. nodes: increasing, > 0; spectrum > 0; at least two.  Cost: linear in the nodes
/// once, then in the nodes within 1.5 q_x.
class AbelIntegral {
public:
    AbelIntegral(const ArrayView1D& nodes, const ArrayView1D& spectrum);

    /// q_x >= 0.
    double operator()(double q_x) const;

private:
    double near_piece(Index i, double q_x) const;
    double far_pieces(Index i, double q_x) const;
    template <unsigned points>
    double gauss(Index i, double q_x, double lower, double upper) const;

    Array1D nodes_, spectrum_, slopes_;
    Array2D sums_;  ///< (node, k): ∫ C (node/q)^2k dq from the node on
};

}  // namespace setae::spectra
