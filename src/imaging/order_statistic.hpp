// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

namespace setae::imaging {

/// The value below which a share of the values lies, the upper one of two: 0.5 is the median. values: not empty. O(n).
template <class Value>
[[nodiscard]] Value order_statistic(std::vector<Value> values, double share) {
    const auto at = values.begin() + std::min<long>(static_cast<long>(values.size()) - 1,
                                                    static_cast<long>(share * static_cast<double>(values.size())));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace setae::imaging
