// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/polyline.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "polyline_reference.hpp"
#include "samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/topography/detrend.hpp"

namespace polyline_test {

using namespace setae;
using namespace setae::spectra;
using tests::log_spaced;
using tests::random_profile;
using topography::Profile;

double sinc(double x) { return std::sin(x) / x; }

TEST(PolylinePowerSpectrum, OfARectangleIsSincSquared) {
    const Profile rectangle{Array1D{{0.0, 0.7, 2.0}}, Array1D::Constant(3, 3.0), {}};
    const auto q = log_spaced(200, 1e-3, 1e4);
    const auto spectrum = polyline_power_spectrum(rectangle, q, Window::none);
    for (Index j = 0; j < q.size(); ++j)
        EXPECT_NEAR(spectrum[j], 18.0 * std::pow(sinc(q[j]), 2), 1e-12 * 18.0 * std::min(1.0, 1.0 / (q[j] * q[j])))
            << q[j];
}

TEST(PolylinePowerSpectrum, OfATriangleIsSincToTheFourth) {
    const Profile triangle{Array1D{{5.0, 6.0, 7.0}}, Array1D{{0.0, 1.0, 0.0}}, {}};
    const auto q = log_spaced(200, 1e-3, 1e4);
    const auto spectrum = polyline_power_spectrum(triangle, q, Window::none);
    for (Index j = 0; j < q.size(); ++j)
        EXPECT_NEAR(spectrum[j], 0.5 * std::pow(sinc(0.5 * q[j]), 4), 1e-12 * std::min(1.0, std::pow(q[j], -4)))
            << q[j];
}

TEST(PolylinePowerSpectrum, OfASampledSineIsThatOfTheSineTimesSincToTheFourth) {
    const Array1D x = Array1D::LinSpaced(401, 0.0, 10.0);
    const Profile sine{x, (2.0 * pi * x).cos(), {}};
    const Array1D q = Array1D::Constant(1, 2.0 * pi);
    const double kept = std::pow(sinc(pi * 0.025), 4);
    EXPECT_NEAR(polyline_power_spectrum(sine, q, Window::none)[0], 2.5 * kept, 1e-12);
    EXPECT_NEAR(polyline_power_spectrum(sine, q, Window::hann)[0], 2.5 * kept * 2.0 / 3.0, 1e-12);
}

/// Largest deviation from the sum over segments, over the mean level of the nearest twenty wavevectors.
double largest_deviation(const Profile& profile, const Array1D& q, Window window) {
    const auto spectrum = polyline_power_spectrum(profile, q, window);
    const Array1D expected =
        q.unaryExpr([&](double value) { return tests::spectrum_by_segments(profile, value, window); });
    double worst = 0.0;
    for (Index j = 0; j < q.size(); ++j) {
        const Index first = std::clamp<Index>(j - 10, 0, q.size() - 20);
        worst = std::max(worst, std::abs(spectrum[j] - expected[j]) / expected.segment(first, 20).mean());
    }
    return worst;
}

class PolylineWindows : public testing::TestWithParam<Window> {};

TEST_P(PolylineWindows, MatchTheSumOverSegmentsOverFiveDecades) {
    const auto profile = topography::detrended(random_profile(1000), topography::Trend::mean);
    EXPECT_LT(largest_deviation(profile, log_spaced(60, 2.0 * pi / 1000.0, 2.0 * pi * 50.0), GetParam()), 1e-10);
}

TEST_P(PolylineWindows, MatchTheSumOverSegmentsForSmoothHeights) {
    Profile profile = random_profile(1000);
    profile.heights =
        (0.01 * profile.positions).sin() + 1e-2 * (0.5 * profile.positions).cos() + 1e-4 * profile.heights;
    EXPECT_LT(largest_deviation(topography::detrended(profile, topography::Trend::mean),
                                log_spaced(60, 2.0 * pi / 1000.0, 10.0), GetParam()),
              1e-10);
}

TEST_P(PolylineWindows, MatchTheSumOverSegmentsForAFewPoints) {
    EXPECT_LT(largest_deviation(random_profile(5, 1e-9), log_spaced(40, 1e6, 1e11), GetParam()), 1e-10);
}

INSTANTIATE_TEST_SUITE_P(All, PolylineWindows, testing::Values(Window::none, Window::hann, Window::blackman_harris),
                         [](const auto& test) { return name(test.param); });

TEST(PolylinePowerSpectrum, BothFormulasAgreeWhereTheyMeet) {
    // a dense sweep crosses q*, at any position
    const auto profile = topography::detrended(random_profile(300), topography::Trend::mean);
    EXPECT_LT(largest_deviation(profile, Array1D::LinSpaced(200, 0.02, 1.0), Window::hann), 1e-10);
}

TEST(PolylinePowerSpectrum, AcceptsAnyOrderAndSignOfWavevectors) {
    const auto profile = random_profile(50);
    const Array1D q{{3.0, -0.1, 0.0, 0.1, -3.0}};
    const auto spectrum = polyline_power_spectrum(profile, q);
    EXPECT_NEAR(spectrum[0] / spectrum[4], 1.0, 1e-12);
    EXPECT_NEAR(spectrum[1] / spectrum[3], 1.0, 1e-12);
    EXPECT_NEAR(spectrum[2], tests::spectrum_by_segments(profile, 0.0, Window::hann), 1e-12 * spectrum[2]);
}

TEST(PolylinePowerSpectrum, GivesTheSameBytesForAnyNumberOfThreads) {
    const auto profile = random_profile(2000);
    const auto q = log_spaced(1000, 1e-3, 10.0);
    EXPECT_TRUE((polyline_power_spectrum(profile, q, Window::hann, {1}) ==
                 polyline_power_spectrum(profile, q, Window::hann, {3}))
                    .all());
}

TEST(PolylinePowerSpectrum, RefusesReentrantProfilesAndRadialWindows) {
    auto profile = random_profile(6);
    const Array1D q = Array1D::Ones(1);
    EXPECT_THROW((void)polyline_power_spectrum(profile, q, Window::radial_hann), InvalidArgument);
    EXPECT_THROW((void)polyline_power_spectrum(profile, Array1D::Constant(1, undefined)), InvalidArgument);
    profile.positions[2] = profile.positions[1];
    EXPECT_THROW((void)polyline_power_spectrum(profile, q), InvalidArgument);
}

}  // namespace polyline_test
