// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "order_statistic.hpp"

namespace setae::processing {

/// A number and its place in storage order.
struct Outlier {
    Index point;
    double difference;
};

/// The robust standard deviation of numbers about 0, and those beyond a multiple of it.
struct Outliers {
    double deviation = 0.0;
    std::vector<Outlier> points;  ///< in storage order
};

/// s = q_p(|r|)/Φ⁻¹((1 + p)/2) for the first p of 0.5, 0.9 and 0.99 whose quantile q_p is not 0, otherwise 0, and all r
/// with |r| > threshold · s. The result is the same for any number of threads. Cost: usually one pass over r; two if
/// the sample gives no lower bound above 0, as for few or mostly equal numbers.
[[nodiscard]] Outliers find_outliers(const ComputedRows& differences, double threshold, parallel::Threads threads);

}  // namespace setae::processing
