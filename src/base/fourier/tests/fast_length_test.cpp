// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/fast_length.hpp"

#include <gtest/gtest.h>

namespace setae::fourier::fast_length_test {
namespace {

TEST(FastLength, IsTheSmallestProductOfTwosThreesAndFives) {
    EXPECT_EQ(fast_length(0), 1);
    EXPECT_EQ(fast_length(1), 1);
    EXPECT_EQ(fast_length(7), 8);
    EXPECT_EQ(fast_length(11), 12);
    EXPECT_EQ(fast_length(60), 60);
    EXPECT_EQ(fast_length(8191), 8192);
    EXPECT_EQ(fast_length(8193), 8640);
}

}  // namespace
}  // namespace setae::fourier::fast_length_test
