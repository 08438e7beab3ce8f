// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/core/arrays.hpp"

namespace setae::loops {

/// Least-squares lines through every window of so many neighbouring samples, from running sums. Entry i is the window
/// that begins at sample i. Cost: linear.
class LocalLines {
public:
    /// clock: increasing strictly; width: 3 samples or more, at most all of them.
    LocalLines(const Array1D& clock, const Array1D& series, Index width);

    [[nodiscard]] Index width() const { return width_; }
    [[nodiscard]] Index count() const { return slope_.size(); }
    [[nodiscard]] double slope(Index window) const { return slope_[window]; }
    [[nodiscard]] double scatter(Index window) const { return scatter_[window]; }  ///< rms about the line, n − 2
    /// Value of the line at a time of the clock.
    [[nodiscard]] double at(Index window, double time) const {
        return mean_[window] + slope_[window] * (time - middle_[window]);
    }
    /// Variance of that value for noise of variance 1.
    [[nodiscard]] double variance(Index window, double time) const {
        const double from_middle = time - middle_[window];
        return 1.0 / static_cast<double>(width_) + from_middle * from_middle / spread_[window];
    }
    /// Σ (t − t̄)²: the slope's variance is that of the noise over it.
    [[nodiscard]] double spread(Index window) const { return spread_[window]; }

private:
    Index width_;
    Array1D middle_, mean_, slope_, spread_, scatter_;
};

/// Slope at every sample: of the window that it is the middle of, at the ends of the first and the last window.
[[nodiscard]] Array1D local_slopes(const Array1D& clock, const Array1D& series, Index half_width);

/// Means over so many neighbours on both sides, fewer at the ends.
[[nodiscard]] Array1D local_means(const Array1D& series, Index half_width);

}  // namespace setae::loops
