// SPDX-License-Identifier: GPL-3.0-or-later
#include "spectral_moment.hpp"

#include <algorithm>
#include <cmath>

namespace setae::simulation {
namespace {

/// Over a piece without bends.
double over_piece(const spectra::SpectralDensity& C_iso, double order, double lower, double upper) {
    if (!(upper > lower)) return 0.0;
    constexpr double points_per_unit = 1000.0;
    const double extent = std::log(upper / lower);
    const auto points = static_cast<Index>(std::ceil(points_per_unit * extent));
    const double step = extent / static_cast<double>(points);
    double sum = 0.0;
    for (Index i = 0; i < points; ++i) {
        const double q = lower * std::exp((static_cast<double>(i) + 0.5) * step);
        sum += step * std::pow(q, order + 2.0) * C_iso(q);
    }
    return sum;
}

}  // namespace

double spectral_moment(const spectra::SpectralDensity& C_iso, double order, double rolloff, const Band& band) {
    const double flat = 1e-3 * rolloff;
    double sum = 0.0;
    if (band.lower < flat) {
        const double end = std::min(flat, band.upper);
        sum += C_iso(end) * (std::pow(end, order + 2.0) - std::pow(band.lower, order + 2.0)) / (order + 2.0);
    }
    sum += over_piece(C_iso, order, std::max(band.lower, flat), std::min(rolloff, band.upper));
    return sum + over_piece(C_iso, order, std::max(band.lower, rolloff), band.upper);
}

}  // namespace setae::simulation
