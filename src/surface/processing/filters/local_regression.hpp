// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::processing {

/// The neighbourhood of a point in a Gaussian regression.
struct Neighbourhood {
    std::array<double, 2> deviation{};  ///< of the Gaussian along x and y [pixels]; 0: no neighbours along this
                                        ///< direction
    bool periodic = false;
    Index order = 0;  ///< of the local polynomial
};

/// Result of local_regression.
enum class Regression { value, residual };

/// Local polynomials fitted with Gaussian weights around every point, at the point.
///
/// `weights`, of the shape of the heights or empty for 1 everywhere, multiply the Gaussian; undefined heights have
/// weight 0. Terms of the polynomial that nearby points cannot distinguish from lower ones are left out; without points
/// of nonzero weight the value is NaN. Undefined heights remain undefined in a residual; their fitted values are
/// defined. `result` may be `heights`. A direction of deviation 0 is not part of the polynomial. Same bytes for any
/// number of threads.
void local_regression(const ArrayView2D& heights, const Array2D& weights, const Neighbourhood& neighbourhood,
                      Regression kind, Eigen::Ref<Array2D> result, parallel::Threads threads);

}  // namespace setae::processing
