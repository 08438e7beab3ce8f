// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/random_surface.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/map_transform.hpp"

namespace random_surface_test {

using namespace setae;
using namespace setae::synthesis;
using fourier::Complex;

using ComplexMap = Eigen::Array<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr spectra::SelfAffine model{1e-27, 2e7, 0.8, 4e8};
constexpr SurfaceGrid grid{48, 36, 1.2e-6, 0.9e-6};

/// c_q of lines ky = 0 … ny/2: line(ky), mode kx.
ComplexMap modes_of(const topography::HeightMap& map) {
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    ComplexMap modes(ny / 2 + 1, nx);
    fourier::transform_map(
        nx, ny, [&](Index i, double* line) { std::copy_n(map.heights.row(i).data(), ny, line); },
        [&](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m) std::copy_n(block.line(m), nx, modes.row(block.first + m).data());
        },
        {1});
    return modes / static_cast<double>(nx * ny);
}

double wavevector(Index kx, Index ky, const SurfaceGrid& of) {
    const double number = static_cast<double>(2 * kx > of.nx ? kx - of.nx : kx);
    return std::hypot(2.0 * pi * number / of.size_x, 2.0 * pi * static_cast<double>(ky) / of.size_y);
}

TEST(RandomSurface, WithExactAmplitudesHasTheSpectrumInEveryMode) {
    const auto C_iso = spectra::density(model);
    for (const auto& [nx, ny] : {std::pair<Index, Index>{48, 36}, {47, 36}, {48, 35}, {31, 33}, {2, 2}, {3, 64}}) {
        const SurfaceGrid shape{nx, ny, 1.2e-6, 0.9e-6};
        const auto map = random_surface(C_iso, shape, {.key = {4}, .amplitudes = Amplitudes::exact});
        const auto modes = modes_of(map);
        const double noise = 1e-13 * std::sqrt(model.plateau / 1.08e-12);
        for (Index ky = 0; ky <= ny / 2; ++ky)
            for (Index kx = 0; kx < nx; ++kx) {
                const double expected = kx + ky == 0 ? 0.0 : std::sqrt(C_iso(wavevector(kx, ky, shape)) / 1.08e-12);
                EXPECT_NEAR(std::abs(modes(ky, kx)), expected, 2e-6 * expected + noise)
                    << nx << " x " << ny << ": " << kx << ", " << ky;
            }
    }
}

TEST(RandomSurface, WithGaussianAmplitudesHasTheSpectrumOnAverage) {
    const auto C_iso = spectra::density(model);
    constexpr int surfaces = 200;
    Array2D power = Array2D::Zero(19, 48), fourth = power;
    for (std::uint64_t seed = 0; seed < surfaces; ++seed) {
        const Array2D norms = modes_of(random_surface(C_iso, grid, {.key = {seed}})).abs2();
        power += norms / surfaces;
        fourth += norms.square() / surfaces;
    }
    double chi_square = 0.0, kurtosis = 0.0;
    Index count = 0;
    for (Index ky = 0; ky < 19; ++ky)
        for (Index kx = 0; kx < 48; ++kx) {
            const double expected = C_iso(wavevector(kx, ky, grid)) / (grid.size_x * grid.size_y);
            const bool real = (ky == 0 || ky == 18) && (kx == 0 || kx == 24);
            if (expected == 0.0 || kx + ky == 0) continue;
            const double ratio = power(ky, kx) / expected;
            EXPECT_NEAR(ratio, 1.0, 5.0 * std::sqrt((real ? 2.0 : 1.0) / surfaces)) << kx << ", " << ky;
            if (real || (ky == 0 || ky == 18)) continue;
            chi_square += (ratio - 1.0) * (ratio - 1.0) * surfaces;
            kurtosis += fourth(ky, kx) / (expected * expected);
            ++count;
        }
    // |c|² is exponential: variance 1, second moment 2 (whose own variance is 20), in units of the mean
    const double n = static_cast<double>(count);
    EXPECT_NEAR(chi_square / n, 1.0, 4.0 * std::sqrt(2.2 / n));
    EXPECT_NEAR(kurtosis / n, 2.0, 4.0 * std::sqrt(20.0 / (n * surfaces)));
}

