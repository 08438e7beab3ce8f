// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/crack_speed.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::crack_speed::crack_speed_test {
namespace {

constexpr Law rubber{.threshold = 0.05, .reference_speed = 2e-7, .exponent = 0.6};

TEST(CrackSpeed, DoublesTheEnergyReleaseRateAtTheReferenceSpeed) {
    EXPECT_DOUBLE_EQ(energy_release_rate(0.0, rubber), 0.05);
    EXPECT_DOUBLE_EQ(energy_release_rate(2e-7, rubber), 0.1);
    // (v/v0)^0.6 = 8 at v = 32 v0
    EXPECT_NEAR(energy_release_rate(32.0 * 2e-7, rubber), 0.05 * 9.0, 1e-15);
}

TEST(CrackSpeed, InvertsEnergyReleaseRate) {
    for (const double v : {1e-9, 1e-7, 1e-6, 1e-3})
        EXPECT_NEAR(speed(energy_release_rate(v, rubber), rubber) / v, 1.0, 1e-10) << v;
    EXPECT_EQ(speed(0.05, rubber), 0.0);
}

TEST(CrackSpeed, IsUndefinedBelowTheThreshold) {
    EXPECT_TRUE(std::isnan(speed(0.0499, rubber)));
    EXPECT_TRUE(std::isnan(speed(undefined, rubber)));
}

TEST(CrackSpeed, DerivativeIsTheSlope) {
    for (const double v : {1e-8, 1e-6, 1e-4}) {
        const double step = 1e-4 * v;  // error O(step²/v²) = 1e-8
        const double slope =
            (energy_release_rate(v + step, rubber) - energy_release_rate(v - step, rubber)) / (2.0 * step);
        EXPECT_NEAR(energy_release_rate_derivative(v, rubber) / slope, 1.0, 1e-7);
    }
    EXPECT_TRUE(std::isinf(energy_release_rate_derivative(0.0, rubber)));
    EXPECT_DOUBLE_EQ(energy_release_rate_derivative(0.0, {.threshold = 3.0, .reference_speed = 2.0, .exponent = 1.0}),
                     1.5);
}

TEST(CrackSpeed, OfSeriesEqualsThatOfEachValue) {
    const Array1D speeds = Array1D::LinSpaced(4, 0.0, 1e-6);
    const Array1D rates = energy_release_rate(speeds, rubber);
    for (Index i = 0; i < 4; ++i) EXPECT_EQ(rates[i], energy_release_rate(speeds[i], rubber));
    EXPECT_EQ(speed(rates, rubber)[2], speed(rates[2], rubber));
}

TEST(CrackSpeed, RefusesValuesOutsideItsDomain) {
    EXPECT_THROW((void)energy_release_rate(-1e-9, rubber), InvalidArgument);
    EXPECT_THROW((void)energy_release_rate(undefined, rubber), InvalidArgument);
    EXPECT_THROW((void)energy_release_rate_derivative(-1e-9, rubber), InvalidArgument);
    for (const Law& bad : {Law{.threshold = 0.0, .reference_speed = 1.0, .exponent = 1.0},
                           Law{.threshold = 1.0, .reference_speed = -1.0, .exponent = 1.0},
                           Law{.threshold = 1.0, .reference_speed = 1.0, .exponent = 0.0},
                           Law{.threshold = 1.0, .reference_speed = 1.0, .exponent = undefined}}) {
        EXPECT_THROW((void)energy_release_rate(1.0, bad), InvalidArgument);
        EXPECT_THROW((void)speed(1.0, bad), InvalidArgument);
    }
}

}  // namespace
}  // namespace setae::contact::crack_speed::crack_speed_test
