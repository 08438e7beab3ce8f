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

namespace setae::simulation {
namespace {

using numerics::substream;

enum WindowStream : std::uint64_t { of_short_waves, of_window_level, of_long_waves, of_shorter_waves };

/// Relative to a patch's narrower side; ratio of widths of the next patch, and of the last one to the window.
constexpr double modes_below_crossover = 6.0, widening = 8.0, room = 1.25;

topography::HeightMap random_patch(const spectra::SpectralDensity& C_iso, const spectra::Anisotropy& anisotropy,
                                   const PatchShape& shape, numerics::RandomKey key) {
    const double size_x = shape.pixel * static_cast<double>(shape.nx),
                 size_y = shape.pixel * static_cast<double>(shape.ny);
    return synthesis::random_surface(C_iso, {shape.nx, shape.ny, size_x, size_y},
                                     {.key = substream(key, of_short_waves), .anisotropy = anisotropy, .threads = {1}});
}

/// Variance of the heights' waves that a grid with this pixel does not hold [m²].
double variance_between_pixels(const KnownSurface& surface, double pixel) {
    constexpr int directions = 64;  // directions of half a turn
    const double nyquist = pi / pixel, stretch = surface.anisotropy.stretch;
    double sum = 0.0;
    for (int i = 0; i < directions; ++i) {
        const double angle = pi * (i + 0.5) / directions, from_long = angle - surface.anisotropy.angle;
        const double factor = std::hypot(stretch * std::cos(from_long), std::sin(from_long));
        const double lower = factor * nyquist / std::max(std::abs(std::cos(angle)), std::abs(std::sin(angle)));
        const Band missing{lower, std::max(lower, surface.band().upper)};
        sum += stretch / (factor * factor) * spectral_moment(surface.C_iso, 0.0, surface.band().lower, missing);
    }
    return sum / directions / (2.0 * pi);
}

/// Adds one patch of long waves to all lanes of a map.
void add(const LongWaves& waves, double period_y, const PatchShape& shape, topography::HeightMap& map) {
    for (Index lane = 0; lane < shape.lanes; ++lane) {
        const Index first = lane * shape.ny / shape.lanes, end = (lane + 1) * shape.ny / shape.lanes;
        waves.add_to(map, {.x = 0.0,
                           .y = period_y * static_cast<double>(lane) / static_cast<double>(shape.lanes),
                           .first_column = first,
                           .columns = end - first});
    }
}

}  // namespace

topography::HeightMap window_patch(const KnownSurface& surface, const PatchShape& shape, numerics::RandomKey key) {
    double narrowest = std::min(shape.window, shape.pixel * static_cast<double>(shape.ny));
    double crossover = 2.0 * pi * modes_below_crossover * surface.anisotropy.stretch / narrowest;
    double longest = shape.pixel * static_cast<double>(shape.nx);
    auto parts = surface.band().lower > 1.5 * crossover ? SplitSpectrum{nullptr, surface.C_iso}
                                                        : split_spectrum(surface.C_iso, crossover);
    auto map = random_patch(parts.shorter, surface.anisotropy, shape, key);
    // a patch that is not as wide as the window is long leaves waves to the next one, which is wider
    for (std::uint64_t level = 0; parts.longer; ++level) {
        const double end = std::numbers::sqrt2 * crossover;
        const bool last = narrowest >= shape.window;
        const double wider = std::min(widening * narrowest, shape.window);
        LongWaves::Patch patch{
            .end = end, .period_x = room * shape.window, .period_y = std::max(room * wider, widening * narrowest)};
        if (last) {
            patch.period_x = patch.period_y = widening * shape.window;
            parts = {nullptr, parts.longer};
        } else {
            crossover *= narrowest / wider;
            parts = surface.band().lower > 1.5 * crossover ? SplitSpectrum{nullptr, parts.longer}
                                                           : split_spectrum(parts.longer, crossover);
        }
        narrowest = wider;
        longest = patch.period_x;
        add(LongWaves(parts.shorter, surface.anisotropy, patch, substream(substream(key, of_long_waves), level)),
            patch.period_y, shape, map);
    }
    if (shape.pointwise) {
        const double rms = std::sqrt(variance_between_pixels(surface, shape.pixel));
        const Array1D noise = numerics::normal_numbers(substream(key, of_shorter_waves), 0, map.heights.size());
        map.heights.reshaped<Eigen::RowMajor>() += rms * noise;
    }
    PatchHeights(surface, longest, substream(key, of_window_level))(map.heights.data(), map.heights.size());
    return map;
}

}  // namespace setae::simulation
