// SPDX-License-Identifier: GPL-3.0-or-later
#include "window_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "long_waves.hpp"
#include "patch_heights.hpp"
#include "setae/core/constants.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "spectral_moment.hpp"

namespace setae::laboratory {
namespace {

using synthesis::substream;

enum Stream : std::uint64_t { of_short_waves, of_level, of_long_waves, of_shorter_waves };

constexpr double modes_below_crossover = 6.0, windows_a_period = 8.0;

topography::HeightMap random_patch(const synthesis::SpectralDensity& C_iso, const synthesis::Anisotropy& anisotropy, const PatchShape& shape,
                                   synthesis::RandomKey key) {
    const double size_x = shape.pixel * static_cast<double>(shape.nx), size_y = shape.pixel * static_cast<double>(shape.ny);
    return synthesis::random_surface(C_iso, {shape.nx, shape.ny, size_x, size_y},
                                     {.key = substream(key, of_short_waves), .anisotropy = anisotropy, .threads = {1}});
}

/// Variance of the heights' waves that a grid with this pixel does not hold [m²].
double variance_between_pixels(const KnownSurface& surface, double pixel) {
    constexpr int directions = 64;  // of half a turn
    const double nyquist = pi / pixel, stretch = surface.anisotropy.stretch;
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) {
        const double angle = pi * (i + 0.5) / directions, from_long = angle - surface.anisotropy.angle;
        const double factor = std::hypot(stretch * std::cos(from_long), std::sin(from_long));
        const double lower = factor * nyquist / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
        sum += stretch / (factor * factor) * spectral_moment(surface.C_iso, 0.0, surface.band().lower, {lower, std::max(lower, surface.band().upper)});
    }
    return sum / directions / (2.0 * pi);
}

}  // namespace

topography::HeightMap window_patch(const KnownSurface& surface, const PatchShape& shape, synthesis::RandomKey key) {
    const double narrowest = std::min(shape.window, shape.pixel * static_cast<double>(shape.ny));
    const double crossover = 2.0 * pi * modes_below_crossover * surface.anisotropy.stretch / narrowest;
    double longest = shape.pixel * static_cast<double>(shape.nx);
    topography::HeightMap map;
    if (surface.band().lower > 1.5 * crossover) {
        map = random_patch(surface.C_iso, surface.anisotropy, shape, key);
    } else {
        const auto parts = split_spectrum(surface.C_iso, crossover);
        map = random_patch(parts.shorter, surface.anisotropy, shape, key);
        longest = windows_a_period * shape.window;
        const LongWaves waves(parts.longer, surface.anisotropy, std::numbers::sqrt2 * crossover, longest, substream(key, of_long_waves));
        for (Index lane = 0; lane < shape.lanes; ++lane) {
            const Index first = lane * shape.ny / shape.lanes, end = (lane + 1) * shape.ny / shape.lanes;
            waves.add_to(map, {.x = 0.0,
                               .y = longest * static_cast<double>(lane) / static_cast<double>(shape.lanes),
                               .first_column = first,
                               .columns = end - first});
        }
    }
    if (shape.pointwise) {
        const double rms = std::sqrt(variance_between_pixels(surface, shape.pixel));
        const Array1D noise = synthesis::normal_numbers(substream(key, of_shorter_waves), 0, map.heights.size());
        map.heights.reshaped<Eigen::RowMajor>() += rms * noise;
    }
    PatchHeights(surface, longest, substream(key, of_level))(map.heights.data(), map.heights.size());
    return map;
}

}  // namespace setae::laboratory
