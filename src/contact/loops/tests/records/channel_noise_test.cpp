// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/channel_noise.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "records/baseline.hpp"
#include "setae/core/constants.hpp"
#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::channel_noise_test {
namespace {

/// A process of standard deviation 1 with ρ_k = φ^k.
Array1D low_pass(Index n, double phi, std::mt19937_64& generator) {
    std::normal_distribution<double> normal;
    Array1D values(n);
    double last = normal(generator);
    for (double& value : values) {
        value = last;
        last = phi * last + std::sqrt(1.0 - phi * phi) * normal(generator);
    }
    return values;
}

TEST(FreeFlightNoise, RecoversTheNoiseAtAnyCorrelation) {
    std::mt19937_64 generator(4);
    constexpr int draws = 300;
    constexpr Index n = 400;
    for (const double phi : {0.0, 0.5, 0.8, 0.9}) {
        double sigma = 0.0, correlation = 0.0, white = 0.0;
        for (int k = 0; k < draws; ++k) {
            const Array1D series = low_pass(n, phi, generator) + Array1D::LinSpaced(n, -30.0, 50.0);
            const FreeFlightNoise noise = free_flight_noise(series);
            sigma += noise.sigma / draws;
            correlation += noise.correlation / draws;
            white += white_noise(series) / draws;
        }
        EXPECT_NEAR(sigma, 1.0, 0.03) << phi;
        EXPECT_NEAR(correlation, phi, 0.01) << phi;
        // result of second differences only
        EXPECT_NEAR(white, std::sqrt((6.0 - 8.0 * phi + 2.0 * phi * phi) / 6.0), 0.01) << phi;
    }
}

TEST(FreeFlightNoise, OfFewOrIndependentSamplesUsesSecondDifferences) {
    std::mt19937_64 generator(5);
    int independent = 0;
    for (int k = 0; k < 200; ++k) {
        const Array1D series = low_pass(200, 0.0, generator);
        const FreeFlightNoise noise = free_flight_noise(series);
        if (noise.correlation > 0.0) continue;
        ++independent;
        EXPECT_EQ(noise.sigma, white_noise(series));
    }
    EXPECT_GE(independent, 190);
    EXPECT_EQ(free_flight_noise(low_pass(10, 0.9, generator)).correlation, 0.0);
    EXPECT_EQ(free_flight_noise(Array1D::LinSpaced(50, 0.0, 1.0)).correlation, 0.0);
    EXPECT_EQ(free_flight_noise(Array1D()).sigma, 0.0);
}

TEST(FreeFlightNoise, ErrorOfTheZeroOfForceCoversTheTrueZero) {
    std::mt19937_64 generator(6);
    constexpr int draws = 300;
    for (const double phi : {0.0, 0.5, 0.8, 0.9}) {
        double squares = 0.0;
        for (int k = 0; k < draws; ++k) {
            const Baseline baseline =
                baseline_over({.force = low_pass(600, phi, generator)}, {.first = 0, .last = 599});
            squares += std::pow(baseline.force / baseline.force_standard_error, 2) / draws;
        }
        // the median of correlated samples scatters less beyond their mean than that of independent ones
        EXPECT_GT(std::sqrt(squares), 0.75) << phi;
        EXPECT_LT(std::sqrt(squares), 1.2) << phi;
    }
}

TEST(FreeFlightNoise, DefaultFitsAreUnbiasedInLowPassNoise) {
    const contact::jkr::Contact lens{.radius = 1.25e-3, .contact_modulus = 0.92e6, .work_of_adhesion = 0.040};
    tests::SyntheticLoop smooth{.approach = lens, .retraction_work = 0.040};
    smooth.even_in_displacement = true;
    const Loop clean = smooth.make();
    const double force_unit = clean.force.maxCoeff() / 30.0, depth_unit = clean.displacement.maxCoeff() / 30.0,
                 radius_unit = clean.contact_radius.maxCoeff() / 100.0;
    constexpr int draws = 24;
    for (const double phi : {0.0, 0.5, 0.8, 0.9}) {
        std::mt19937_64 generator(7);
        double modulus = 0.0, work = 0.0, modulus_squares = 0.0;
        for (int k = 0; k < draws; ++k) {
            Loop loop = clean;
            const Index n = loop.force.size();
            loop.force += force_unit * low_pass(n, phi, generator);
            loop.displacement += depth_unit * 0.1 * low_pass(n, phi, generator);
            const Array1D seen = tests::with_noise(loop.contact_radius, radius_unit, generator);
            for (Index i = 0; i < n; ++i)
                if (loop.contact_radius[i] > 0.0) loop.contact_radius[i] = std::max(seen[i], 0.0);
            const LoopAnalysis analysis = analyse(loop, tests::rubber_on_diamond());
            const JkrFit& fit = analysis.loading.primary();
            modulus += fit.contact_modulus.value / lens.contact_modulus / draws;
            work += fit.work_of_adhesion.value / lens.work_of_adhesion / draws;
            modulus_squares += std::pow(fit.contact_modulus.value / lens.contact_modulus, 2) / draws;
        }
        const double error = std::sqrt((modulus_squares - modulus * modulus) / draws);
        EXPECT_NEAR(modulus, 1.0, 0.01 + 3.0 * error) << phi;
        EXPECT_NEAR(work, 1.0, 0.04) << phi;
    }
}

}  // namespace
}  // namespace setae::loops::channel_noise_test
