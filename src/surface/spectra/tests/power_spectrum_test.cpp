// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/power_spectrum.hpp"

#include <algorithm>
#include <complex>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/errors.hpp"

namespace power_spectrum_test {

using namespace setae;
using namespace setae::spectra;
using tests::random_heights;
using tests::random_map;
using topography::HeightMap;
using topography::LineScan;
using topography::Trend;

/// (2/L) sum g C with half the weight for the Nyquist mode of an even number of points.
double variance_of(const MeasuredSpectrum& spectrum, Index points) {
    Array1D weight = Array1D::Ones(spectrum.density.size());
    if (points % 2 == 0) weight[weight.size() - 1] = 0.5;
    return 2.0 / spectrum.length * (weight * spectrum.density).sum();
}

double variance_of(const Array1D& values) { return (values - values.mean()).square().mean(); }

LineScan sine(double amplitude, Index periods, Index n, double length) {
    const auto heights = Array1D::NullaryExpr(n, [&](Index i) {
        return amplitude * std::cos(2.0 * pi * static_cast<double>(periods * i) / static_cast<double>(n) + 0.3);
    });
    return {heights, length, true, {}};
}

TEST(PowerSpectrum, OfASineIsASquaredLengthOverFour) {
    for (const double length : {1e-6, 3.0}) {
        const auto spectrum = power_spectrum(sine(2.0, 5, 64, length));
        EXPECT_NEAR(spectrum.density[4], 4.0 * length / 4.0, 1e-12 * length);
        EXPECT_NEAR(spectrum.wavevector[4], 2.0 * pi * 5.0 / length, 1e-12 / length);
        auto others = spectrum.density;
        others[4] = 0.0;
        EXPECT_LT(others.maxCoeff(), 1e-28 * length);
    }
}

TEST(PowerSpectrum, OfASineUnderAHannWindowSpreadsOverThreeModes) {
    auto scan = sine(2.0, 20, 64, 1.0);
    scan.periodic = false;
    const auto spectrum = power_spectrum(scan);
    EXPECT_EQ(spectrum.window, "hann");
    EXPECT_NEAR(spectrum.density[19], 2.0 / 3.0, 1e-12);
    EXPECT_NEAR(spectrum.density[18], 1.0 / 6.0, 1e-12);
    EXPECT_NEAR(spectrum.density[20], 1.0 / 6.0, 1e-12);
    EXPECT_LT(spectrum.density[21], 1e-28);
}

TEST(PowerSpectrum, KeepsParsevalForEvenAndOddNumbersOfPoints) {
    for (const Index n : {2, 3, 10, 11, 512, 999}) {
        const auto heights = random_heights(n);
        const auto spectrum = power_spectrum(LineScan{heights, 2.0, true, {}});
        ASSERT_EQ(spectrum.density.size(), n / 2);
        EXPECT_NEAR(variance_of(spectrum, n) / variance_of(heights), 1.0, 1e-12) << n;
    }
}

TEST(PowerSpectrum, KeepsParsevalUnderAnyWindow) {
    const Index n = 501;
    const auto heights = random_heights(n);
    for (const auto window : {Window::hann, Window::blackman_harris}) {
        const auto spectrum = power_spectrum(LineScan{heights, 2.0, false, {}}, {.window = window});
        const Array1D windowed = (heights - heights.mean()) * window_values(window, n);
        EXPECT_NEAR(variance_of(spectrum, n) / variance_of(windowed), 1.0, 1e-12);
    }
}

TEST(PowerSpectrum, OfAMapIsTheMeanOfItsLines) {
    const HeightMap map{random_map(30, 21), {3.0, 2.1}, false, {}};
    const auto spectrum = power_spectrum(map);
    Array1D mean = Array1D::Zero(15);
    for (Index j = 0; j < 21; ++j) mean += power_spectrum(LineScan{map.heights.col(j), 3.0, false, {}}).density / 21.0;
    EXPECT_LT(((spectrum.density - mean) / mean).abs().maxCoeff(), 1e-12);
    EXPECT_LT((spectrum.standard_error / mean * spectrum.independent_lines.sqrt() - 1.0).abs().maxCoeff(), 1e-12);
    EXPECT_TRUE((spectrum.count == 21.0).all());
}

TEST(PowerSpectrum, OfAMapKeepsParseval) {
    for (const Index n : {24, 25}) {
        const HeightMap map{random_map(n, 17), {1.0, 1.0}, true, {}};
        double variance = 0.0;
        for (Index j = 0; j < 17; ++j) variance += variance_of(map.heights.col(j)) / 17.0;
        EXPECT_NEAR(variance_of(power_spectrum(map), n) / variance, 1.0, 1e-12);
    }
}

TEST(PowerSpectrum, IsUnaffectedByTheRemovedTrend) {
    const Index n = 40;
    const auto heights = random_heights(n);
    const Array1D x = Array1D::LinSpaced(n, 0.0, 1.0);
    const SpectrumOptions options{.trend = Trend::parabola};
    const auto flat = power_spectrum(LineScan{heights, 1.0, false, {}}, options);
    const auto bent = power_spectrum(LineScan{heights + 1e3 + 5.0 * x - 7.0 * x.square(), 1.0, false, {}}, options);
    EXPECT_LT(((bent.density - flat.density) / flat.density).abs().maxCoeff(), 1e-9);
    const HeightMap map{heights.replicate(1, 8), {1.0, 0.2}, false, {}};
    const HeightMap tilted{(heights + 5.0 * x).replicate(1, 8), {1.0, 0.2}, false, {}};
    const SpectrumOptions tilt{.trend = Trend::tilt};
    EXPECT_LT(((power_spectrum(map, tilt).density - power_spectrum(tilted, tilt).density)).abs().maxCoeff(), 1e-12);
}

TEST(PowerSpectrum, IsUnaffectedByAnOffsetOfAMillionTimesTheRoughness) {
    const auto heights = random_heights(256);
    const auto base = power_spectrum(LineScan{heights, 1.0, false, {}});
    const auto offset = power_spectrum(LineScan{heights + 1e6, 1.0, false, {}});
    EXPECT_LT(((base.density - offset.density) / base.density.mean()).abs().maxCoeff(), 1e-8);
}

TEST(PowerSpectrum, GivesTheSameBytesForAnyNumberOfThreads) {
    const HeightMap map{random_map(100, 90), {1.0, 1.0}, false, {}};
    const auto one = power_spectrum(map, {.threads = {1}}), three = power_spectrum(map, {.threads = {3}});
    EXPECT_TRUE((one.density == three.density).all());
    EXPECT_TRUE((one.standard_error == three.standard_error).all());
}

TEST(PowerSpectrum, OfUndefinedHeightsIsRefused) {
    HeightMap map{random_map(10, 10), {1.0, 1.0}, false, {}};
    map.heights(3, 4) = undefined;
    for (const auto trend : {Trend::none, Trend::mean, Trend::tilt})
        EXPECT_THROW((void)power_spectrum(map, {.trend = trend}), UndefinedDataError);
    LineScan scan{random_heights(10), 1.0, false, {}};
    scan.heights[9] = undefined;
    EXPECT_THROW((void)power_spectrum(scan), UndefinedDataError);
    auto profile = tests::random_profile(10);
    profile.heights[5] = undefined;
    EXPECT_THROW((void)power_spectrum(profile), UndefinedDataError);
}

TEST(PowerSpectrum, OfAReentrantProfileIsRefused) {
    auto profile = tests::random_profile(10);
    std::swap(profile.positions[3], profile.positions[4]);
    EXPECT_THROW((void)power_spectrum(profile), InvalidArgument);
}

TEST(PowerSpectrum, OfOnePointOrNoSizeIsRefused) {
    EXPECT_THROW((void)power_spectrum(LineScan{random_heights(1), 1.0, false, {}}), InvalidArgument);
    EXPECT_THROW((void)power_spectrum(LineScan{random_heights(5), 0.0, false, {}}), InvalidArgument);
    EXPECT_THROW((void)power_spectrum(LineScan{random_heights(5), 1.0, false, {}}, {.window = Window::radial_hann}),
                 InvalidArgument);
}

TEST(PowerSpectrum, ReliableBandRunsFromTheSizeToNyquist) {
    const auto spectrum = power_spectrum(LineScan{random_heights(100), 2.0, false, {}});
    EXPECT_NEAR(spectrum.band.lower, pi, 1e-14);
    EXPECT_NEAR(spectrum.band.upper, 50.0 * pi, 1e-12);
    EXPECT_EQ(within_band(spectrum).density.size(), 50);
}

TEST(PowerSpectrum, WithinBandKeepsResolvedModes) {
    LineScan scan{random_heights(100), 2.0, false, {}};
    scan.metadata.instrument.resolution = 0.1;  // 2π/0.1 = mode 20
    EXPECT_EQ(within_band(power_spectrum(scan)).density.size(), 20);
}

TEST(PowerSpectrum, OfAContourReportsTheSizeOfItsCorrection) {
    const auto profile = tests::random_profile(400);
    const auto corrected = power_spectrum(profile),
               segments = power_spectrum(profile, {.contour = ContourTreatment::segments});
    ASSERT_EQ(corrected.alerts.size(), 1u);
    EXPECT_EQ(corrected.alerts[0].code, "CONTOUR_STEPS");
    EXPECT_TRUE(segments.alerts.empty());
    EXPECT_TRUE((corrected.density > segments.density).all());
    EXPECT_NEAR(corrected.density[0] / segments.density[0], 1.0, 1e-3);
    EXPECT_GT(corrected.density[190] / segments.density[190], 2.0);
}

TEST(PowerSpectrum, OfAMeasurementEqualsThatOfItsKind) {
    const LineScan scan{random_heights(20), 1.0, false, {}};
    EXPECT_TRUE((power_spectrum(topography::Measurement(scan)).density == power_spectrum(scan).density).all());
}

TEST(PowerSpectrum, OfAMapByBandsEqualsThatOfTheWholeMap) {
    HeightMap map{random_map(61, 45), {2.0, 3.0}, false, {}};
    map.heights += 1e3;
    for (const auto trend : {Trend::none, Trend::mean, Trend::tilt, Trend::parabola}) {
        const auto whole = power_spectrum(map, {.trend = trend});
        for (const Index lines : {1, 16, 17, 45, 90}) {
            const auto tiled = power_spectrum(topography::tiled(map), lines, {.trend = trend});
            EXPECT_LT(((tiled.density - whole.density) / whole.density).abs().maxCoeff(), 1e-9);
            EXPECT_LT(((tiled.standard_error - whole.standard_error) / whole.standard_error).abs().maxCoeff(), 1e-9);
            EXPECT_DOUBLE_EQ(tiled.band.upper, whole.band.upper);
            EXPECT_DOUBLE_EQ(tiled.pitch, whole.pitch);
            EXPECT_EQ(tiled.window, whole.window);
        }
    }
}

TEST(PowerSpectrum, OfAMapByBandsNamesTheLineWithAnUndefinedHeight) {
    HeightMap map{random_map(16, 45), {2.0, 3.0}, false, {}};
    map.heights(3, 40) = undefined;
    try {
        (void)power_spectrum(topography::tiled(map), 16, {});
        FAIL() << "an undefined height passed";
    } catch (const UndefinedDataError& error) {
        EXPECT_NE(std::string(error.what()).find("line 40"), std::string::npos) << error.what();
    }
}

}  // namespace power_spectrum_test
