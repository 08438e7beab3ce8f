// SPDX-License-Identifier: GPL-3.0-or-later
#include "contours/trace_smoothing.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace setae::imaging::trace_smoothing_test {
namespace {

constexpr double pi = 3.14159265358979323846;

Array1D white(Index n, double deviation, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal(0, deviation);
    Array1D series(n);
    for (auto& value : series) value = normal(engine);
    return series;
}

TEST(TraceSmoothing, TransmitsHalfOfAWaveAtTheSmoothingLength) {
    EXPECT_DOUBLE_EQ(spline_transfer(1.0, 0.0), 1.0);
    EXPECT_NEAR(spline_transfer(1.0 / 20, 20), 0.5, 1e-3);                       // q ℓ = 1
    EXPECT_NEAR(mean_spline_transfer(10) * 10, 1 / (2 * std::sqrt(2.0)), 1e-3);  // ∫_0^∞ dx/(1 + x⁴) = π/(2√2)
}

TEST(TraceSmoothing, SpectrumOfWhiteNoiseIsItsVariance) {
    const auto places = place_spectrum(white(20000, 0.7, 3));
    double sum = 0, width = 0;
    for (std::size_t i = 0; i < places.density.size(); ++i) {
        sum += places.density[i] * places.width[i];
        width += places.width[i];
    }
    EXPECT_NEAR(sum / width, 0.49, 0.05);  // 288 modes, each to 100 %: 6 %
    EXPECT_NEAR(width, pi - 0.08, 1e-12);
}

TEST(TraceSmoothing, SpectrumOfAWaveHasItsPeakAtTheWave) {
    Array1D wave(500);
    for (Index k = 0; k < wave.size(); ++k) wave[k] = 2 * std::sin(0.5 * static_cast<double>(k));
    const auto places = place_spectrum(wave);
    std::size_t most = 0;
    for (std::size_t i = 0; i < places.density.size(); ++i)
        if (places.density[i] > places.density[most]) most = i;
    EXPECT_NEAR(places.wavevector[most], 0.5, 0.6 * places.width[most]);  // the bin that holds it
}

TEST(TraceSmoothing, ExpectedErrorOfPureNoiseIsItsTransmittedPart) {
    const auto places = place_spectrum(Array1D::Zero(500));
    double through = 0.08;  // ∫ K² dq, longer waves unchanged
    for (double q = 0.08 + 5e-5; q < pi; q += 1e-4) through += 1e-4 * std::pow(spline_transfer(q, 2.0), 2);
    EXPECT_NEAR(expected_squares(places, 0.3, 2.0), 0.3 * through / pi, 0.01 * 0.3);
}

TEST(TraceSmoothing, IsLongForPureNoiseAndShortWithoutNoise) {
    EXPECT_GT(best_smoothing(place_spectrum(white(2000, 0.5, 1)), 0.25), 4);
    EXPECT_DOUBLE_EQ(best_smoothing(place_spectrum(white(2000, 0.5, 1)), 0.0), 0.2);
}

TEST(TraceSmoothing, LongRunVarianceCountsCorrelation) {
    const auto noise = white(40000, 1.0, 5);
    EXPECT_NEAR(long_run_variance(noise), 1.0, 0.1);
    Array1D mean(noise.size() - 2);  // of three neighbours: variance 1/3, its longest waves still 1
    for (Index k = 0; k < mean.size(); ++k) mean[k] = (noise[k] + noise[k + 1] + noise[k + 2]) / 3;
    EXPECT_NEAR(long_run_variance(mean), 3.0 / 9 + 2 * (8.0 / 9 * 2 / 9 + 7.0 / 9 * 1 / 9),
                0.06);  // Bartlett's weights remove a tenth
}

}  // namespace
}  // namespace setae::imaging::trace_smoothing_test
