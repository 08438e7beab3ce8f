// SPDX-License-Identifier: GPL-3.0-or-later
// Standard errors from one measurement.
#include <gtest/gtest.h>

#include <cmath>

#include "pulls.hpp"
#include "setae/core/constants.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "surfaces/average_spectrum.hpp"

namespace setae::study::single_measurement_test {
namespace {

constexpr double rolloff = 2.0 * pi / 1e-6, shortest = 2.0 * pi / 50e-9;

double C1D(double q) { return q > shortest ? 0.0 : 1e-21 * std::pow(1.0 + q * q / (rolloff * rolloff), -1.3); }

/// ⟨h'²⟩ along x is (1/π) ∫ q² C1D dq, twice that the slope's of the isotropic surface.
double true_slope() {
    double sum = 0.0;
    constexpr int n = 100000;
    for (int i = 0; i < n; ++i) {
        const double q = shortest * (i + 0.5) / n;
        sum += q * q * C1D(q) * shortest / n;
    }
    return std::sqrt(2.0 * sum / pi);
}

SurfaceResult alone(const topography::Measurement& measurement, topography::Trend trend) {
    SurfaceResult surface;
    surface.name = "A";
    const SurfaceAnalysisOptions options;
    surface.measurements.push_back(analyse_measurement({measurement, trend, {}}, options, {1}));
    estimate_by_average(surface, options, {1});
    return surface;
}

/// A piece of a line four times as long.
topography::LineScan scan(std::uint64_t seed) {
    constexpr Index points = 1000;
    auto line = synthesis::random_line(C1D, {.points = 4 * points, .size = 4.0 * points * 10e-9},
                                       {.key = {seed, 0}, .threads = {1}});
    line.heights = Array1D(line.heights.head(points));
    line.size = points * 10e-9;
    line.periodic = false;
    return line;
}

// 60 scans: a share of 95 % scatters by 3 %. The slope rests on hundreds of modes, so that windows and trends do not
// matter.
TEST(SingleMeasurement, IntervalHasTheStatedCoverage) {
    int held = 0;
    setae::tests::Pulls pulls;
    constexpr int scans = 60;
    for (std::uint64_t seed = 0; seed < scans; ++seed) {
        const auto estimate =
            alone(scan(seed), topography::Trend::tilt).average.estimate([](const roughness::SpectralParameters& p) {
                return p.rms_slope;
            });
        EXPECT_EQ(estimate.method, "parametric noise on ln");
        const auto interval = interval_of(estimate);
        ASSERT_TRUE(interval);
        pulls.add(estimate, true_slope());
        held += interval->lower < true_slope() && true_slope() < interval->upper ? 1 : 0;
    }
    EXPECT_GE(held, 51);
    expect_honest(pulls);
}

// Lines of a map half a roll-off wavelength apart are correlated: 64 lines count as fewer.
TEST(SingleMeasurement, CountsIndependentLinesOfAMap) {
    const auto C_iso = [](double q) { return 1e-28 * std::pow(1.0 + q * q / (rolloff * rolloff), -1.8); };
    const auto surface = synthesis::random_surface(C_iso, {256, 256, 5e-6, 5e-6}, {.key = {3, 0}, .threads = {1}});
    const auto error_of = [&](Index lines) {
        topography::HeightMap map{
            surface.heights.leftCols(lines), {5e-6, 5e-6 * static_cast<double>(lines) / 256.0}, false, {}};
        return alone(map, topography::Trend::tilt)
            .average.estimate([](const roughness::SpectralParameters& p) { return p.rms_height; })
            .standard_error;
    };
    const double one = error_of(4), many = error_of(64);
    EXPECT_LT(many, one);
    EXPECT_GT(many, 0.4 * one);  // a quarter if all were independent
}

}  // namespace
}  // namespace setae::study::single_measurement_test
