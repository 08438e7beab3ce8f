// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/composite.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::half_space {

Array2D composite_heights(const ArrayView2D& first, const ArrayView2D& second) {
    if (first.rows() != second.rows() || first.cols() != second.cols())
        throw InvalidArgument(
            fmt::format("surfaces of {} x {} and {} x {} points; expected the same grid: resample one of them",
                        first.rows(), first.cols(), second.rows(), second.cols()));
    return first + second.colwise().reverse();
}

}  // namespace setae::half_space
