// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfaces/window_patch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "surfaces/long_waves.hpp"
#include "surfaces/surface_patches.hpp"

namespace setae::simulation::window_patch_test {
namespace {

constexpr double length = 1e-6;

/// Roll-off and cutoff as parts of the length.
KnownSurface self_affine(double rolloff, double shortest) {
    const spectra::SelfAffine model{1e-30, 2.0 * pi / (rolloff * length), 0.8, 2.0 * pi / (shortest * length)};
    return {.C_iso = spectra::density(model),
            .rolloff_wavelength = rolloff * length,
            .short_wavelength = shortest * length};
}

TEST(SplitSpectrum, SumsToTheWholeSpectrum) {
    const auto C_iso = self_affine(1.0, 0.01).C_iso;
    const auto parts = split_spectrum(C_iso, 1e8);
    for (const double q : {1e6, 0.8e8, 1e8, 1.3e8, 5e8})
        EXPECT_NEAR((parts.longer(q) + parts.shorter(q)) / C_iso(q), 1.0, 1e-14) << q;
    EXPECT_EQ(parts.shorter(0.7e8), 0.0);
    EXPECT_EQ(parts.longer(1.42e8), 0.0);
    EXPECT_NEAR(parts.longer(1e8) / C_iso(1e8), 0.5, 1e-12);
}

TEST(LongWaves, InterpolateTheSameSurfaceBetweenGridPoints) {
    // a finer grid of the same size and seed shows the same modes: an independent interpolation
    const double end = 2.0 * pi * 8.0 / length;
    const auto parts = split_spectrum(self_affine(10.0, 0.01).C_iso, end / std::sqrt(2.0));
    const LongWaves waves(parts.longer, {}, {.end = end, .period_x = 4.0 * length, .period_y = 4.0 * length}, {3, 4});
    const auto fine =
        synthesis::random_surface(parts.longer, {1024, 1024, 4.0 * length, 4.0 * length}, {.key = {3, 4}});
    topography::HeightMap map{.heights = Array2D::Zero(300, 120),
                              .size = {300.0 * length / 256.0, 120.0 * length / 256.0}};
    waves.add_to(
        map,
        {.x = 3.5 * length, .y = 3.75 * length, .first_column = 20, .columns = 100});  // over both ends of the patch
    double error = 0.0, power = 0.0;
    for (Index i = 0; i < 300; ++i)
        for (Index j = 0; j < 100; ++j) {
            const double exact = fine.heights((896 + i) % 1024, (960 + j) % 1024);
            error += std::pow(map.heights(i, j + 20) - exact, 2);
            power += exact * exact;
        }
    EXPECT_LT(std::sqrt(error / power), 2e-4);
    EXPECT_EQ(map.heights.leftCols(20).abs().maxCoeff(), 0.0);
}

TEST(WindowPatch, ContainsWavesFarLongerThanItself) {
    // roll-off at 50 windows: ⟨(h(x + d) − h(x))²⟩ = (2/π) ∫ C1D (1 − cos qd) dq at half a window; a map of its own
    // modes alone would turn back within it
    const KnownSurface surface = self_affine(50.0, 0.05);
    const LineSpectrum C1D(surface);
    const Index n = 40, distance = 16;
    const double pixel = length / 32.0;
    double expected = 0.0;
    constexpr double step = 1e-2;
    for (double t = std::log(1e-3 / length); t < std::log(2.0 * pi / (0.05 * length)); t += step) {
        const double q = std::exp(t + 0.5 * step);
        expected += 2.0 / pi * C1D(q) * (1.0 - std::cos(q * pixel * static_cast<double>(distance))) * q * step;
    }
    double sum = 0.0;
    constexpr int maps = 40;
    for (std::uint64_t seed = 0; seed < maps; ++seed) {
        const auto map =
            window_patch(surface, {.nx = n, .ny = n, .pixel = pixel, .window = length, .pointwise = true}, {seed, 1});
        sum += 0.5 * (map.heights.middleRows(12, 8) - map.heights.middleRows(12 + distance, 8)).square().mean();
        sum += 0.5 * (map.heights.middleCols(12, 8) - map.heights.middleCols(12 + distance, 8)).square().mean();
    }
    // two directions a map, each about two independent lines: √(2/160)
    EXPECT_NEAR(sum / maps / expected, 1.0, 3.0 * 0.11);
}

TEST(StylusScan, WithoutTipKeepsTheVarianceOfWavesShorterThanItsStep) {
    // points 0.25 of the roll-off apart still scatter by the whole rms height
    const KnownSurface surface = self_affine(0.02, 1e-4);
    const StylusProtocol protocol{
        .lengths = std::vector<double>(20, length), .steps = {0.005 * length}, .tip_radius = 0.0};
    const double variance = std::pow(true_surface_values(surface).parameters.rms_height, 2);
    double sum = 0.0;
    for (const auto& scan : stylus_scans(surface, LineSpectrum(surface), protocol, {5, 6}))
        sum += scan.heights.square().mean();
    // 20 lines of 50 roll-offs: √(2/1000)
    EXPECT_NEAR(sum / 20.0 / variance, 1.0, 3.0 * std::sqrt(2.0 / 1000.0));
}

TEST(AfmMap, WithoutTipKeepsTheVarianceOfWavesShorterThanItsPixels) {
    const KnownSurface surface = self_affine(0.05, 1e-3);
    const AfmProtocol protocol{.sizes = {length, length, length, length}, .pixels = {32}, .tip_radius = 0.0};
    const double variance = std::pow(true_surface_values(surface).parameters.rms_height, 2);
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k) sum += afm_scan(surface, protocol, k, {5, 6}).heights.square().mean();
    EXPECT_NEAR(sum / 4.0 / variance, 1.0, 3.0 * std::sqrt(2.0 / (4.0 * 400.0)));
}

TEST(TemContour, HasTheCurvatureOfTheSurface) {
    // second differences a third of the shortest wave apart weigh the end of the spectrum: 10 % less with eight points
    // a wave
    const KnownSurface surface = self_affine(1.0, 4e-4);
    const LineSpectrum C1D(surface);
    const double distance = surface.short_wavelength / 3.0;
    double expected = 0.0;
    constexpr double step = 1e-3;
    for (double t = std::log(1e5); t < std::log(C1D.upper()); t += step) {
        const double q = std::exp(t + 0.5 * step);
        expected += C1D(q) / pi * std::pow(2.0 - 2.0 * std::cos(q * distance), 2) * q * step;
    }
    const TemProtocol protocol{
        .lengths = std::vector<double>(300, 20e-9), .step = distance, .steps = ContourSteps::regular};
    double sum = 0.0;
    Index count = 0;
    for (std::size_t k = 0; k < protocol.lengths.size(); ++k) {
        const auto contour = tem_contour(surface, C1D, protocol, k, {7, 8});
        const Index n = contour.heights.size() - 2;
        sum += (contour.heights.tail(n) - 2.0 * contour.heights.segment(1, n) + contour.heights.head(n)).square().sum();
        count += n;
    }
    // three points a wave, correlated over one: √(2 · 3/45000) = 1.2 %
    EXPECT_NEAR(sum / static_cast<double>(count) / expected, 1.0, 0.03);
}

TEST(TemContour, OfAThickFoilLiesHigherThanALineScan) {
    const KnownSurface surface = self_affine(0.05, 2e-3);
    TemProtocol protocol{.lengths = {100e-9}, .step = 1e-9, .foil_thickness = 50e-9};
    const auto thick = tem_contour(surface, LineSpectrum(surface), protocol, 0, {7, 8});
    EXPECT_GT(thick.heights.mean(), true_surface_values(surface).parameters.rms_height);
}

TEST(StylusStrip, KeepsTheOrderOfTheProtocol) {
    const KnownSurface surface = self_affine(1.0, 4e-4);
    const StylusProtocol protocol{
        .lengths = {10e-6, 20e-6, 10e-6}, .steps = {0.5e-6, 0.5e-6, 0.25e-6}, .tip_radius = 5e-6, .tilt = 0.5};
    const auto scans = stylus_scans(surface, LineSpectrum(surface), protocol, {9, 1});
    ASSERT_EQ(scans.size(), 3u);
    EXPECT_EQ(scans[0].heights.size(), 20);
    EXPECT_EQ(scans[1].heights.size(), 40);
    EXPECT_EQ(scans[2].heights.size(), 40);
    // the tilt is far steeper than the surface: it ends as high as the scan is long
    EXPECT_NEAR(scans[1].heights[39] / (0.5 * 19.5e-6), 1.0, 0.01);
    EXPECT_NEAR(scans[2].heights[39] / (0.5 * 9.75e-6), 1.0, 0.01);
}

TEST(StylusStrip, UsesIndependentLanesForARolloffBeyondTheScan) {
    const KnownSurface surface = self_affine(1000.0, 4e-4);
    const StylusProtocol protocol{.lengths = {50e-6, 50e-6}, .steps = {0.5e-6}, .tip_radius = 5e-6};
    const auto scans = stylus_scans(surface, LineSpectrum(surface), protocol, {9, 1});
    ASSERT_EQ(scans.size(), 2u);
    // lanes lie elsewhere on the surface: their scans share nothing
    const auto& a = scans[0].heights;
    const auto& b = scans[1].heights;
    const Array1D first = a - a.mean(), second = b - b.mean();
    EXPECT_LT(std::abs((first * second).sum()) / std::sqrt(first.square().sum() * second.square().sum()), 0.95);
    EXPECT_EQ(a.size(), 100);
}

}  // namespace
}  // namespace setae::simulation::window_patch_test
