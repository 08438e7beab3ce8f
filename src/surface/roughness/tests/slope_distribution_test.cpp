// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/slope_distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::roughness::slope_distribution_test {
namespace {

bool has(const SlopeDistribution& d, const std::string& code) {
    return std::any_of(d.alerts.begin(), d.alerts.end(), [&](const Alert& a) { return a.code == code; });
}

/// A random walk: its slopes are the independent numbers drawn.
template <class Distribution>
topography::LineScan walk(Distribution distribution, Index n, unsigned seed) {
    std::mt19937 random(seed);
    topography::LineScan scan{Array1D::Zero(n), static_cast<double>(n)};
    for (Index i = 1; i < n; ++i) scan.heights[i] = scan.heights[i - 1] + distribution(random);
    return scan;
}

TEST(SlopeDistribution, OfGaussianSlopesGivesNoWarning) {
    const auto d = slope_distribution(walk(std::normal_distribution<double>(0.0, 0.3), 5000, 3));
    EXPECT_NEAR(d.directions.front().rms, 0.3, 0.01);
    EXPECT_NEAR(d.directions.front().excess_kurtosis, 0.0, 3.0 * d.directions.front().excess_kurtosis_standard_error);
    EXPECT_FALSE(has(d, "NON_GAUSSIAN"));
    EXPECT_TRUE(has(d, "ONE_DIRECTION"));
    EXPECT_NEAR(d.density.sum() * (d.slope[1] - d.slope[0]), 1.0, 1e-3);
}

TEST(SlopeDistribution, HasFewFalseWarningsAndFindsRealDeviations) {
    int false_alarms = 0, found = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        false_alarms +=
            has(slope_distribution(walk(std::normal_distribution<double>(0.0, 1.0), 2000, seed)), "NON_GAUSSIAN") ? 1
                                                                                                                  : 0;
        // exponential slopes: skewness 2, excess kurtosis 6
        found += has(slope_distribution(walk(std::exponential_distribution<double>(1.0), 2000, seed)), "NON_GAUSSIAN")
                     ? 1
                     : 0;
    }
    EXPECT_LE(false_alarms, 5);
    EXPECT_GE(found, 95);
}

TEST(SlopeDistribution, OfAPolylineIgnoresCollinearPoints) {
    const auto scan = walk(std::normal_distribution<double>(0.0, 1.0), 200, 5);
    topography::Profile coarse{Array1D::LinSpaced(200, 0.0, 199.0), scan.heights};
    topography::Profile fine{Array1D::LinSpaced(399, 0.0, 199.0), Array1D(399)};
    for (Index i = 0; i < 399; ++i) fine.heights[i] = 0.5 * (scan.heights[i / 2] + scan.heights[(i + 1) / 2]);
    EXPECT_NEAR(slope_distribution(fine).directions[0].rms, slope_distribution(coarse).directions[0].rms, 1e-12);
}

TEST(SlopeDistribution, FindsThatAGratingIsAnisotropic) {
    topography::HeightMap map{Array2D(64, 64), {1.0, 1.0}, true};
    std::mt19937 random(1);
    std::normal_distribution<double> noise(0.0, 1e-3);
    for (Index i = 0; i < 64; ++i)
        for (Index j = 0; j < 64; ++j)
            map.heights(i, j) = 0.1 * std::cos(2.0 * pi * 4.0 * static_cast<double>(i) / 64.0) + noise(random);
    const auto d = slope_distribution(map);
    EXPECT_TRUE(has(d, "ANISOTROPIC"));
    EXPECT_GT(d.isotropy_ratio, 5.0);
}

TEST(SlopeDistribution, RefusesTooFewSlopes) {
    EXPECT_THROW((void)slope_distribution(topography::LineScan{Array1D::Zero(10), 1.0}), UndefinedDataError);
}

}  // namespace
}  // namespace setae::roughness::slope_distribution_test
