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

}  // namespace setae
