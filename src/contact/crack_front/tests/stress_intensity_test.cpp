// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/stress_intensity.hpp"

#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace stress_intensity_test {

using namespace setae;
using namespace setae::crack_front;

topography::HeightMap wave(Index n, double kx, double ky, double phase = 0.0) {
    const auto size = static_cast<double>(n);
    topography::HeightMap map{Array2D(n, n), {size, size}, true, {}};
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            map.heights(i, j) =
                std::cos(2.0 * pi * (kx * static_cast<double>(i) + ky * static_cast<double>(j)) / size + phase);
    return map;
}

topography::HeightMap rough(Index n, std::uint64_t seed, double shortest = 8.0, double longest = 32.0) {
    const auto size = static_cast<double>(n);
    return synthesis::random_surface(
        spectra::density(spectra::SelfAffine{1.0, 2.0 * pi / longest, 0.8, 2.0 * pi / shortest}), {n, n, size, size},
        {.key = {seed}});
}

// E* A √(π/λ), against the peak along the front and an eighth of a wave ahead of it on its way (Sanner et al. 2024)
TEST(StressIntensity, OfAxialWavesMatchesTheClosedForm) {
    const double modulus = 2.0, wavelength = 16.0, amplitude = modulus * std::sqrt(pi / wavelength);
    const auto along = stress_intensity_on_parallels(wave(64, 0, 4), {modulus, 8.0, {}});
    const auto across = stress_intensity_on_parallels(wave(64, 4, 0), {modulus, 8.0, {}});
    const double q = 2.0 * pi / wavelength;
    for (Index j = 0; j < 64; ++j)
        for (Index k = 0; k < 64; ++k) {
            EXPECT_NEAR(along.values(j, k), -amplitude * std::cos(q * static_cast<double>(j)), 1e-13);
            EXPECT_NEAR(across.values(j, k), amplitude * std::cos(q * static_cast<double>(k) - 0.75 * pi), 1e-13);
        }
}

// K = √(2/π) ∫∫ σ √s/(π (s² + ζ²)) ds dζ with σ = −(E*/2)|q| h, the weight function of a half-plane crack; over ζ it is
// exp(−|q_z| s)/√s, and s = t² leaves a smooth integral
TEST(StressIntensity, OfAnObliqueWaveMatchesTheWeightFunctionIntegral) {
    const auto found = stress_intensity_on_parallels(wave(64, 3, 5), {1.0, 8.0, {}});
    const double qx = 2.0 * pi * 3.0 / 64.0, qz = 2.0 * pi * 5.0 / 64.0, q = std::hypot(qx, qz);
    std::complex<double> integral = 0.0;
    const double step = 1e-3;
    for (double t = 0.5 * step; t < 9.0; t += step)
        integral += 2.0 * step * std::exp(-qz * t * t) * std::polar(1.0, qx * t * t);
    for (Index j = 0; j < 64; j += 7)
        for (Index k = 0; k < 64; k += 5) {
            const auto place = std::polar(1.0, qx * static_cast<double>(k) + qz * static_cast<double>(j));
            const double expected = -0.5 * q * std::sqrt(2.0 / pi) * (integral * place).real();
            EXPECT_NEAR(found.values(j, k), expected, 1e-6);
        }
}

TEST(StressIntensity, MeanSquareIsTwiceModulusTimesStoredEnergy) {
    const auto map = rough(128, 3);
    const auto found = stress_intensity_on_parallels(map, {0.75, 2.0, {}});
    EXPECT_NEAR(found.values.square().mean() / (2.0 * 0.75 * found.stored_energy), 1.0, 1e-12);
}

// on rays the mean is over a disc, twice as many independent places as waves: it scatters over realisations
TEST(StressIntensity, OnRaysHasTheSameMeanSquareWithinScatter) {
    constexpr int realisations = 16;
    const LinePoints radii{61, 0.0, 0.5};
    double mean = 0.0, squares = 0.0;
    for (int seed = 0; seed < realisations; ++seed) {
        const auto found = stress_intensity_on_rays(rough(128, 10 + seed), {1.0, 8.0, {40.0, 70.0}}, 64, radii);
        double sum = 0.0, weight = 0.0;
        for (Index k = 0; k < radii.count; ++k) {
            sum += radii.at(k) * found.values.col(k).square().mean();
            weight += radii.at(k);
        }
        const double ratio = sum / weight / (2.0 * found.stored_energy);
        mean += ratio / realisations;
        squares += ratio * ratio / realisations;
    }
    const double error = std::sqrt((squares - mean * mean) / (realisations - 1));
    EXPECT_LT(error, 0.05);
    EXPECT_NEAR(mean, 1.0, 3.0 * error);
}

