// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/numerics/random_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Random123/philox.h>
#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace random_numbers_test {

using namespace setae;
using namespace setae::numerics;

TEST(RandomBits, MatchThePublishedPhiloxVectors) {
    // Random123's kat_vectors: philox4x32 10, counter and key zero
    EXPECT_EQ(random_bits({0, 0}, 0), 0xe169c58d6627e8d5U);
    EXPECT_EQ(random_bits({0, 0}, 1), 0x9b00dbd8bc57ac4cU);
}

TEST(RandomBits, HaveTheSeedAsKeyAndTheStreamInTheCounter) {
    const RandomKey key{0x299f31d0a4093822U, 0x0370734413198a2eU};
    const auto bits =
        r123::Philox4x32{}({{0x243f6a88U, 0x05a308d3U, 0x13198a2eU, 0x03707344U}}, {{0xa4093822U, 0x299f31d0U}});
    const std::uint64_t block = 0x05a308d3243f6a88U;
    EXPECT_EQ(random_bits(key, 2 * block), static_cast<std::uint64_t>(bits[1]) << 32 | bits[0]);
    EXPECT_EQ(random_bits(key, 2 * block + 1), static_cast<std::uint64_t>(bits[3]) << 32 | bits[2]);
}

TEST(NormalNumbers, AreBoxMullerTransformsOfTheBits) {
    // the library's logarithm and polar are an independent evaluation; angle (π/2)(k + f) from the top two bits and the
    // rest
    const RandomKey key{7, 3};
    for (std::uint64_t m = 0; m < 2000; ++m) {
        const std::uint64_t first = random_bits(key, 2 * m), second = random_bits(key, 2 * m + 1);
        const double u = (static_cast<double>(first >> 12) + 0.5) * 0x1p-52;
        const double f = (static_cast<double>(second << 2 >> 12) + 0.5) * 0x1p-52 - 0.5;
        const double radius = std::sqrt(-2.0 * std::log(u)), angle = 0.5 * pi * (static_cast<double>(second >> 62) + f);
        EXPECT_NEAR(normal_number(key, 2 * m), radius * std::cos(angle), 1e-14 * radius);
        EXPECT_NEAR(normal_number(key, 2 * m + 1), radius * std::sin(angle), 1e-14 * radius);
    }
}

TEST(NormalNumbers, AreEqualOneByOneAndInBlocks) {
    const RandomKey key{1, 2};
    for (const std::uint64_t first : {0U, 1U, 6U, 257U}) {
        const auto normal = normal_numbers(key, first, 301);
        for (Index i = 0; i < 301; ++i) EXPECT_EQ(normal[i], normal_number(key, first + static_cast<std::uint64_t>(i)));
    }
    EXPECT_EQ(normal_numbers(key, 5, 0).size(), 0);
}

TEST(NormalNumbers, HaveTheMomentsOfTheNormalDistribution) {
    constexpr Index n = 400000;
    const auto z = normal_numbers({42, 0}, 0, n);
    const double root = std::sqrt(static_cast<double>(n));
    // standard errors of the moments: 1, √2, √15, √96 over √n; four of them
    EXPECT_LT(std::abs(z.mean()), 4.0 / root);
    EXPECT_LT(std::abs(z.square().mean() - 1.0), 4.0 * std::sqrt(2.0) / root);
    EXPECT_LT(std::abs(z.cube().mean()), 4.0 * std::sqrt(15.0) / root);
    EXPECT_LT(std::abs(z.pow(4).mean() - 3.0), 4.0 * std::sqrt(96.0) / root);
    for (const Index lag : {1, 2, 7})
        EXPECT_LT(std::abs((z.head(n - lag) * z.tail(n - lag)).mean()), 4.0 / root) << lag;
}

TEST(NormalNumbers, FollowTheNormalDistributionFunction) {
    constexpr Index n = 200000;
    const auto z = normal_numbers({9, 1}, 0, n);
    std::vector<double> sorted(z.begin(), z.end());
    std::sort(sorted.begin(), sorted.end());
    double distance = 0.0;
    for (Index i = 0; i < n; ++i) {
        const double expected = 0.5 * std::erfc(-sorted[static_cast<std::size_t>(i)] / std::sqrt(2.0));
        distance = std::max(distance, std::abs(expected - (static_cast<double>(i) + 0.5) / static_cast<double>(n)));
    }
    EXPECT_LT(distance * std::sqrt(static_cast<double>(n)), 1.95);  // Kolmogorov: exceeded once in a thousand
}

TEST(UniformNumbers, LieStrictlyInsideAndCoverTheInterval) {
    constexpr Index n = 200000;
    Array1D u(n);
    for (Index i = 0; i < n; ++i) u[i] = uniform_number({3, 3}, static_cast<std::uint64_t>(i));
    EXPECT_GT(u.minCoeff(), 0.0);
    EXPECT_LT(u.maxCoeff(), 1.0);
    EXPECT_LT(std::abs(u.mean() - 0.5), 4.0 / std::sqrt(12.0 * n));
    EXPECT_LT(std::abs((u - 0.5).square().mean() - 1.0 / 12.0), 4.0 / std::sqrt(180.0 * n));
}

TEST(Substreams, AreUncorrelatedWithEachOtherAndTheirParent) {
    constexpr Index n = 100000;
    const RandomKey parent{5, 0};
    const RandomKey children[] = {
        parent, substream(parent, 0), substream(parent, 1), substream(substream(parent, 0), 0), {6, 0}};
    for (const auto& a : children)
        for (const auto& b : children) {
            if (&a == &b) continue;
            EXPECT_FALSE(a == b);
            EXPECT_LT(std::abs((normal_numbers(a, 0, n) * normal_numbers(b, 0, n)).mean()),
                      4.0 / std::sqrt(static_cast<double>(n)));
        }
}

}  // namespace random_numbers_test
