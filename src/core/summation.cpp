// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/summation.hpp"

namespace setae {

double pairwise_sum(const ArrayView1D& values) {
    constexpr Index leaf = 128;
    if (values.size() <= leaf) {
        double sum = 0.0;
        for (Index i = 0; i < values.size(); ++i) sum += values[i];
        return sum;
    }
    const auto half = values.size() / 2;
    return pairwise_sum(values.head(half)) + pairwise_sum(values.tail(values.size() - half));
}

double trapezoid(const ArrayView1D& x, const ArrayView1D& y) {
    if (x.size() < 2) return 0.0;
    const auto n = x.size() - 1;
    return pairwise_sum(0.5 * (x.tail(n) - x.head(n)) * (y.head(n) + y.tail(n)));
}

}  // namespace setae
