// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::numerics {

/// Position i of n equal steps from −1 to 1; 0 for one point only.
[[nodiscard]] inline double centred(Index i, Index n) {
    return n > 1 ? 2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.0 : 0.0;
}

/// P_0(t) … P_degree(t).
[[nodiscard]] Array1D legendre_values(Index degree, double t);

/// P_k at n equal steps from −1 to 1: row k.
[[nodiscard]] Array2D legendre_table(Index degree, Index n);

/// P_a P_b = Σ_k c_k P_k, k = |a − b| … a + b: the c_k, all >= 0.
/// Source: Adams, Proc. R. Soc. Lond. 27 (1878) 63.
[[nodiscard]] Array1D product_in_legendre(Index a, Index b);

/// Points and weights on −1 … 1 that integrate polynomials of degree 2n − 1 exactly.
struct GaussRule {
    std::vector<double> nodes, weights;
};
[[nodiscard]] GaussRule gauss_rule(Index n);

/// Solution of the normal equations G c = b; empty if G, scaled to unit diagonal, has a condition number beyond 1e12:
/// the points then do not determine c.
[[nodiscard]] std::optional<Array1D> solved_normal_equations(const Array2D& gram, const Array1D& moments);

/// Σ a_j b_j in independent lanes: vectorised, in a fixed order.
[[nodiscard]] double dot(const double* a, const double* b, Index n);

}  // namespace setae::numerics
