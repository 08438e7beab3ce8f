// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of SurfaceTopography 1.27.1 and scipy: README.md.
#include <tuple>

#include <gtest/gtest.h>

#include "setae/geometry/distance.hpp"
#include "setae/geometry/patches.hpp"
#include "setae/geometry/perimeter.hpp"

namespace setae::geometry {
namespace {

topography::Mask mask_below(Index threshold) {
    return topography::Mask::NullaryExpr(48, 37, [threshold](Index i, Index j) {
        return static_cast<std::uint8_t>((7 * i * i + 5 * j * j + 3 * i * j) % 97 < threshold);
    });
}

struct Expected {
    Neighbours neighbours;
    bool periodic;
    std::int32_t count;
    long long weighted_numbers;  ///< Σ number · (storage index mod 13 + 1): the numbering itself
};

TEST(GeometryOfSurfaceTopography, NumbersPatchesAlike) {
    for (const auto& expected :
         {Expected{Neighbours::edges, false, 245, 589794}, Expected{Neighbours::edges, true, 237, 557182},
          Expected{Neighbours::edges_and_corners, false, 50, 96202},
          Expected{Neighbours::edges_and_corners, true, 32, 49592}}) {
        const auto found = patches(mask_below(37), expected.neighbours, expected.periodic);
        EXPECT_EQ(found.count, expected.count);
        long long sum = 0;
        for (Index k = 0; k < found.numbers.size(); ++k)
            sum += static_cast<long long>(found.numbers.data()[k]) * (k % 13 + 1);
        EXPECT_EQ(sum, expected.weighted_numbers);
    }
}

TEST(GeometryOfSurfaceTopography, FindsTheSamePerimeters) {
    const auto mask = mask_below(37);
    EXPECT_EQ(mask.cast<int>().sum(), 673);
    for (const auto& [neighbours, inner, outer] :
         {std::tuple{Neighbours::edges, 572, 935}, std::tuple{Neighbours::edges_and_corners, 593, 1030}}) {
        EXPECT_EQ(inner_perimeter(mask, neighbours).block(1, 1, 46, 35).cast<int>().sum(), inner);
        EXPECT_EQ(outer_perimeter(mask, neighbours).cast<int>().sum(), outer);
    }
    EXPECT_EQ(inner_perimeter(mask, Neighbours::edges, true).cast<int>().sum(), 637);
    EXPECT_EQ(inner_perimeter(mask, Neighbours::edges_and_corners, true).cast<int>().sum(), 658);
    EXPECT_EQ(outer_perimeter(mask, Neighbours::edges, true).cast<int>().sum(), 950);
    EXPECT_EQ(outer_perimeter(mask, Neighbours::edges_and_corners, true).cast<int>().sum(), 1046);
}

TEST(GeometryOfSurfaceTopography, MeasuresTheSameDistancesWhichWrap) {
    const auto dense = distance_map(mask_below(37), {{1.0, 1.0}, true}),
               sparse = distance_map(mask_below(2), {{1.0, 1.0}, true});
    EXPECT_NEAR(dense.sum(), 1208.6323755685376, 1e-9);
    EXPECT_NEAR(dense.maxCoeff(), 2.8284271247461903, 1e-14);
    EXPECT_NEAR(sparse.sum(), 7313.693654509387, 1e-9);
    EXPECT_NEAR(sparse.square().sum(), 36488.0, 1e-8);
    EXPECT_NEAR(sparse.maxCoeff(), 9.219544457292887, 1e-13);
}

TEST(GeometryOfScipy, MeasuresTheSameDistancesOnAnOpenGrid) {
    const auto dense = distance_map(mask_below(37), {}), sparse = distance_map(mask_below(2), {});
    EXPECT_NEAR(dense.sum(), 1229.004006460149, 1e-9);
    EXPECT_NEAR(dense.square().sum(), 1481.0, 1e-9);
    EXPECT_NEAR(sparse.sum(), 8271.374338235833, 1e-9);
    EXPECT_NEAR(sparse.maxCoeff(), 15.556349186104045, 1e-13);
}

}  // namespace
}  // namespace setae::geometry
