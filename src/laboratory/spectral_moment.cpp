// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectral_moment.hpp"

#include <algorithm>
#include <cmath>

namespace setae::laboratory {

double spectral_moment(const synthesis::SpectralDensity& C_iso, double order, double rolloff, double upper) {
    const double flat = std::min(rolloff, upper);
    double sum = C_iso(0.5 * flat) * std::pow(flat, order + 2.0) / (order + 2.0);
    if (!(upper > rolloff)) return sum;
    constexpr double points_a_unit = 1000.0;
    const double extent = std::log(upper / rolloff);
    const auto points = static_cast<Index>(std::ceil(points_a_unit * extent));
    const double step = extent / static_cast<double>(points);
    for (Index i = 0; i < points; ++i) {
        const double q = rolloff * std::exp((static_cast<double>(i) + 0.5) * step);
        sum += step * std::pow(q, order + 2.0) * C_iso(q);
    }
    return sum;
}

}  // namespace setae::laboratory
