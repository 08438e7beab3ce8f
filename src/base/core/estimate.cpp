// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/estimate.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "setae/core/statistics.hpp"

namespace setae {

std::optional<Interval> interval_of(const Estimate& estimate, double level) {
    if (estimate.interval) return estimate.interval;
    if (!estimate.uncertain()) return std::nullopt;
    const double freedom = estimate.degrees_of_freedom.value_or(std::numeric_limits<double>::infinity());
    if (!(freedom > 0.0)) return std::nullopt;
    const double reach = student_t_quantile(0.5 * (1.0 + level), freedom) * estimate.standard_error;
    return Interval{estimate.value - reach, estimate.value + reach, level};
}

Estimate scaled(Estimate estimate, double factor) {
    estimate.value *= factor;
    estimate.standard_error *= std::abs(factor);
    if (estimate.interval) {
        estimate.interval->lower *= factor;
        estimate.interval->upper *= factor;
        if (factor < 0.0) std::swap(estimate.interval->lower, estimate.interval->upper);
    }
    return estimate;
}

Estimate difference(const Estimate& later, const Estimate& earlier) {
    const std::array inputs{later, earlier};
    auto result = propagated([](const Array1D& x) { return x[0] - x[1]; }, inputs);
    if (std::isnan(later.standard_error) || std::isnan(earlier.standard_error)) result.standard_error = undefined;
    return result;
}

}  // namespace setae
