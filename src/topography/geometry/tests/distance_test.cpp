// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/geometry/distance.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::geometry {
namespace {

using topography::Mask;

Mask random_mask(Index nx, Index ny, double share, std::uint64_t seed) {
    std::mt19937_64 source(seed);
    return Mask::NullaryExpr(nx, ny, [&](Index, Index) {
        return static_cast<std::uint8_t>(static_cast<double>(source()) / 0x1p64 < share);
    });
}

double separation(Index a, Index b, Index n, bool periodic) {
    const Index d = std::abs(a - b);
    return static_cast<double>(periodic ? std::min(d, n - d) : d);
}

double distance_between(Index i, Index j, Index k, Index l, const Mask& mask, const PointGrid& grid) {
    return std::hypot(separation(i, k, mask.rows(), grid.periodic) * grid.pixel_size[0],
                      separation(j, l, mask.cols(), grid.periodic) * grid.pixel_size[1]);
}

double nearest(const Mask& mask, Index i, Index j, const PointGrid& grid) {
    double best = std::numeric_limits<double>::infinity();
    for (Index k = 0; k < mask.rows(); ++k)
        for (Index l = 0; l < mask.cols(); ++l)
            if (mask(k, l) != 0) best = std::min(best, distance_between(i, j, k, l, mask, grid));
    return best;
}

TEST(DistanceMap, AgreesWithAllPairsOfPoints) {
    std::uint64_t seed = 0;
    for (const auto& [nx, ny] : {std::array<Index, 2>{1, 1}, {1, 13}, {14, 1}, {2, 3}, {17, 20}, {23, 12}})
        for (const double share : {0.02, 0.1, 0.5})
            for (const bool periodic : {false, true})
                for (const auto& pixel : {std::array<double, 2>{1.0, 1.0}, {1e-9, 3.7e-9}, {2.0, 0.1}}) {
                    const PointGrid grid{pixel, periodic};
                    const auto mask = random_mask(nx, ny, share, ++seed);
                    const auto map = distance_map(mask, grid);
                    for (Index i = 0; i < nx; ++i)
                        for (Index j = 0; j < ny; ++j) {
                            const double expected = nearest(mask, i, j, grid);
                            if (std::isinf(expected)) EXPECT_TRUE(std::isinf(map(i, j)));
                            else
                                ASSERT_NEAR(map(i, j), expected, 1e-14 * expected)
                                    << nx << " x " << ny << " at " << i << ", " << j;
                        }
                }
}

TEST(DistanceMap, FromOnePointIsACone) {
    Mask mask = Mask::Zero(60, 70);
    mask(20, 30) = 1;
    const auto map = distance_map(mask, {{2.0, 1.0}, false});
    for (const Index i : {0, 20, 59})
        for (const Index j : {0, 30, 69})
            EXPECT_DOUBLE_EQ(map(i, j), std::hypot(2.0 * static_cast<double>(i - 20), static_cast<double>(j - 30)));
}

TEST(DistanceMap, OfAnEmptyMaskIsInfiniteOfAFullOneZero) {
    EXPECT_TRUE((distance_map(Mask::Zero(4, 5), {}) == std::numeric_limits<double>::infinity()).all());
    EXPECT_TRUE((distance_map(Mask::Ones(4, 5), {}) == 0.0).all());
}

TEST(DistanceMap, IsTheSameForAnyNumberOfThreads) {
    const auto mask = random_mask(101, 67, 0.03, 5);
    const auto one = distance_map(mask, {{1.0, 1.5}, true}, {1}), three = distance_map(mask, {{1.0, 1.5}, true}, {3});
    EXPECT_TRUE((one == three).all());
}

TEST(DistanceMap, RefusesWhatIsNoGrid) {
    EXPECT_THROW((void)distance_map(Mask(0, 3), {}), InvalidArgument);
    EXPECT_THROW((void)distance_map(Mask::Ones(3, 3), {{1.0, -1.0}, false}), InvalidArgument);
}

TEST(ClosestPatchMap, NamesAPatchThatIsNoFartherThanAnyOther) {
    for (const bool periodic : {false, true}) {
        const auto mask = random_mask(24, 19, 0.06, 11);
        const auto found = patches(mask, Neighbours::edges, periodic);
        ASSERT_GT(found.count, 5);
        const std::array<double, 2> pixel{1.0, 1.3};
        const auto closest = closest_patch_map(found, pixel);
        const auto distance = distance_map(mask, {pixel, periodic});
        for (Index i = 0; i < mask.rows(); ++i)
            for (Index j = 0; j < mask.cols(); ++j) {
                const Mask only = (found.numbers == closest(i, j)).cast<std::uint8_t>();
                ASSERT_NEAR(nearest(only, i, j, {pixel, periodic}), distance(i, j), 1e-12);
            }
        for (Index k = 0; k < mask.size(); ++k)
            if (found.numbers.data()[k] > 0) {
                EXPECT_EQ(closest.data()[k], found.numbers.data()[k]);
            }
        EXPECT_TRUE((closest == closest_patch_map(found, pixel, {3})).all());
    }
}

TEST(ClosestPatchMap, WithoutPatchesIsZero) { EXPECT_TRUE((closest_patch_map(patches(Mask::Zero(3, 4))) == 0).all()); }

}  // namespace
}  // namespace setae::geometry
