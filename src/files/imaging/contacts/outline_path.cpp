// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline_path.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace setae::imaging {

std::vector<Index> closed_path(const Array2D& gain, double cost, Index most) {
    constexpr Index rounds = 3;
    const Index rows = gain.rows(), columns = gain.cols(), steps = rounds * rows;
    Array1D best = gain.row(0).transpose(), next(columns);
    Eigen::Array<std::int8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> from(steps, columns);
    from.setZero();
    for (Index i = 1; i < steps; ++i) {
        for (Index k = 0; k < columns; ++k) {
            Index chosen = 0;
            double highest = best[k];
            for (Index d = 1; d <= most; ++d)
                for (const Index step : {-d, d}) {
                    if (k + step < 0 || k + step >= columns) continue;
                    const double sum = best[k + step] - cost * static_cast<double>(d);
                    if (sum > highest) {
                        highest = sum;
                        chosen = step;
                    }
                }
            from(i, k) = static_cast<std::int8_t>(chosen);
            next[k] = highest + gain(i % rows, k);
        }
        best.swap(next);
    }
    Index at = 0;
    best.maxCoeff(&at);
    std::vector<Index> path(static_cast<std::size_t>(rows));
    for (Index i = steps - 1; i >= rows; --i) {
        if (i < 2 * rows) path[static_cast<std::size_t>(i - rows)] = at;
        at += from(i, at);
    }
    return path;
}

}  // namespace setae::imaging
