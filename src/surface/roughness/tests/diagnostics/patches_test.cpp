// SPDX-License-Identifier: GPL-3.0-or-later
#include "diagnostics/patches.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::diagnostics::patches_test {
namespace {

using topography::Mask;

Mask random_mask(Index nx, Index ny, double share, std::uint64_t seed) {
    std::mt19937_64 source(seed);
    return Mask::NullaryExpr(nx, ny, [&](Index, Index) {
        return static_cast<std::uint8_t>(static_cast<double>(source()) / 0x1p64 < share);
    });
}

/// Flood fill with a list, in storage order: a slow, simple reference.
PatchNumbers flooded(const Mask& mask, Neighbours neighbours, bool periodic) {
    const Index nx = mask.rows(), ny = mask.cols();
    PatchNumbers numbers = PatchNumbers::Zero(nx, ny);
    std::int32_t count = 0;
    for (Index i = 0; i < nx; ++i)
        for (Index j = 0; j < ny; ++j) {
            if (mask(i, j) == 0 || numbers(i, j) != 0) continue;
            std::vector<std::array<Index, 2>> open{{i, j}};
            numbers(i, j) = ++count;
            while (!open.empty()) {
                const auto [k, l] = open.back();
                open.pop_back();
                for (Index di = -1; di <= 1; ++di)
                    for (Index dj = -1; dj <= 1; ++dj) {
                        if (neighbours == Neighbours::edges && di != 0 && dj != 0) continue;
                        Index m = k + di, n = l + dj;
                        if (periodic) {
                            m = (m + nx) % nx;
                            n = (n + ny) % ny;
                        }
                        if (m < 0 || m >= nx || n < 0 || n >= ny || mask(m, n) == 0 || numbers(m, n) != 0) continue;
                        numbers(m, n) = count;
                        open.push_back({m, n});
                    }
            }
        }
    return numbers;
}

TEST(Patches, EqualAFloodFillIncludingTheirNumbers) {
    std::uint64_t seed = 0;
    for (const double share : {0.1, 0.4, 0.5, 0.6, 0.9})
        for (const auto& [nx, ny] :
             std::vector<std::array<Index, 2>>{{1, 1}, {1, 17}, {23, 1}, {2, 2}, {13, 29}, {31, 8}, {64, 64}})
            for (const auto neighbours : {Neighbours::edges, Neighbours::edges_and_corners})
                for (const bool periodic : {false, true}) {
                    const auto mask = random_mask(nx, ny, share, ++seed);
                    const auto found = patches(mask, neighbours, periodic);
                    const auto expected = flooded(mask, neighbours, periodic);
                    ASSERT_TRUE((found.numbers == expected).all())
                        << nx << " x " << ny << ", share " << share << ", periodic " << periodic;
                    EXPECT_EQ(found.count, expected.maxCoeff());
                }
}

TEST(Patches, OfACheckerboardDependOnDiagonalNeighbours) {
    const auto mask =
        Mask::NullaryExpr(10, 12, [](Index i, Index j) { return static_cast<std::uint8_t>((i + j) % 2); }).eval();
    EXPECT_EQ(patches(mask, Neighbours::edges_and_corners).count, 1);
    EXPECT_EQ(patches(mask, Neighbours::edges).count, 60);
    EXPECT_EQ(patches(mask, Neighbours::edges, true).count, 60);
}

TEST(Patches, OfASpiralAreOne) {
    // joined only at its end: the case that makes naive labelling slow
    const Index n = 201;
    Mask mask = Mask::Zero(n, n);
    for (Index ring = 0; ring < n / 2; ring += 2) {
        for (Index k = ring; k < n - ring; ++k) mask(ring, k) = mask(k, n - 1 - ring) = mask(n - 1 - ring, k) = 1;
        for (Index k = ring + 2; k < n - ring; ++k) mask(k, ring) = 1;
        if (ring + 2 < n / 2) mask(ring + 2, ring + 1) = 1;
    }
    EXPECT_EQ(patches(mask, Neighbours::edges).count, 1);
}

TEST(Patches, OfAnEmptyMaskAreNone) {
    const auto found = patches(Mask::Zero(5, 7));
    EXPECT_EQ(found.count, 0);
}

TEST(Patches, CountAnyValueButZeroAsChosen) {
    Mask mask = Mask::Zero(3, 3);
    mask(1, 1) = 255;
    EXPECT_EQ(patches(mask).numbers(1, 1), 1);
}

TEST(Patches, RefuseAMaskWithoutPoints) { EXPECT_THROW((void)patches(Mask(0, 5)), InvalidArgument); }

}  // namespace
}  // namespace setae::diagnostics::patches_test
