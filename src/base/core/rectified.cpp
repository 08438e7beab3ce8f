// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/rectified.hpp"

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"

namespace setae {

double rectified_share(double mean, double deviation) {
    if (!(deviation > 0.0)) return mean > 0.0 ? 1.0 : mean < 0.0 ? 0.0 : 0.5;
    const double z = mean / deviation;
    constexpr double far = 8.0;  // the rest is below the rounding of the difference
    if (std::abs(z) > far) return z > 0.0 ? 1.0 : 0.0;
    const double above = normal_probability(z), density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * pi);
    const double first = z * above + density, second = (1.0 + z * z) * above + z * density;
    return std::sqrt(std::max(0.0, second - first * first));
}

Estimate rectified(Estimate raw) {
    if (!raw.interval) raw.interval = interval_of(raw);
    if (raw.uncertain()) raw.standard_error *= rectified_share(raw.value, raw.standard_error);
    if (raw.interval) {
        raw.interval->lower = std::max(0.0, raw.interval->lower);
        raw.interval->upper = std::max(0.0, raw.interval->upper);
    }
    raw.value = std::max(0.0, raw.value);
    return raw;
}

}  // namespace setae
