// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::fourier {

/// Fourier sum of arbitrary points at arbitrary wavevectors.
///
///   f_j = sum_k c_k exp(−i q_j x_k)
///
/// positions x_k [m], coefficients c_k, wavevectors q_j [1/m]; in any order, finite. Error below 1e-13 sum|c_k|, plus
/// the rounding error of the phases q x (1.1e-16 max|q x| per term). Spreading to a grid, a transform of that grid,
/// interpolation: O(n_x + n_q + (q range)(x range) log); the direct sum is used if it is cheaper.
/// @throws InvalidArgument for sizes that differ or values that are not finite.
/// Source: Barnett, Magland, af Klinteberg, SIAM J. Sci. Comput. 41 (2019) C479, type 3, kernel exp(β(√(1−z²) − 1)).
[[nodiscard]] Eigen::ArrayXcd nonuniform_transform(const ArrayView1D& positions, const ArrayView1D& coefficients,
                                                   const ArrayView1D& wavevectors, parallel::Threads threads = {});

}  // namespace setae::fourier
