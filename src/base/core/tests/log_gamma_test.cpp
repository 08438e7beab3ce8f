// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/log_gamma.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace setae {
namespace {

TEST(LogGamma, MatchesFactorialsAndHalfIntegers) {
    EXPECT_DOUBLE_EQ(log_gamma(5.0), std::log(24.0));
    EXPECT_NEAR(log_gamma(0.5), 0.5 * std::log(pi), 1e-15);
    EXPECT_NEAR(log_gamma(-0.5), std::log(2.0 * std::sqrt(pi)), 1e-15);
    EXPECT_EQ(log_gamma(1.0), 0.0);
}

TEST(LogGamma, IsInfiniteAtPoles) {
    for (const double pole : {0.0, -1.0, -7.0}) EXPECT_TRUE(std::isinf(log_gamma(pole))) << pole;
}

}  // namespace
}  // namespace setae
