// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/geometry/patches.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/geometry/perimeter.hpp"

namespace setae::geometry {
namespace {

using topography::Mask;

Mask random_mask(Index nx, Index ny, double share, std::uint64_t seed) {
    std::mt19937_64 source(seed);
    return Mask::NullaryExpr(nx, ny, [&](Index, Index) {
        return static_cast<std::uint8_t>(static_cast<double>(source()) / 0x1p64 < share);
    });
}

/// Flood fill with a list, in storage order: slow and obvious.
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
                        if (periodic) m = (m + nx) % nx, n = (n + ny) % ny;
                        if (m < 0 || m >= nx || n < 0 || n >= ny || mask(m, n) == 0 || numbers(m, n) != 0) continue;
                        numbers(m, n) = count;
                        open.push_back({m, n});
                    }
            }
        }
    return numbers;
}

TEST(Patches, AgreeWithAFloodFillNumbersIncluded) {
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

TEST(Patches, OfACheckerboardAreOneWithCornersAndAllPointsWithout) {
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
    EXPECT_TRUE(patch_shapes(found).empty());
}

TEST(Patches, CountAnyValueButZeroAsChosen) {
    Mask mask = Mask::Zero(3, 3);
    mask(1, 1) = 255;
    EXPECT_EQ(patches(mask).numbers(1, 1), 1);
}

TEST(Patches, RefuseAMaskWithoutPoints) { EXPECT_THROW((void)patches(Mask(0, 5)), InvalidArgument); }

TEST(PatchShapes, OfADiscHaveItsAreaCentroidAndPerimeter) {
    const double radius = 60.3, pixel = 2e-9;
    const auto mask = Mask::NullaryExpr(200, 180, [&](Index i, Index j) {
                          return static_cast<std::uint8_t>(
                              std::hypot(static_cast<double>(i) - 90.2, static_cast<double>(j) - 85.7) < radius);
                      }).eval();
    const auto shapes = patch_shapes(patches(mask), {pixel, pixel});
    ASSERT_EQ(shapes.size(), 1U);
    const double r = radius * pixel;
    EXPECT_NEAR(shapes[0].area / (std::numbers::pi * r * r), 1.0,
                2e-3);  // lattice points in a circle: error ~ R^(2/3)/R²
    EXPECT_NEAR(shapes[0].centroid_x, 90.2 * pixel, 0.05 * pixel);
    EXPECT_NEAR(shapes[0].centroid_y, 85.7 * pixel, 0.05 * pixel);
    // every edge of a convex digital shape is seen once from each side: the bounding box's, whatever the pixels
    EXPECT_NEAR(shapes[0].edge_length / (8.0 * r), 1.0, 1.0 / radius);
    EXPECT_NEAR(isotropic_perimeter(shapes[0].edge_length) / (2.0 * std::numbers::pi * r), 1.0, 1.0 / radius);
}

TEST(PatchShapes, OfARectangleAreExactWithPixelsThatAreNotSquare) {
    Mask mask = Mask::Zero(20, 30);
    mask.block(4, 7, 5, 11) = 1;
    const auto shape = patch_shapes(patches(mask), {3.0, 0.5}).front();
    EXPECT_EQ(shape.points, 55);
    EXPECT_DOUBLE_EQ(shape.area, 55.0 * 1.5);
    EXPECT_DOUBLE_EQ(shape.centroid_x, 6.0 * 3.0);
    EXPECT_DOUBLE_EQ(shape.centroid_y, 12.0 * 0.5);
    EXPECT_DOUBLE_EQ(shape.edge_length, 2.0 * (5.0 * 3.0 + 11.0 * 0.5));
}

TEST(PatchShapes, AcrossACornerOfAPeriodicGridAreOfOnePiece) {
    Mask mask = Mask::Zero(10, 12);
    for (const Index i : {8, 9, 0})
        for (const Index j : {11, 0, 1, 2}) mask(i, j) = 1;
    const auto found = patches(mask, Neighbours::edges, true);
    ASSERT_EQ(found.count, 1);
    const auto shape = patch_shapes(found).front();
    EXPECT_DOUBLE_EQ(shape.centroid_x, 9.0);
    EXPECT_DOUBLE_EQ(shape.centroid_y, 0.5);
    EXPECT_DOUBLE_EQ(shape.edge_length, 14.0);
    EXPECT_FALSE(shape.spans_period);
    EXPECT_EQ(patches(mask, Neighbours::edges, false).count, 4);
}

TEST(PatchShapes, OfAStripeAcrossAPeriodicGridAreEndless) {
    Mask mask = Mask::Zero(10, 12);
    mask.row(3) = 1;
    const auto shape = patch_shapes(patches(mask, Neighbours::edges, true)).front();
    EXPECT_TRUE(shape.spans_period);
    EXPECT_TRUE(std::isnan(shape.centroid_x));
    EXPECT_DOUBLE_EQ(shape.edge_length, 24.0);
    // a diagonal chain closes on itself over the corners only where corners count
    const auto diagonal =
        Mask::NullaryExpr(12, 12, [](Index i, Index j) { return static_cast<std::uint8_t>(i == j); }).eval();
    EXPECT_TRUE(patch_shapes(patches(diagonal, Neighbours::edges_and_corners, true)).front().spans_period);
    for (const auto& alone : patch_shapes(patches(diagonal, Neighbours::edges, true))) EXPECT_FALSE(alone.spans_period);
}

TEST(PatchShapes, MoveWithThePatchAroundAPeriodicGrid) {
    Mask mask = Mask::Zero(16, 20);
    mask.block(2, 3, 6, 4) = 1;
    mask(8, 6) = mask(9, 6) = 1;
    const auto still = patch_shapes(patches(mask, Neighbours::edges, true)).front();
    for (const Index di : {3, 7, 11})
        for (const Index dj : {5, 14}) {
            const auto moved_mask = Mask::NullaryExpr(16, 20, [&](Index i, Index j) {
                                        return mask((i - di + 16) % 16, (j - dj + 20) % 20);
                                    }).eval();
            const auto moved = patch_shapes(patches(moved_mask, Neighbours::edges, true)).front();
            EXPECT_NEAR(moved.centroid_x, std::fmod(still.centroid_x + static_cast<double>(di), 16.0), 1e-12);
            EXPECT_NEAR(moved.centroid_y, std::fmod(still.centroid_y + static_cast<double>(dj), 20.0), 1e-12);
            EXPECT_EQ(moved.edge_length, still.edge_length);
        }
}

TEST(PatchShapes, SumUpToTheWholeMask) {
    for (const bool periodic : {false, true}) {
        const auto mask = random_mask(50, 41, 0.55, 9);
        const auto found = patches(mask, Neighbours::edges, periodic);
        Index points = 0;
        double edges = 0.0;
        for (const auto& shape : patch_shapes(found, {2.0, 3.0})) points += shape.points, edges += shape.edge_length;
        EXPECT_EQ(points, mask.cast<Index>().sum());
        EXPECT_NEAR(edges, edge_length(mask, {{2.0, 3.0}, periodic}).total(), 1e-9);
    }
}

TEST(PatchShapes, RefusePixelsWithoutSizeAndForeignNumbers) {
    auto found = patches(Mask::Ones(4, 4));
    EXPECT_THROW((void)patch_shapes(found, {0.0, 1.0}), InvalidArgument);
    found.numbers(0, 0) = 7;
    EXPECT_THROW((void)patch_shapes(found), InvalidArgument);
}

}  // namespace
}  // namespace setae::geometry
