// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/polyline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/nonuniform.hpp"

namespace setae::spectra {
namespace {

using Complex = std::complex<double>;

/// Window and polyline, x relative to the first point.
struct WindowedPolyline {
    Array1D x;
    Array1D h;
    Array1D slope;  ///< of the segments
    double length;
    double base;  ///< κ = 2π/L
    std::span<const double> cosines;

    [[nodiscard]] double highest_harmonic() const { return static_cast<double>(cosines.size() - 1) * base; }

    [[nodiscard]] double window(double position) const {
        double value = 0.0;
        for (std::size_t m = 0; m < cosines.size(); ++m)
            value += cosines[m] * std::cos(static_cast<double>(m) * base * position);
        return value;
    }
};

WindowedPolyline prepare(const topography::Profile& profile, Window window) {
    topography::validate(profile);
    if (profile.heights.isNaN().any())
        throw UndefinedDataError(
            fmt::format("{}: the spectrum of a profile needs all heights defined; remove the undefined points",
                        topography::label(profile.metadata)));
    const auto n = profile.positions.size();
    WindowedPolyline line{profile.positions - profile.positions[0],
                          profile.heights,
                          {},
                          profile.size(),
                          0.0,
                          cosine_coefficients(window)};
    line.slope = (line.h.tail(n - 1) - line.h.head(n - 1)) / (line.x.tail(n - 1) - line.x.head(n - 1));
    line.base = 2.0 * pi / line.length;
    return line;
}

Array1D slope_changes(const WindowedPolyline& line) {
    const auto inner = line.slope.size() - 1;
    return line.slope.tail(inner) - line.slope.head(inner);
}

/// q*: above it the form with slope changes loses fewer digits. At least a few harmonics away from its poles, and with
/// at most a few Gauss points per segment.
double dividing_wavevector(const WindowedPolyline& line) {
    const auto segments = line.slope.size();
    const double area = (0.5 * (line.h.head(segments).abs() + line.h.tail(segments).abs()) *
                         (line.x.tail(segments) - line.x.head(segments)))
                            .sum();
    const double balanced = std::sqrt(slope_changes(line).abs().sum() / area);
    const double lowest = 4.0 * line.highest_harmonic() + 2.0 * line.base;
    const double highest = lowest + 4.0 * static_cast<double>(segments) / line.length;
    return balanced < highest ? std::max(balanced, lowest) : highest;  // also highest if area is 0
}

/// Six-point Gauss rule on −1 … 1. Source: Abramowitz & Stegun, Table 25.4.
constexpr std::array<std::array<double, 2>, 6> gauss_rule{{{-0.932469514203152028, 0.171324492379170345},
                                                           {-0.661209386466264514, 0.360761573048138608},
                                                           {-0.238619186083196909, 0.467913934572691047},
                                                           {0.238619186083196909, 0.467913934572691047},
                                                           {0.661209386466264514, 0.360761573048138608},
                                                           {0.932469514203152028, 0.171324492379170345}}};

Eigen::ArrayXcd by_gauss_points(const WindowedPolyline& line, const Array1D& q, double highest,
                                parallel::Threads threads) {
    std::vector<double> positions, values;
    for (Index k = 0; k < line.slope.size(); ++k) {
        const double length = line.x[k + 1] - line.x[k];
        const double pieces = std::ceil(length * (highest + line.highest_harmonic()));
        const double half = 0.5 * length / pieces;
        for (double piece = 0.0; piece < pieces; ++piece)
            for (const auto& [node, weight] : gauss_rule) {
                const double offset = half * (2.0 * piece + 1.0 + node);
                positions.push_back(line.x[k] + offset);
                values.push_back(weight * half * (line.h[k] + line.slope[k] * offset) * line.window(positions.back()));
            }
    }
    const auto n = static_cast<Index>(positions.size());
    return fourier::nonuniform_transform(Eigen::Map<const Array1D>(positions.data(), n),
                                         Eigen::Map<const Array1D>(values.data(), n), q, threads);
}

/// E_1 and E_2 in a form without cancellation if the window vanishes at its ends.
std::array<double, 2> end_factors(const WindowedPolyline& line, double q) {
    const double at_end = std::accumulate(line.cosines.begin(), line.cosines.end(), 0.0);
    std::array<double, 2> factors{at_end / q, at_end / (q * q)};
    for (std::size_t m = 1; m < line.cosines.size(); ++m) {
        const double shift = static_cast<double>(m) * line.base, s2 = shift * shift, q2 = q * q;
        factors[0] += line.cosines[m] * s2 / (q * (q2 - s2));
        factors[1] += line.cosines[m] * s2 * (3.0 * q2 - s2) / (q2 * (q2 - s2) * (q2 - s2));
    }
    return factors;
}

Eigen::ArrayXcd by_slope_changes(const WindowedPolyline& line, const Array1D& q, parallel::Threads threads) {
    const auto n = q.size();
    const auto highest = static_cast<Index>(line.cosines.size()) - 1;
    Array1D shifted((2 * highest + 1) * n);
    for (Index s = -highest; s <= highest; ++s)
        shifted.segment((s + highest) * n, n) = q - static_cast<double>(s) * line.base;
    const auto sums =
        fourier::nonuniform_transform(line.x.segment(1, line.slope.size() - 1), slope_changes(line), shifted, threads);

    Eigen::ArrayXcd result(n);
    const double first_height = line.h[0], last_height = line.h[line.h.size() - 1];
    const double first_slope = line.slope[0], last_slope = line.slope[line.slope.size() - 1];
    for (Index j = 0; j < n; ++j) {
        const auto [height_factor, slope_factor] = end_factors(line, q[j]);
        const Complex turn = std::polar(1.0, -q[j] * line.length);
        result[j] = Complex(0.0, height_factor) * (last_height * turn - first_height) +
                    slope_factor * (last_slope * turn - first_slope);
        for (Index s = -highest; s <= highest; ++s) {
            const double weight = line.cosines[static_cast<std::size_t>(std::abs(s))] * (s == 0 ? 1.0 : 0.5);
            const Index entry = (s + highest) * n + j;
            result[j] -= weight * sums[entry] / (shifted[entry] * shifted[entry]);
        }
    }
    return result;
}

}  // namespace

Array1D polyline_power_spectrum(const topography::Profile& profile, const ArrayView1D& wavevectors, Window window,
                                parallel::Threads threads) {
    const auto line = prepare(profile, window);
    if (!wavevectors.isFinite().all())
        throw InvalidArgument("the spectrum of a profile was requested at wavevectors that are not finite");
    const double limit = dividing_wavevector(line);
    std::vector<Index> low, high;
    for (Index j = 0; j < wavevectors.size(); ++j) (std::abs(wavevectors[j]) < limit ? low : high).push_back(j);
    const Array1D magnitude = wavevectors.abs();
    Array1D spectrum(wavevectors.size());
    if (!low.empty()) {
        const Array1D q = magnitude(low);
        spectrum(low) = by_gauss_points(line, q, q.maxCoeff(), threads).abs2() / line.length;
    }
    if (!high.empty()) spectrum(high) = by_slope_changes(line, magnitude(high), threads).abs2() / line.length;
    return spectrum;
}

}  // namespace setae::spectra
