// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace true_area_test {

using namespace setae;

/// Largest relative deviation of the triangulated area from (9), over slopes from 0.01 to 10.
double worst_deviation(Index points, double hurst, std::initializer_list<double> slopes) {
    // 16 roll-off wavelengths in the map, cutoff at four pixels, in units of the pixel
    const double extent = static_cast<double>(points);
    const spectra::SelfAffine model{1.0, 2.0 * pi * 16.0 / extent, hurst, 0.5 * pi};
    auto map = synthesis::random_surface(spectra::density(model), {points, points, extent, extent}, {.key = {1}});
    double slope_now = roughness::triangulated_area(map).rms_slope, worst = 0.0;
    for (const double slope : slopes) {
        map.heights *= slope / slope_now;
        slope_now = slope;
        const auto area = roughness::triangulated_area(map);
        EXPECT_NEAR(area.rms_slope / slope, 1.0, 1e-9);
        const double ratio = area.area_ratio / roughness::gaussian_area_ratio(area.rms_slope);
        testing::Test::RecordProperty("deviation at slope " + std::to_string(slope), std::to_string(ratio - 1.0));
        worst = std::max(worst, std::abs(ratio - 1.0));
    }
    return worst;
}

class TrueAreaOfSelfAffineMaps : public testing::TestWithParam<double> {};

TEST_P(TrueAreaOfSelfAffineMaps, MatchesGaussianSlopes) {
    EXPECT_LT(worst_deviation(1024, GetParam(), {0.01, 0.3, 1.0, 3.0, 10.0}), 0.01);
}

TEST_P(TrueAreaOfSelfAffineMaps, Of4096PointsMatchesGaussianSlopes) {
    EXPECT_LT(worst_deviation(4096, GetParam(), {0.01, 1.0, 10.0}), 0.01);
}

INSTANTIATE_TEST_SUITE_P(HurstExponents, TrueAreaOfSelfAffineMaps, testing::Values(0.3, 0.8));

TEST(TrueAreaOfFlatteningMaps, OfSmallSlopesIsOnePlusHalfTheSquare) {
    // the excess itself: (A − 1)/(h'²/2) = 1 − ½ h'² + … for Gaussian slopes, that is 5e-5 below 1
    const spectra::SelfAffine model{1.0, 2.0 * pi / 64.0, 0.8, 0.5 * pi};
    auto map = synthesis::random_surface(spectra::density(model), {512, 512, 512.0, 512.0}, {.key = {2}});
    map.heights *= 0.01 / roughness::triangulated_area(map).rms_slope;
    EXPECT_NEAR((roughness::triangulated_area(map).area_ratio - 1.0) / (0.5e-4), 1.0, 2e-4);
}

}  // namespace true_area_test
