// SPDX-License-Identifier: GPL-3.0-or-later
// The rectified normal distribution compared with closed values and with drawn numbers.
#include "setae/core/rectified.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace setae::rectified_test {
namespace {

TEST(Rectified, HasTheStandardDeviationOfRandomDraws) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    constexpr int count = 400'000;
    for (const double z : {-2.0, -1.1, -0.3, 0.0, 0.7, 2.5}) {
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < count; ++i) {
            const double x = std::max(0.0, z + normal(random));
            sum += x;
            squares += x * x;
        }
        const double mean = sum / count;
        EXPECT_NEAR(rectified_share(3.0 * z, 3.0), std::sqrt(squares / count - mean * mean), 0.004) << z;
    }
}

TEST(Rectified, MatchesClosedForms) {
    EXPECT_NEAR(rectified_share(-1.1, 1.0), 0.2356, 1e-4);
    EXPECT_NEAR(rectified_share(0.0, 1.0), std::sqrt(0.5 - 0.5 / std::acos(-1.0)), 1e-14);
    EXPECT_DOUBLE_EQ(rectified_share(20.0, 1.0), 1.0);
    EXPECT_DOUBLE_EQ(rectified_share(-20.0, 1.0), 0.0);
    EXPECT_DOUBLE_EQ(rectified_share(1.0, 0.0), 1.0);
    EXPECT_DOUBLE_EQ(rectified_share(-1.0, 0.0), 0.0);
}

TEST(Rectified, FloorsValueAndInterval) {
    const auto found = rectified({.value = -92.0, .standard_error = 85.0});
    EXPECT_DOUBLE_EQ(found.value, 0.0);
    EXPECT_NEAR(found.standard_error, 85.0 * rectified_share(-92.0, 85.0), 1e-12);
    ASSERT_TRUE(found.interval);
    EXPECT_DOUBLE_EQ(found.interval->lower, 0.0);
    EXPECT_NEAR(found.interval->upper, -92.0 + 1.959964 * 85.0, 1e-3);
}

// 95 % intervals of max(0, X) cover it as often as those of X cover X, for any position of the floor.
TEST(Rectified, IntervalsCoverTheRectifiedValue) {
    std::mt19937_64 random(6);
    std::normal_distribution<double> normal;
    constexpr int count = 20'000;
    for (const double truth : {-1.5, -0.5, 0.5, 2.0}) {
        int held = 0;
        for (int i = 0; i < count; ++i) {
            const auto found = rectified({.value = truth + normal(random), .standard_error = 1.0});
            const double x = std::max(0.0, truth);
            held += found.interval->lower <= x && x <= found.interval->upper ? 1 : 0;
        }
        EXPECT_GE(held, 0.945 * count) << truth;
        EXPECT_LE(held, (truth > 0.0 ? 0.955 : 1.0) * count) << truth;
    }
}

}  // namespace
}  // namespace setae::rectified_test
