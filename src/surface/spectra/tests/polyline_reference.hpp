// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <complex>
#include <span>

#include "setae/core/arrays.hpp"
#include "setae/spectra/window.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::tests {

using ExtendedComplex = std::complex<long double>;

/// ∫ h e^{−iqx} dx over the segments, x from the first point, in extended precision:
/// sum_s dx [y sinc(θ) + i dy sinc'(θ)/2] e^{−iq x}, midpoints x, y, θ = q dx/2.
inline ExtendedComplex segment_sum(const topography::Profile& profile, long double q) {
    ExtendedComplex sum{};
    for (Index k = 0; k + 1 < profile.positions.size(); ++k) {
        const long double x0 = static_cast<long double>(profile.positions[k]) - profile.positions[0];
        const long double x1 = static_cast<long double>(profile.positions[k + 1]) - profile.positions[0];
        const long double y = (static_cast<long double>(profile.heights[k]) + profile.heights[k + 1]) / 2.0L;
        const long double dy = static_cast<long double>(profile.heights[k + 1]) - profile.heights[k];
        const long double theta = q * (x1 - x0) / 2.0L;
        long double sinc = 1.0L - theta * theta / 6.0L, slope = -theta / 3.0L + theta * theta * theta / 30.0L;
        if (std::abs(theta) > 1e-4L) {
            sinc = std::sin(theta) / theta;
            slope = (std::cos(theta) - sinc) / theta;
        }
        sum += (x1 - x0) * ExtendedComplex(y * sinc, dy * slope / 2.0L) * std::polar(1.0L, -q * (x0 + x1) / 2.0L);
    }
    return sum;
}

/// The windowed spectrum as shifted segment sums.
inline double spectrum_by_segments(const topography::Profile& profile, double q, spectra::Window window) {
    const auto cosines = spectra::cosine_coefficients(window);
    const long double length =
        static_cast<long double>(profile.positions[profile.positions.size() - 1]) - profile.positions[0];
    const long double base = 2.0L * std::numbers::pi_v<long double> / length;
    ExtendedComplex sum = static_cast<long double>(cosines[0]) * segment_sum(profile, q);
    for (std::size_t m = 1; m < cosines.size(); ++m)
        for (const long double sign : {-1.0L, 1.0L})
            sum += static_cast<long double>(cosines[m]) / 2.0L *
                   segment_sum(profile, q + sign * static_cast<long double>(m) * base);
    return static_cast<double>(std::norm(sum) / length);
}

}  // namespace setae::tests
