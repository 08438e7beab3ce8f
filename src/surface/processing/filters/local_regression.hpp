// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "setae/core/arrays.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::processing {

/// The neighbourhood of a point in a Gaussian regression.
struct Neighbourhood {
    std::array<double, 2> deviation{};  ///< of the Gaussian along x and y [pixels]; 0: no neighbours along it
    bool periodic = false;
    Index order = 0;  ///< of the local polynomial
};

/// What local_regression leaves in place of the heights.
enum class Regression { value, residual };

/// Local polynomials fitted with Gaussian weights around every point, at the point.
///
/// `weights`, of the heights' shape or empty for 1 everywhere, multiply the Gaussian; undefined heights have none.
/// Terms of the polynomial that the points near cannot tell from lower ones are left out; without points of weight the
/// value is NaN. Undefined heights stay undefined in a residual; their values are given. `result` may be the heights
/// themselves. A direction of deviation 0 takes no part in the polynomial. Same bytes for any number of threads.
void local_regression(const ArrayView2D& heights, const Array2D& weights, const Neighbourhood& neighbourhood,
                      Regression kind, Eigen::Ref<Array2D> result, parallel::Threads threads);

}  // namespace setae::processing