TEST(RandomSurface, HasZeroMeanAndTheExpectedRoughness) {
    const auto C_iso = spectra::density(model);
    const SurfaceOptions options{.key = {9}, .amplitudes = Amplitudes::exact};
    const auto map = random_surface(C_iso, grid, options);
    const auto expected = expected_roughness(C_iso, grid, options);
    EXPECT_LT(std::abs(map.heights.mean()), 1e-15 * expected.rms_height * 48.0);
    EXPECT_NEAR(std::sqrt(map.heights.square().mean()) / expected.rms_height, 1.0, 2e-6);
    double slope = 0.0;
    const auto modes = modes_of(map);
    for (Index ky = 0; ky < 19; ++ky)
        for (Index kx = 0; kx < 48; ++kx)
            slope +=
                (ky == 0 || ky == 18 ? 1.0 : 2.0) * std::norm(modes(ky, kx)) * std::pow(wavevector(kx, ky, grid), 2.0);
    EXPECT_NEAR(std::sqrt(slope) / expected.rms_slope, 1.0, 2e-6);
}

TEST(RandomSurface, OnALargeGridHasTheRoughnessOfTheModel) {
    // sums over modes against integrals of the closed form: the band holds 20 modes below the roll-off
    const spectra::SelfAffine wide{1e-27, 2e7, 0.7, 2.5e8};
    const SurfaceGrid large{512, 512, 6.4e-6, 6.4e-6};
    const auto expected = expected_roughness(spectra::density(wide), large);
    EXPECT_NEAR(expected.rms_height / spectra::rms_height(wide), 1.0, 3e-3);
    EXPECT_NEAR(expected.rms_slope / spectra::rms_slope(wide), 1.0, 3e-3);
}

TEST(RandomSurface, OnAFinerGridIsTheSameSurfaceWithMoreModes) {
    const auto C_iso = spectra::density(model);
    const SurfaceGrid fine{96, 75, grid.size_x, grid.size_y};
    for (const auto amplitudes : {Amplitudes::gaussian, Amplitudes::exact}) {
        const auto coarse_modes = modes_of(random_surface(C_iso, grid, {.key = {11, 5}, .amplitudes = amplitudes}));
        const auto fine_modes = modes_of(random_surface(C_iso, fine, {.key = {11, 5}, .amplitudes = amplitudes}));
        for (Index ky = 0; ky < 18; ++ky)
            for (Index kx = -23; kx < 24; ++kx) {
                const Complex a = coarse_modes(ky, (kx + 48) % 48), b = fine_modes(ky, (kx + 96) % 96);
                EXPECT_LT(std::abs(a - b), 1e-14 * std::sqrt(model.plateau) * 1e6) << kx << ", " << ky;
            }
    }
}

TEST(RandomSurface, IsTheSameBytesForAnyNumberOfThreads) {
    const auto C_iso = spectra::density(model);
    const SurfaceGrid odd{129, 70, 1e-6, 1e-6};
    const auto one = random_surface(C_iso, odd, {.key = {3}, .exact_rms_height = 1e-9, .threads = {1}});
    const auto three = random_surface(C_iso, odd, {.key = {3}, .exact_rms_height = 1e-9, .threads = {3}});
    EXPECT_TRUE((one.heights == three.heights).all());
    const auto other = random_surface(C_iso, odd, {.key = {4}, .exact_rms_height = 1e-9, .threads = {1}});
    EXPECT_FALSE((one.heights == other.heights).any());
}

