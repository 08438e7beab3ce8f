// SPDX-License-Identifier: GPL-3.0-or-later
#include "long_waves.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "fast_length.hpp"
#include "setae/core/constants.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::simulation {
namespace {

/// Share of the long waves.
double long_share(double ratio) {
    constexpr double half_octave = 0.5 * std::numbers::ln2;
    if (!(ratio > 0.0)) return 1.0;
    const double place = std::log(ratio) / half_octave;  // −1 … 1 over the crossover
    if (place <= -1.0) return 1.0;
    if (place >= 1.0) return 0.0;
    return 0.5 - 0.5 * std::sin(0.5 * pi * place);
}

constexpr Index taps = 8;

/// Lagrange's weights of eight neighbours for equidistant positions on a periodic grid.
struct Taps {
    Index first = 0;  ///< may be negative or beyond the grid
    std::array<double, taps> weights{};
};

Taps taps_at(double place) {
    const double left = std::floor(place);
    Taps result{.first = static_cast<Index>(left) - taps / 2 + 1};
    for (Index k = 0; k < taps; ++k) {
        double weight = 1.0;
        for (Index other = 0; other < taps; ++other)
            if (other != k)
                weight *= (place - static_cast<double>(result.first + other)) / static_cast<double>(k - other);
        result.weights[static_cast<std::size_t>(k)] = weight;
    }
    return result;
}

Index wrapped(Index i, Index n) { return (i % n + n) % n; }

}  // namespace

SplitSpectrum split_spectrum(const spectra::SpectralDensity& C_iso, double wavevector) {
    return {
        .longer =
            [=](double q) { return long_share(q / wavevector) > 0.0 ? long_share(q / wavevector) * C_iso(q) : 0.0; },
        .shorter =
            [=](double q) {
                return long_share(q / wavevector) < 1.0 ? (1.0 - long_share(q / wavevector)) * C_iso(q) : 0.0;
            }};
}

LongWaves::LongWaves(const spectra::SpectralDensity& spectrum, const spectra::Anisotropy& anisotropy,
                     const Patch& patch, numerics::RandomKey key) {
    const auto points = [&](double period) {
        return fast_length(static_cast<double>(taps) * period * patch.end / (2.0 * pi));
    };
    patch_ = synthesis::random_surface(spectrum,
                                       {points(patch.period_x), points(patch.period_y), patch.period_x, patch.period_y},
                                       {.key = key, .anisotropy = anisotropy, .threads = {1}});
}

void LongWaves::add_to(topography::HeightMap& map, const Window& window) const {
    const Index nx = patch_.heights.rows(), ny = patch_.heights.cols();
    const auto step = patch_.pixel_size();
    const auto pixel = map.pixel_size();
    std::vector<Taps> across(static_cast<std::size_t>(window.columns));
    for (Index j = 0; j < window.columns; ++j)
        across[static_cast<std::size_t>(j)] = taps_at((window.y + static_cast<double>(j) * pixel[1]) / step[1]);
    const Index first = across.front().first, count = across.back().first + taps - first;
    Array1D line(count);
    for (Index i = 0; i < map.heights.rows(); ++i) {
        const Taps along = taps_at((window.x + static_cast<double>(i) * pixel[0]) / step[0]);
        line.setZero();
        for (Index k = 0; k < taps; ++k) {
            const double* row = &patch_.heights(wrapped(along.first + k, nx), 0);
            const double weight = along.weights[static_cast<std::size_t>(k)];
            for (Index c = 0; c < count; ++c) line[c] += weight * row[wrapped(first + c, ny)];
        }
        double* heights = &map.heights(i, window.first_column);
        for (Index j = 0; j < window.columns; ++j) {
            const Taps& taps_of = across[static_cast<std::size_t>(j)];
            const double* at = line.data() + (taps_of.first - first);
            double sum = 0.0;
            for (Index k = 0; k < taps; ++k) sum += taps_of.weights[static_cast<std::size_t>(k)] * at[k];
            heights[j] += sum;
        }
    }
}

}  // namespace setae::simulation
