// SPDX-License-Identifier: GPL-3.0-or-later
#include "trace_smoothing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace setae::imaging {
namespace {

constexpr int bins = 24, modes = 12;
constexpr double lowest = 0.08;                                            // 1/px
constexpr double shortest_length = 0.2, longest_length = 12, pace = 1.07;  // px
constexpr Index max_lags = 8;
constexpr double min_share = 0.05;  // of the variance: sums over lags may be negative

/// |Σ h exp(−iqk)|²/n.
double power(const Array1D& heights, double q) {
    double re = 0, im = 0, turn_re = 1, turn_im = 0;
    const double step_re = std::cos(q), step_im = std::sin(q);
    for (Index k = 0; k < heights.size(); ++k) {
        re += heights[k] * turn_re;
        im += heights[k] * turn_im;
        const double next = turn_re * step_re - turn_im * step_im;
        turn_im = turn_re * step_im + turn_im * step_re;
        turn_re = next;
    }
    return (re * re + im * im) / static_cast<double>(heights.size());
}

}  // namespace

double spline_transfer(double wavevector, double length) {
    const double bend = 2 - 2 * std::cos(wavevector);
    return 1 / (1 + std::pow(length, 4) * bend * bend);
}

double mean_spline_transfer(double length) {
    constexpr int nodes = 200;
    double sum = 0;
    for (int i = 0; i < nodes; ++i) sum += spline_transfer(std::numbers::pi * (i + 0.5) / nodes, length);
    return sum / nodes;
}

PlaceSpectrum place_spectrum(Array1D heights) {
    const Index n = heights.size();
    heights -= heights.mean();
    for (Index k = 0; k < n; ++k)
        heights[k] *= (1 - std::cos(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n))) /
                      std::sqrt(1.5);
    PlaceSpectrum found;
    const double ratio = std::pow(std::numbers::pi / lowest, 1.0 / bins);
    for (int b = 0; b < bins; ++b) {
        const double from = lowest * std::pow(ratio, b), to = from * ratio;
        double sum = 0;
        for (int m = 0; m < modes; ++m) sum += power(heights, from + (to - from) * (m + 0.5) / modes);
        found.wavevector.push_back(std::sqrt(from * to));
        found.density.push_back(sum / modes);
        found.width.push_back(to - from);
    }
    return found;
}

double expected_squares(const PlaceSpectrum& places, double noise, double length) {
    double sum = noise * lowest;  // longer waves are followed
    for (std::size_t i = 0; i < places.wavevector.size(); ++i) {
        const double k = spline_transfer(places.wavevector[i], length),
                     signal = std::max(0.0, places.density[i] - noise);
        sum += ((1 - k) * (1 - k) * signal + k * k * noise) * places.width[i];
    }
    return sum / std::numbers::pi;
}

double best_smoothing(const PlaceSpectrum& places, double noise) {
    double least = std::numeric_limits<double>::infinity(), best = shortest_length;
    for (double length = shortest_length; length < longest_length; length *= pace) {
        const double squares = expected_squares(places, noise, length);
        if (squares < least) {
            least = squares;
            best = length;
        }
    }
    return best;
}

double long_run_variance(const Array1D& series) {
    const Index n = series.size(), lags = std::min(max_lags, n / 4);
    const Array1D centred = series - series.mean();
    const double variance = centred.square().mean();
    double sum = variance;
    for (Index lag = 1; lag <= lags; ++lag)
        sum += 2 * (1 - static_cast<double>(lag) / static_cast<double>(lags + 1)) *
               (centred.head(n - lag) * centred.tail(n - lag)).sum() / static_cast<double>(n);
    return std::max(sum, min_share * variance);
}

}  // namespace setae::imaging
