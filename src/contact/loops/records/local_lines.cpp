// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_lines.hpp"

#include <algorithm>
#include <cmath>

namespace setae::loops {
namespace {

/// Sums of the first 0, 1, 2 … entries.
Array1D running_sums(const Array1D& values) {
    Array1D sums(values.size() + 1);
    sums[0] = 0.0;
    for (Index i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
    return sums;
}

Array1D window_sums(const Array1D& values, Index width) {
    const Array1D sums = running_sums(values);
    const Index n = values.size() - width + 1;
    return sums.tail(n) - sums.head(n);
}

}  // namespace

LocalLines::LocalLines(const Array1D& clock, const Array1D& series, Index width) : width_(width) {
    const auto n = static_cast<double>(width);
    const double origin = clock.mean(), level = series.mean();
    const Array1D t = clock - origin, y = series - level;
    middle_ = window_sums(t, width) / n;
    mean_ = window_sums(y, width) / n;
    spread_ = window_sums(t.square(), width) - n * middle_.square();
    slope_ = (window_sums(t * y, width) - n * middle_ * mean_) / spread_;
    const Array1D squares = window_sums(y.square(), width) - n * mean_.square() - slope_.square() * spread_;
    scatter_ = (squares.max(0.0) / (n - 2.0)).sqrt();
    middle_ += origin;
    mean_ += level;
}

Array1D local_slopes(const Array1D& clock, const Array1D& series, Index half_width) {
    const LocalLines lines(clock, series, 2 * half_width + 1);
    Array1D slopes(series.size());
    for (Index i = 0; i < slopes.size(); ++i)
        slopes[i] = lines.slope(std::clamp<Index>(i - half_width, 0, lines.count() - 1));
    return slopes;
}

Array1D local_means(const Array1D& series, Index half_width) {
    const Array1D sums = running_sums(series);
    Array1D means(series.size());
    for (Index i = 0; i < series.size(); ++i) {
        const Index reach = std::min({half_width, i, series.size() - 1 - i});
        means[i] = (sums[i + reach + 1] - sums[i - reach]) / static_cast<double>(2 * reach + 1);
    }
    return means;
}

}  // namespace setae::loops
