// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/first_defined.hpp"

namespace setae::topography {

std::optional<double> first_defined(const ArrayView2D& heights) {
    for (Index i = 0; i < heights.rows(); ++i)
        for (Index j = 0; j < heights.cols(); ++j)
            if (heights(i, j) == heights(i, j)) return heights(i, j);
    return {};
}

}  // namespace setae::topography