TEST(StressIntensity, OnRaysEqualsTheSumOverRotatedModes) {
    const double qx = 2.0 * pi * 3.0 / 64.0, qy = 2.0 * pi * 5.0 / 64.0, phase = 0.3;
    const LinePoints radii{80, 0.0, 0.25};
    const std::array<double, 2> centre{10.0, 20.0};
    const auto found = stress_intensity_on_rays(wave(64, 3, 5, phase), {1.0, 8.0, centre}, 64, radii);
    const double rms = std::sqrt(found.values.square().mean());
    for (Index j = 0; j < 64; ++j) {
        const double angle = 2.0 * pi * static_cast<double>(j) / 64.0, c = std::cos(angle), s = std::sin(angle);
        const auto factor = std::sqrt(std::complex<double>(std::abs(qy * c - qx * s), qx * c + qy * s));
        for (Index k = 0; k < radii.count; ++k) {
            const double x = centre[0] + radii.at(k) * c, y = centre[1] + radii.at(k) * s;
            const double expected = -(factor * std::polar(1.0, qx * x + qy * y + phase)).real() / std::sqrt(2.0);
            EXPECT_NEAR(found.values(j, k), expected, 5e-6 * rms);
        }
    }
}

TEST(StressIntensity, OfARingEqualsThatOfTheWholeField) {
    const auto map = rough(64, 5);
    const MapOnFront options{1.0, 8.0, {32.0, 32.0}};
    const auto whole = stress_intensity_on_rays(map, options, 64, {60, 0.0, 0.5});
    const auto ring = stress_intensity_on_rays(map, options, 64, {20, 15.0, 0.5});
    const double rms = std::sqrt(whole.values.square().mean());
    EXPECT_LT((whole.values.middleCols(30, 20) - ring.values).abs().maxCoeff(), 1e-5 * rms);
}

TEST(StressIntensity, HasTheSameBytesForAnyNumberOfThreads) {
    const auto map = rough(64, 6);
    const MapOnFront options{1.0, 8.0, {32.0, 32.0}};
    const auto one = stress_intensity_on_rays(map, options, 64, {60, 0.0, 0.5}, {1});
    const auto three = stress_intensity_on_rays(map, options, 64, {60, 0.0, 0.5}, {3});
    EXPECT_TRUE((one.values == three.values).all());
}

// inside the circle a map that ends has K of the periodic one, up to what lies outside
TEST(StressIntensity, OfANonPeriodicMapMatchesThePeriodicOneInside) {
    auto map = rough(128, 7, 8.0, 16.0);
    const MapOnFront options{1.0, 8.0, {64.0, 64.0}};
    const LinePoints radii{41, 0.0, 1.0};
    const auto periodic = stress_intensity_on_rays(map, options, 80, radii);
    map.periodic = false;
    const auto ends = stress_intensity_on_rays(map, options, 80, radii);
    const double rms = std::sqrt(periodic.values.square().mean());
    EXPECT_LT((periodic.values - ends.values).leftCols(30).square().mean(), 0.01 * rms * rms);
}

// Of the surface that the map shows, not of what is left of it behind the fade
TEST(StressIntensity, OfANonPeriodicMapHasTheStoredEnergyOfItsSurface) {
    constexpr int seeds = 6;
    double mean = 0.0, squares = 0.0;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        auto map = rough(128, seed, 8.0, 16.0);
        const auto stored = [&] {
            return stress_intensity_on_rays(map, {1.0, 8.0, {64.0, 64.0}}, 80, {41, 0.0, 1.0}).stored_energy;
        };
        const double whole = stored();
        map.periodic = false;
        const double ratio = stored() / whole;
        mean += ratio / seeds;
        squares += ratio * ratio / seeds;
    }
    const double error = std::sqrt((squares - mean * mean) / (seeds - 1));
    EXPECT_LT(error, 0.1);
    EXPECT_NEAR(mean, 1.0, 3.0 * error);
}

TEST(StressIntensity, WorksOnRaysEqualTheMap) {
    auto map = wave(64, 2, 1);
    map.heights += 3.0;
    const auto field = works_on_rays(map, {1.0, 8.0, {32.0, 32.0}}, 64, {40, 0.0, 0.5});
    EXPECT_NEAR(field.mean_work, 3.0, 1e-12);
    for (Index k = 0; k < 40; k += 13)
        EXPECT_NEAR(field.works(0, k),
                    3.0 + std::cos(2.0 * pi * (2.0 * (32.0 + 0.5 * static_cast<double>(k)) + 32.0) / 64.0), 1e-5);
}

TEST(StressIntensity, RefusesCoarseRays) {
    const auto map = rough(64, 1);
    const MapOnFront options{1.0, 8.0, {32.0, 32.0}};
    EXPECT_THROW((void)stress_intensity_on_rays(map, options, 64, {10, 0.0, 3.0}), InvalidArgument);
    EXPECT_THROW((void)stress_intensity_on_rays(map, options, 8, {60, 0.0, 0.5}), InvalidArgument);
    EXPECT_THROW((void)stress_intensity_on_rays(map, {1.0, 1.0, {}}, 64, {60, 0.0, 0.5}), InvalidArgument);
}

}  // namespace stress_intensity_test
