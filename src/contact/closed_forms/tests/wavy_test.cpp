// SPDX-License-Identifier: GPL-3.0-or-later
#include "wavy.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace setae::contact::wavy::wavy_test {
namespace {

double energy_of(double alpha) { return 1.0 / (2.0 * pi * alpha * alpha); }

// Extremes of Johnson's curve as others have tabulated them.
TEST(WavySurface, ClosingPressureMatchesTabulatedValues) {
    const double alpha[] = {0.05, 0.10, 0.20, 0.30, 0.50, 0.57};
    const double pressure[] = {0.850778, 0.741415, 0.553652, 0.387728, 0.093899, -0.000162};
    for (int i = 0; i < 6; ++i) EXPECT_NEAR(closing_pressure(energy_of(alpha[i])), pressure[i], 1e-6);
    EXPECT_EQ(closing_pressure(std::numeric_limits<double>::infinity()), 1.0);
    EXPECT_NEAR(closing_pressure(1e12), 1.0, 1e-4);
}

TEST(WavySurface, ClosesSpontaneouslyBelowHalfTheWork) {
    EXPECT_NEAR(closing_pressure(closing_energy()), 0.0, 1e-12);
    EXPECT_NEAR(closing_energy(), 0.490, 2e-3);
}

}  // namespace
}  // namespace setae::contact::wavy::wavy_test
