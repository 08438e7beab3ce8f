// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/pinning_law.hpp"

#include <gtest/gtest.h>

namespace setae::hysteresis {
namespace {

TEST(PinningLaw, MeetsTheSimulatedFrontsAndFallsBetweenThem) {
    EXPECT_DOUBLE_EQ(pinning_coefficient(0.03).value, 2.7);
    EXPECT_DOUBLE_EQ(pinning_coefficient(0.1).value, 2.02);
    EXPECT_DOUBLE_EQ(pinning_coefficient(1e-9).value, 3.70);
    EXPECT_DOUBLE_EQ(pinning_coefficient(2.0).value, 1.54);
    double last = pinning_coefficient(0.002).value;
    for (double share = 0.003; share < 0.4; share *= 1.1) {
        EXPECT_LE(pinning_coefficient(share).value, last) << share;
        last = pinning_coefficient(share).value;
    }
    EXPECT_NEAR(pinning_uncertainty(0.1), 0.05 / 2.02, 1e-15);
}

TEST(PinningLaw, OfOneBandIsThatOfAllWaves) {
    EXPECT_DOUBLE_EQ(pinning_by_bands(2e-3, {1.0}, 40e-3), 2.0 * pinning_coefficient(0.05).value * 2e-3);
}

TEST(PinningLaw, BandsPinMoreThanAllWavesAtOnce) {
    const double at_once = pinning_by_bands(4e-3, {1.0}, 40e-3);
    const double by_two = pinning_by_bands(4e-3, {0.5, 0.5}, 40e-3);
    EXPECT_GT(by_two, at_once);
    EXPECT_DOUBLE_EQ(by_two, 2.0 * pinning_coefficient(0.05).value * 4e-3);
}

}  // namespace
}  // namespace setae::hysteresis