TEST(RandomSurface, IsScaledToTheRequestedRmsHeight) {
    const auto map = random_surface(spectra::density(model), grid, {.key = {1}, .exact_rms_height = 5e-9});
    EXPECT_NEAR(std::sqrt(map.heights.square().mean()), 5e-9, 1e-22);
    EXPECT_TRUE(map.periodic);
    EXPECT_EQ(map.size[1], grid.size_y);
}

TEST(RandomSurface, StretchedHasLongerFeaturesAlongTheDirection) {
    // ⟨(∂h/∂along)²⟩ decreases by s² relative to across, rms height is constant; enough modes for sums to be integrals
    const spectra::SelfAffine inside{1e-27, 4e7, 0.9, 1e8};
    const SurfaceGrid large{256, 256, 2e-6, 2e-6};
    for (const double angle : {0.0, 0.5 * pi, 0.4}) {
        const SurfaceOptions options{.key = {2}, .amplitudes = Amplitudes::exact, .anisotropy = {3.0, angle}};
        const auto modes = modes_of(random_surface(spectra::density(inside), large, options));
        double height = 0.0, along = 0.0, across = 0.0, mixed = 0.0;
        for (Index ky = 0; ky <= 128; ++ky)
            for (Index k = 0; k < 256; ++k) {
                const double qx = pi * 1e6 * static_cast<double>(k > 128 ? k - 256 : k),
                             qy = pi * 1e6 * static_cast<double>(ky);
                const double power = (ky % 128 == 0 ? 1.0 : 2.0) * std::norm(modes(ky, k));
                const double q_along = qx * std::cos(angle) + qy * std::sin(angle),
                             q_across = qy * std::cos(angle) - qx * std::sin(angle);
                height += power;
                along += power * q_along * q_along;
                across += power * q_across * q_across;
                mixed += power * q_along * q_across;
            }
        EXPECT_NEAR(std::sqrt(height) / spectra::rms_height(inside), 1.0, 0.01) << angle;
        EXPECT_NEAR(std::sqrt(across / along), 3.0, 0.03) << angle;
        EXPECT_LT(std::abs(mixed), 0.01 * across) << angle;
    }
}

TEST(RandomSurface, RefusesInvalidGridsAndSpectra) {
    const auto C_iso = spectra::density(model);
    EXPECT_THROW((void)random_surface(C_iso, {1, 8, 1e-6, 1e-6}), InvalidArgument);
    EXPECT_THROW((void)random_surface(C_iso, {8, 8, 0.0, 1e-6}), InvalidArgument);
    EXPECT_THROW((void)random_surface(C_iso, {8, 8, 1e-6, INFINITY}), InvalidArgument);
    EXPECT_THROW((void)random_surface(C_iso, grid, {.anisotropy = {0.0, 0.0}}), InvalidArgument);
    EXPECT_THROW((void)random_surface(C_iso, grid, {.exact_rms_height = -1.0}), InvalidArgument);
    EXPECT_THROW((void)random_surface([](double) { return -1.0; }, grid), InvalidArgument);
    EXPECT_THROW((void)random_surface([](double q) { return q > 1e8 ? undefined : 1e-27; }, grid), InvalidArgument);
    EXPECT_THROW((void)random_surface([](double) { return 0.0; }, grid, {.exact_rms_height = 1e-9}), InvalidArgument);
}

Complex mode_of(const topography::LineScan& scan, Index k) {
    Complex sum{};
    for (Index i = 0; i < scan.heights.size(); ++i)
        sum += scan.heights[i] *
               std::polar(1.0, -2.0 * pi * static_cast<double>(i * k) / static_cast<double>(scan.heights.size()));
    return sum / static_cast<double>(scan.heights.size());
}

