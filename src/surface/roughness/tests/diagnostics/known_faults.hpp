// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "setae/core/constants.hpp"
#include "setae/diagnostics/diagnose.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::diagnostics {

struct SurfaceKind {
    std::uint64_t seed = 1;
    double hurst_exponent = 0.8;
    double rolloff_in_sizes = 0.125;  ///< wavelength of the roll-off over the size
    double stretch = 1.0;
    double angle = 0.0;
};

/// A window of 128² points, 1 µm, of a Gaussian self-affine surface; h_rms about 10 nm for a roll-off at an eighth of
/// the size.
inline topography::HeightMap surface(const SurfaceKind& kind) {
    constexpr Index points = 128;
    constexpr double size = 1e-6;
    const double q_r = 2.0 * pi / (kind.rolloff_in_sizes * size), unit = 2.0 * pi / (0.125 * size);
    spectra::SelfAffine model{1.0, q_r, kind.hurst_exponent, 64.0 * pi * points / size};
    model.plateau = 4e-31 * std::pow(unit / q_r, 2.0 + 2.0 * kind.hurst_exponent);
    const auto whole =
        synthesis::random_surface(spectra::density(model), {4 * points, 4 * points, 4.0 * size, 4.0 * size},
                                  {.key = {kind.seed, 11}, .anisotropy = {kind.stretch, kind.angle}});
    auto map = synthesis::cut(whole, 0, 0, points, points);
    map.metadata.name = "map";
    return map;
}

/// Its first scan line.
inline topography::LineScan line_of(const topography::HeightMap& map) {
    return {map.heights.col(0), map.size[0], false, map.metadata};
}

/// Independent standard normal numbers.
inline Array2D noise(Index nx, Index ny, std::uint64_t seed) {
    const Array1D numbers = numerics::normal_numbers({seed, 5}, 0, nx * ny);
    return Eigen::Map<const Array2D>(numbers.data(), nx, ny);
}

inline double mean_square_slope_x(const topography::HeightMap& map) {
    const Index n = map.heights.rows();
    return (map.heights.bottomRows(n - 1) - map.heights.topRows(n - 1)).square().mean() /
           std::pow(map.pixel_size()[0], 2);
}

inline double mean_square_slope_y(const topography::HeightMap& map) {
    const Index n = map.heights.cols();
    return (map.heights.rightCols(n - 1) - map.heights.leftCols(n - 1)).square().mean() /
           std::pow(map.pixel_size()[1], 2);
}

/// Mean C1D of the last tenth of the modes.
inline double last_modes(const topography::HeightMap& map) {
    const auto spectrum = spectra::power_spectrum(topography::detrended(map, topography::Trend::tilt));
    return spectrum.density.tail(spectrum.density.size() / 10).mean();
}

/// Codes with a blank between.
inline std::string codes(const std::vector<Finding>& findings) {
    std::string all;
    for (const auto& finding : findings) all += (all.empty() ? "" : " ") + finding.alert.code;
    return all;
}

inline Quantity quantity(const std::vector<Finding>& findings, const std::string& code, const std::string& name) {
    for (const auto& finding : findings)
        for (const auto& effect : finding.effects)
            if (finding.alert.code == code && effect.quantity == name) return effect;
    return {};
}

inline double value(const std::vector<Finding>& findings, const std::string& code, const std::string& name) {
    const auto found = quantity(findings, code, name);
    return found.quantity.empty() ? undefined : found.estimate.value;
}

}  // namespace setae::diagnostics
