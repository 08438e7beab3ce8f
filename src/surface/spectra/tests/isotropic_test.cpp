// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/isotropic.hpp"

#include <complex>
#include <map>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/errors.hpp"

namespace isotropic_test {

using namespace setae;
using namespace setae::spectra;
using tests::random_map;
using topography::HeightMap;
using topography::Trend;

HeightMap map_of(Index nx, Index ny, bool periodic = true) { return {random_map(nx, ny), {2.0, 1.3}, periodic, {}}; }

TEST(PowerSpectrumMap, IsTheDoubleSumSquaredOverTheArea) {
    const auto map = map_of(7, 6);
    const auto spectrum = power_spectrum_map(map, {.trend = Trend::none});
    for (Index k = 0; k < 7; ++k)
        for (Index m = 0; m < 6; ++m) {
            std::complex<double> sum{};
            for (Index i = 0; i < 7; ++i)
                for (Index j = 0; j < 6; ++j)
                    sum += map.heights(i, j) *
                           std::polar(
                               1.0, -2.0 * pi * (static_cast<double>(i * k) / 7.0 + static_cast<double>(j * m) / 6.0));
            const double pixel_area = 2.0 * 1.3 / 42.0;
            EXPECT_NEAR(spectrum(k, m), std::norm(sum) * pixel_area * pixel_area / 2.6, 1e-14) << k << ", " << m;
        }
}

TEST(PowerSpectrumMap, KeepsParseval) {
    for (const auto& [nx, ny] : {std::pair<Index, Index>{16, 18}, {15, 17}, {16, 9}, {9, 16}}) {
        const auto map = map_of(nx, ny);
        const double variance = (map.heights - map.heights.mean()).square().mean();
        EXPECT_NEAR(power_spectrum_map(map).sum() / 2.6 / variance, 1.0, 1e-12);
    }
}

TEST(PowerSpectrumMap, OfAWindowedMapKeepsTheMeanSquare) {
    const HeightMap flat{Array2D::Ones(30, 20), {3.0, 2.0}, false, {}};
    for (const auto window : {Window::hann, Window::radial_hann, Window::blackman_harris})
        EXPECT_NEAR(power_spectrum_map(flat, {.window = window, .trend = Trend::none}).sum() / 6.0, 1.0, 1e-12)
            << name(window);
}

TEST(PowerSpectrumMap, OfARadialWindowMatchesTheFormula) {
    const auto map = map_of(12, 10, false);
    const Array2D window = Array2D::NullaryExpr(12, 10, [](Index i, Index j) {
        const double r = std::hypot(static_cast<double>(i - 6) * 2.0 / 12.0, static_cast<double>(j - 5) * 0.13);
        return r < 0.65 ? 0.5 + 0.5 * std::cos(pi * r / 0.65) : 0.0;
    });
    const Array2D scaled = window * std::sqrt(120.0 / window.square().sum());
    const HeightMap windowed{(map.heights - map.heights.mean()) * scaled, map.size, true, {}};
    const auto expected = power_spectrum_map(windowed, {.trend = Trend::none});
    EXPECT_LT((power_spectrum_map(map, {.window = Window::radial_hann}) - expected).abs().maxCoeff(), 1e-14);
}

/// Radial mean by computing the bin of every mode.
std::map<Index, std::array<double, 3>> radial_sums(const HeightMap& map, const LogGrid& grid,
                                                   const SpectrumOptions& options) {
    const auto spectrum = power_spectrum_map(map, options);
    const Index nx = spectrum.rows(), ny = spectrum.cols();
    const double lowest = 2.0 * pi / std::max(map.size[0], map.size[1]);
    const double highest = pi / std::max(map.pixel_size()[0], map.pixel_size()[1]);
    std::map<Index, std::array<double, 3>> sums;
    for (Index k = 0; k < nx; ++k)
        for (Index m = 0; m < ny; ++m) {
            const double qx = 2.0 * pi * static_cast<double>(std::min(k, nx - k)) / map.size[0];
            const double qy = 2.0 * pi * static_cast<double>(std::min(m, ny - m)) / map.size[1];
            const double q = std::hypot(qx, qy);
            if (q < lowest * (1.0 - 1e-12) || q > highest * (1.0 + 1e-12)) continue;
            auto& [power, wavevector, count] = sums[std::min(grid.bin_of(q), grid.bin_of(highest))];
            power += spectrum(k, m);
            wavevector += q;
            count += 1.0;
        }
    return sums;
}

TEST(IsotropicPowerSpectrum, IsTheMeanOfAllModesOfABin) {
    for (const auto& [nx, ny] : {std::pair<Index, Index>{40, 36}, {41, 37}, {64, 16}, {15, 80}}) {
        const auto map = map_of(nx, ny, false);
        const LogGrid grid;
        const auto spectrum = isotropic_power_spectrum(map, {}, grid);
        const auto expected = radial_sums(map, grid, {});
        ASSERT_EQ(static_cast<std::size_t>(spectrum.density.size()), expected.size());
        Index b = 0;
        for (const auto& [bin, sums] : expected) {
            EXPECT_EQ(spectrum.count[b], sums[2]);
            EXPECT_NEAR(spectrum.wavevector[b] * sums[2] / sums[1], 1.0, 1e-12);
            EXPECT_NEAR(spectrum.density[b] * sums[2] / sums[0], 1.0, 1e-12);
            ++b;
        }
    }
}

TEST(IsotropicPowerSpectrum, DoesNotDependOnTheDirectionOfAWave) {
    const auto wave = [](double sign) {
        return HeightMap{
            Array2D::NullaryExpr(64, 64,
                                 [=](Index i, Index j) {
                                     return std::cos(
                                         2.0 * pi *
                                         (5.0 * static_cast<double>(i) + sign * 3.0 * static_cast<double>(j)) / 64.0);
                                 }),
            {1.0, 1.0},
            true,
            {}};
    };
    const auto one = isotropic_power_spectrum(wave(1.0)), other = isotropic_power_spectrum(wave(-1.0));
    EXPECT_LT((one.density - other.density).abs().maxCoeff(), 1e-15);
    EXPECT_NEAR((one.density * one.count).sum(), 0.5, 1e-12);
}

// A cos(q·r) stores |q| A²/8 for any direction, only over modes inside the band; sums of waves store the sum.
TEST(EnergyOfModes, SumsTheEnergyOfEachWave) {
    constexpr Index nx = 48, ny = 35;
    constexpr double size_x = 2e-6, size_y = 1e-6;
    topography::HeightMap map{Array2D::Zero(nx, ny), {size_x, size_y}, true, {}};
    double total = 0.0, inside = 0.0;
    const Band band{2e7, 6e7};
    for (const auto& [k, m, amplitude] :
         {std::tuple{3, 0, 2e-9}, {0, 4, 1e-9}, {5, -7, 0.5e-9}, {-11, 2, 0.3e-9}, {24, 3, 0.2e-9}}) {
        for (Index i = 0; i < nx; ++i)
            for (Index j = 0; j < ny; ++j)
                map.heights(i, j) +=
                    amplitude *
                    std::cos(2.0 * pi * (static_cast<double>(k * i) / nx + static_cast<double>(m * j) / ny));
        const double q = 2.0 * pi * std::hypot(k / size_x, m / size_y);
        total += q * amplitude * amplitude / 8.0;
        if (q >= band.lower && q <= band.upper) inside += q * amplitude * amplitude / 8.0;
    }
    EXPECT_NEAR(energy_per_modulus_of_modes(map, {0.0, 1e12}) / total, 1.0, 1e-12);
    EXPECT_NEAR(energy_per_modulus_of_modes(map, band) / inside, 1.0, 1e-12);
    EXPECT_LT(inside, 0.9 * total);
}

TEST(IsotropicPowerSpectrum, IsUnaffectedByTilt) {
    auto map = map_of(32, 32, false);
    const SpectrumOptions options{.trend = Trend::tilt};
    const auto level = isotropic_power_spectrum(map, options);
    for (Index i = 0; i < 32; ++i) map.heights.row(i) += 100.0 * static_cast<double>(i);
    EXPECT_LT(((isotropic_power_spectrum(map, options).density - level.density) / level.density).abs().maxCoeff(),
              1e-9);
}

TEST(IsotropicPowerSpectrum, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto map = map_of(100, 90, false);
    const auto one = isotropic_power_spectrum(map, {.threads = {1}}),
               three = isotropic_power_spectrum(map, {.threads = {3}});
    EXPECT_TRUE((one.density == three.density).all());
    EXPECT_TRUE((power_spectrum_map(map, {.threads = {1}}) == power_spectrum_map(map, {.threads = {3}})).all());
}

TEST(IsotropicPowerSpectrum, OfUndefinedHeightsIsRefused) {
    auto map = map_of(10, 12);
    map.heights(9, 0) = undefined;
    for (const auto trend : {Trend::none, Trend::mean, Trend::tilt})
        EXPECT_THROW((void)isotropic_power_spectrum(map, {.trend = trend}), UndefinedDataError);
}

}  // namespace isotropic_test
