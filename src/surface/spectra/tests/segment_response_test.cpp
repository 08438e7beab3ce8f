// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/segment_response.hpp"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/polyline.hpp"

namespace segment_response_test {

using namespace setae;
using namespace setae::spectra;

TEST(SegmentResponse, OfEqualStepsIsSincToTheFourth) {
    const SegmentResponse response(Array1D::LinSpaced(101, 3.0, 53.0));
    EXPECT_NEAR(response.band_end(), pi / 0.5, 1e-12);
    const Array1D q = Array1D::LinSpaced(50, 0.01, pi / 0.5);
    const Array1D theta = 0.25 * q;
    for (const double exponent : {0.0, 2.6, 4.9})
        EXPECT_LT((response.at(q, exponent) - (theta.sin() / theta).pow(4)).abs().maxCoeff(), 1e-12);
}

TEST(SegmentResponse, TendsToOneForLongWaves) {
    const SegmentResponse response(tests::random_profile(300).positions);
    EXPECT_NEAR(response.at(Array1D::Constant(1, 1e-3), 2.6)[0], 1.0, 1e-6);
}

Array1D positions(Index n, const std::function<double(std::mt19937_64&)>& step, unsigned seed) {
    std::mt19937_64 engine(seed);
    Array1D x(n);
    x[0] = 0.0;
    for (Index k = 1; k < n; ++k) x[k] = x[k - 1] + step(engine);
    return x;
}

/// Mean over phases of the spectrum of segments between the points for waves of spectrum |p|^−exponent up to the end of
/// the band, over the spectrum itself: prediction of SegmentResponse, by sampling every wave.
Array1D sampled_response(const Array1D& x, const Array1D& q, double exponent) {
    const double length = x[x.size() - 1], end = pi * static_cast<double>(x.size() - 1) / length;
    const double spacing = 2.0 * pi / (3.0 * length);
    Array1D power = Array1D::Zero(q.size());
    for (double p = 0.5 * spacing; p < end; p += spacing) {
        const Array1D wave =
            polyline_power_spectrum({x, (p * x).cos(), {}}, q) + polyline_power_spectrum({x, (p * x).sin(), {}}, q);
        power += std::pow(p, -exponent) * wave * spacing / pi;
    }
    return power * q.pow(exponent);
}

void expect_response(const std::function<double(std::mt19937_64&)>& step, double exponent, double tolerance) {
    Array1D predicted, sampled;
    constexpr int realisations = 8;
    for (unsigned seed = 0; seed < realisations; ++seed) {
        const auto x = positions(121, step, seed);
        const SegmentResponse response(x);
        const Array1D q = Array1D{{0.3, 0.5, 0.7, 0.8, 0.9}} * response.band_end();
        const Array1D one = response.at(q, exponent), other = sampled_response(x, q, exponent);
        predicted = seed == 0 ? one : Array1D(predicted + one);
        sampled = seed == 0 ? other : Array1D(sampled + other);
    }
    EXPECT_LT((predicted / sampled - 1.0).abs().maxCoeff(), tolerance) << predicted.transpose() / realisations << "\n"
                                                                       << sampled.transpose() / realisations;
}

TEST(SegmentResponse, MatchesWavesSampledAtUniformlyRandomSteps) {
    expect_response([](auto& engine) { return std::uniform_real_distribution<double>(0.5, 1.5)(engine); }, 2.6, 0.05);
}

TEST(SegmentResponse, MatchesWavesSampledAtExponentiallyRandomSteps) {
    expect_response([](auto& engine) { return std::exponential_distribution<double>(1.0)(engine); }, 2.6, 0.08);
}

TEST(SegmentResponse, RecoversTheExponentOfAPowerLaw) {
    const SegmentResponse response(tests::random_profile(300, 1.0, 0.5).positions);
    const Array1D q = Array1D::LinSpaced(150, 0.02, 1.0) * response.band_end();
    for (const double exponent : {0.0, 1.5, 2.8})
        EXPECT_NEAR(response.fitted_exponent(q, q.pow(-exponent) * response.at(q, exponent)), exponent, 1e-3);
}

TEST(SegmentResponse, DefaultsToASteepExponentWithoutData) {
    const SegmentResponse response(Array1D::LinSpaced(3, 0.0, 1.0));
    EXPECT_EQ(response.fitted_exponent(Array1D::Ones(1), Array1D::Ones(1)), 2.0);
}

TEST(SegmentResponse, RefusesExponentsWithUnboundedScatter) {
    const SegmentResponse response(Array1D::LinSpaced(3, 0.0, 1.0));
    EXPECT_THROW((void)response.at(Array1D::Ones(1), 5.0), InvalidArgument);
    EXPECT_THROW((void)response.at(Array1D::Ones(1), -0.1), InvalidArgument);
}

}  // namespace segment_response_test
