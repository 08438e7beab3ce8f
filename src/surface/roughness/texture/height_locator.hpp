// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "setae/core/arrays.hpp"

namespace setae::texture {

/// Number of given heights at or below a value, for many values: a table of equal steps, then a few comparisons.
class HeightLocator {
public:
    /// heights: not decreasing, at least one.
    explicit HeightLocator(const ArrayView1D& heights)
        : heights_(heights.begin(), heights.end()), count_(static_cast<int>(heights.size())) {
        const double range = heights_.back() - heights_.front();
        const int steps = std::clamp(count_, 16, 1 << 14) * 4;
        scale_ = steps / range;
        if (!std::isfinite(scale_)) scale_ = 0.0;  // one height, or heights that differ by less than the rounding
        heights_.push_back(std::numeric_limits<double>::infinity());
        first_.assign(static_cast<std::size_t>(steps) + 2, count_);
        for (int k = count_ - 1; k >= 0; --k) first_[step_of(heights_[static_cast<std::size_t>(k)])] = k;
        for (auto step = first_.size() - 1; step-- > 0;) first_[step] = std::min(first_[step], first_[step + 1]);
        for (std::size_t step = 0; step + 1 < first_.size(); ++step)
            max_ = std::max(max_, first_[step + 1] - first_[step]);
    }

    /// Number of heights <= value; −1 for NaN.
    [[nodiscard]] int operator()(double value) const {
        if (!(value >= heights_.front())) return std::isnan(value) ? -1 : 0;
        if (value >= heights_[static_cast<std::size_t>(count_ - 1)]) return count_;
        const auto step = step_of(value);
        int k = first_[step];
        if (max_ > 4) {
            const auto begin = heights_.begin() + k;
            return k + static_cast<int>(std::upper_bound(begin, heights_.begin() + first_[step + 1], value) - begin);
        }
        for (int m = 0; m < max_; ++m) k += heights_[static_cast<std::size_t>(k)] <= value ? 1 : 0;
        return k;
    }

    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] const double* heights() const { return heights_.data(); }

private:
    /// Monotonic in the value, rounding included.
    [[nodiscard]] std::size_t step_of(double value) const {
        return static_cast<std::size_t>(static_cast<std::int64_t>((value - heights_.front()) * scale_));
    }

    std::vector<double> heights_;  ///< followed by one infinity
    int count_;
    double scale_ = 0.0;
    std::vector<int> first_;  ///< of each step, the first height in it or after it
    int max_ = 0;             ///< maximum number of heights in one step
};

}  // namespace setae::texture
