// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_coherence.hpp"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/power_spectrum.hpp"
#include "setae/spectra/spectrum_interval.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::spectra::line_coherence_test {
namespace {

using topography::HeightMap;

/// A part of a Gaussian surface with the autocorrelation exp(−(r/T)²), without the period of the surface.
HeightMap piece(Index points, double size, double T, std::uint64_t seed) {
    const SpectralDensity C_iso = [=](double q) { return std::exp(-0.25 * q * q * T * T); };
    const auto whole =
        synthesis::random_surface(C_iso, {2 * points, 2 * points, 2.0 * size, 2.0 * size}, {.key = {seed, 0}});
    return {Array2D(whole.heights.topLeftCorner(points, points)), {size, size}, false, {}};
}

/// Mean of 1/n over the lower half of the modes of some maps.
double mean_inverse(int maps, const std::function<HeightMap(std::uint64_t seed)>& map) {
    double sum = 0.0;
    for (int m = 0; m < maps; ++m) {
        const auto n = power_spectrum(map(static_cast<std::uint64_t>(m))).independent_lines;
        sum += (1.0 / n.head(n.size() / 2)).mean();
    }
    return sum / maps;
}

TEST(LineCoherence, OfWhiteNoiseIsTheNumberOfLines) {
    const auto white = [](std::uint64_t seed) {
        std::mt19937_64 random(seed);
        std::normal_distribution<double> normal;
        return HeightMap{Array2D::NullaryExpr(128, 128, [&] { return normal(random); }), {1.0, 1.0}, false, {}};
    };
    // one line fewer adds 0.008, limiting n to N where its error of 7 % exceeds N adds 0.4 × 0.07; statistical 0.004
    EXPECT_NEAR(mean_inverse(20, white) * 128.0, 1.036, 0.012);
}

TEST(LineCoherence, OfACorrugationIsOne) {
    const auto line = piece(128, 1.0, 0.02, 2);
    HeightMap corrugated{line.heights.col(0).replicate(1, 100), {1.0, 1.0}, false, {}};
    const auto spectrum = power_spectrum(corrugated);
    EXPECT_LT((spectrum.independent_lines - 1.0).abs().maxCoeff(), 1e-9);
    EXPECT_LT((spectrum.standard_error / spectrum.density - 1.0).abs().maxCoeff(), 1e-9);
}

TEST(LineCoherence, OfGaussianAutocorrelationHasItsClosedForm) {
    // C2D ∝ exp(−q²T²/4): n = L_y √(2/π)/T at every q_x
    const double T = 0.02, n = std::sqrt(2.0 / pi) / T;
    EXPECT_NEAR(mean_inverse(60, [=](std::uint64_t seed) { return piece(128, 1.0, T, seed); }) * n, 1.0,
                0.05);  // statistical 0.015, finite size −0.016
}

TEST(LineCoherence, StandardErrorIsTheScatterBetweenMaps) {
    const int maps = 60;
    const Index modes = 12;
    Array2D densities(maps, modes), errors(maps, modes);
    Array2D lower(maps, modes), upper(maps, modes);
    for (int m = 0; m < maps; ++m) {
        const auto spectrum = power_spectrum(piece(128, 1.0, 0.05, 100 + static_cast<std::uint64_t>(m)),
                                             {.trend = topography::Trend::tilt});
        const auto interval = interval_of(spectrum);
        densities.row(m) = spectrum.density.head(modes).transpose();
        errors.row(m) = (spectrum.standard_error / spectrum.density).head(modes).transpose();
        lower.row(m) = interval.lower.head(modes).transpose();
        upper.row(m) = interval.upper.head(modes).transpose();
    }
    const Array1D mean = densities.colwise().mean().transpose();
    double variance = 0.0, covered = 0.0;
    for (Index k = 0; k < modes; ++k) {
        variance += (densities.col(k) / mean[k] - 1.0).square().sum() / (maps - 1.0) / static_cast<double>(modes);
        covered += static_cast<double>((lower.col(k) < mean[k] && upper.col(k) > mean[k]).count());
    }
    // as many lines as pixels would give 0.09
    EXPECT_NEAR(std::sqrt(errors.square().mean() / variance), 1.0, 0.1);
    EXPECT_GT(covered / static_cast<double>(maps * modes), 0.92);
}

TEST(LineCoherence, OfOneLineIsOneWithoutStandardError) {
    const auto map = piece(64, 1.0, 0.05, 3);
    const auto spectrum = power_spectrum(topography::LineScan{map.heights.col(0), 1.0, false, {}});
    EXPECT_TRUE((spectrum.independent_lines == 1.0).all());
    EXPECT_TRUE(spectrum.standard_error.isNaN().all());
    // 2 C/χ²₂: −C/ln(1 − p) at p = 0.975 and 0.025
    const auto interval = interval_of(spectrum);
    EXPECT_NEAR(interval.lower[5] / spectrum.density[5], -1.0 / std::log(0.025), 1e-9);
    EXPECT_NEAR(interval.upper[5] / spectrum.density[5], -1.0 / std::log(0.975), 1e-9);
    EXPECT_THROW((void)interval_of(spectrum, 1.0), InvalidArgument);
    EXPECT_THROW((void)interval_of(MeasuredSpectrum{{.wavevector = Array1D::Ones(1), .density = Array1D::Ones(1)}}),
                 InvalidArgument);
}

}  // namespace
}  // namespace setae::spectra::line_coherence_test
