// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/gaps.hpp"

#include <cmath>
#include <vector>

namespace setae::topography {

Gaps bridge_gaps(Eigen::Ref<Array1D> heights, bool periodic) {
    const Index n = heights.size();
    std::vector<Index> defined;
    for (Index i = 0; i < n; ++i)
        if (!std::isnan(heights[i])) defined.push_back(i);
    Gaps gaps{n - static_cast<Index>(defined.size()), 0};
    if (defined.empty()) return {n, 1};
    const auto bridge = [&](Index from, Index to) {  // to > from; beyond n: wrapped
        if (to - from < 2) return;
        ++gaps.count;
        const double lower = heights[from], upper = heights[to % n];
        for (Index i = from + 1; i < to; ++i) {
            const double t = static_cast<double>(i - from) / static_cast<double>(to - from);
            heights[i % n] = (1.0 - t) * lower + t * upper;
        }
    };
    for (std::size_t k = 1; k < defined.size(); ++k) bridge(defined[k - 1], defined[k]);
    const Index first = defined.front(), last = defined.back();
    if (periodic) {
        bridge(last, first + n);
    } else {
        gaps.count += (first > 0) + (last + 1 < n);
        heights.head(first).setConstant(heights[first]);
        heights.tail(n - 1 - last).setConstant(heights[last]);
    }
    return gaps;
}

}  // namespace setae::topography
