// SPDX-License-Identifier: GPL-3.0-or-later
#include "pinning_lines.hpp"

#include <algorithm>
#include <utility>

namespace setae::crack_front {

PinningLines::PinningLines(Array2D forces, const LinePoints& points, bool repeats)
    : forces_(std::move(forces)), points_(points), repeats_(repeats) {
    if (repeats) return;
    integrals_ = Array2D::Zero(forces_.rows(), forces_.cols());
    for (Index j = 0; j < forces_.rows(); ++j)
        for (Index k = 1; k < forces_.cols(); ++k)
            integrals_(j, k) = integrals_(j, k - 1) + 0.5 * points_.spacing * (forces_(j, k - 1) + forces_(j, k));
}

double PinningLines::integral(Index line, double x) const {
    const Index k = std::clamp<Index>(cell(x), 0, points_.count - 2);
    const double along = x - begin(k);
    return integrals_(line, k) + along * (forces_(line, k) + 0.5 * along * at(line, x, k).slope);
}

}  // namespace setae::crack_front