TEST(RandomLine, HasTheSpectrumInEveryMode) {
    const auto C1D = spectra::tabulated_density(Array1D{{1e6, 1e8, 1e9}}, Array1D{{1e-20, 1e-20, 1e-23}});
    for (const Index points : {2, 64, 65}) {
        const auto scan = random_line(C1D, {points, 1e-6}, {.key = {6}, .amplitudes = Amplitudes::exact});
        EXPECT_TRUE(scan.periodic);
        for (Index k = 1; k <= points / 2; ++k) {
            const double expected = std::sqrt(C1D(2e6 * pi * static_cast<double>(k)) / 1e-6);
            EXPECT_NEAR(std::abs(mode_of(scan, k)) / expected, 1.0, 3e-6) << points << ": " << k;
        }
        EXPECT_LT(std::abs(scan.heights.mean()), 1e-20);
    }
}

TEST(RandomLine, OnAFinerGridIsTheSameLineWithMoreModes) {
    const auto C1D = spectra::tabulated_density(Array1D{{1e6, 1e9}}, Array1D{{1e-20, 1e-23}});
    const auto coarse = random_line(C1D, {50, 1e-6}, {.key = {8}}), fine = random_line(C1D, {101, 1e-6}, {.key = {8}});
    for (Index k = 1; k < 25; ++k)
        EXPECT_LT(std::abs(mode_of(coarse, k) - mode_of(fine, k)), 1e-12 * std::abs(mode_of(fine, k)) + 1e-22);
}

TEST(RandomLine, HasTheExpectedOrRequestedRoughness) {
    const auto C1D = spectra::tabulated_density(Array1D{{1e6, 1e9}}, Array1D{{1e-20, 1e-23}});
    const auto expected = expected_roughness(C1D, LineGrid{500, 1e-5});
    const auto scan = random_line(C1D, {500, 1e-5}, {.key = {8}, .amplitudes = Amplitudes::exact});
    EXPECT_NEAR(std::sqrt(scan.heights.square().mean()) / expected.rms_height, 1.0, 2e-6);
    const auto scaled = random_line(C1D, {500, 1e-5}, {.key = {8}, .exact_rms_height = 2e-9});
    EXPECT_NEAR(std::sqrt(scaled.heights.square().mean()), 2e-9, 1e-22);
    EXPECT_THROW((void)random_line(C1D, {1, 1e-5}), InvalidArgument);
    EXPECT_THROW((void)random_line(C1D, {9, 1e-5}, {.anisotropy = {2.0, 0.0}}), InvalidArgument);
    EXPECT_THROW((void)random_line(C1D, {9, 1e-5}, {.exact_rms_height = 0.0}), InvalidArgument);
}

topography::HeightMap numbered() {
    return {.heights = Array2D::NullaryExpr(6, 5, [](Index i, Index j) { return static_cast<double>(10 * i + j); }),
            .size = {3.0, 10.0}};
}

TEST(Cut, IsTheWindowWithItsPixels) {
    const auto window = cut(numbered(), 2, 1, 3, 4);
    EXPECT_EQ(window.heights(0, 0), 21.0);
    EXPECT_EQ(window.heights(2, 3), 44.0);
    EXPECT_EQ(window.size[0], 1.5);
    EXPECT_EQ(window.size[1], 8.0);
    EXPECT_FALSE(window.periodic);
}

TEST(Cut, OfAPeriodicSurfaceCrossesItsEnds) {
    auto map = numbered();
    map.periodic = true;
    const auto window = cut(map, 5, -2, 2, 5);
    EXPECT_EQ(window.heights(0, 0), 53.0);
    EXPECT_EQ(window.heights(0, 2), 50.0);
    EXPECT_EQ(window.heights(1, 4), 2.0);
    EXPECT_FALSE(window.periodic);
}

TEST(Cut, RefusesWindowsThatDoNotFit) {
    EXPECT_THROW((void)cut(numbered(), 0, 0, 7, 5), InvalidArgument);
    EXPECT_THROW((void)cut(numbered(), 0, 0, 1, 5), InvalidArgument);
    EXPECT_THROW((void)cut(numbered(), 4, 0, 3, 5), InvalidArgument);
    EXPECT_THROW((void)cut(numbered(), 0, -1, 3, 3), InvalidArgument);
}

}  // namespace random_surface_test
