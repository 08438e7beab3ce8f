// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture/feature_parameters.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::texture::feature_parameters_test {
namespace {

using topography::HeightMap;

/// cos(q x) + cos(q y) with so many waves per side.
HeightMap egg_box(Index n, int waves, double size, double amplitude, bool periodic) {
    HeightMap map{Array2D(n, n), {size, size}, periodic, {}};
    const double q = 2.0 * pi * waves / static_cast<double>(n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j)
            map.heights(i, j) =
                amplitude * (std::cos(q * static_cast<double>(i)) + std::cos(q * static_cast<double>(j)));
    return map;
}

TEST(FeatureParameters, OfAnEggBoxCountItsPeaks) {
    const double size = 1e-5, A = 1e-8;
    const auto result = feature_parameters(egg_box(120, 6, size, A, true));
    EXPECT_EQ(result.hills, 36);
    EXPECT_EQ(result.dales, 36);
    EXPECT_NEAR(result.Spd, 36.0 / (size * size), 1e-3);
    EXPECT_NEAR(result.S5p, 2.0 * A, 1e-20);
    EXPECT_NEAR(result.S5v, 2.0 * A, 1e-20);
    EXPECT_NEAR(result.S10z, 4.0 * A, 1e-20);
    // by the symbol of second differences; q² in the limit
    const double step = size / 120.0, q = 2.0 * pi * 6.0 / size;
    EXPECT_NEAR(result.Spc, A * 2.0 * (1.0 - std::cos(q * step)) / (step * step), 1e-6 * A * q * q);
    EXPECT_NEAR(result.Svc, -result.Spc, 1e-6 * A * q * q);
}

TEST(FeatureParameters, ExcludeHillsThatReachTheEdge) {
    // peaks at 0, 20 … 100 and, beyond the edge, 120: those at the edges are cut; of the pits at 10, 30 … 110 those at
    // 10 and 110 are
    const auto result = feature_parameters(egg_box(120, 6, 1.0, 1.0, false));
    EXPECT_EQ(result.hills, 25);
    EXPECT_EQ(result.dales, 16);
}

TEST(FeatureParameters, MergeLowHills) {
    // two peaks of 1 and 0.9 with a saddle at 0.8 on one ridge, in a plain at 0: Sz = 1
    HeightMap map{Array2D::Zero(9, 15), {9.0, 15.0}, true, {}};
    map.heights.row(4).segment(4, 7) << 0.5, 1.0, 0.9, 0.8, 0.85, 0.9, 0.5;
    EXPECT_EQ(feature_parameters(map, {.pruning = 0.05}).hills, 2);
    EXPECT_EQ(feature_parameters(map, {.pruning = 0.2}).hills, 1);
    EXPECT_NEAR(feature_parameters(map, {.pruning = 0.2}).S5p, 1.0 - map.heights.mean(), 1e-15);
    EXPECT_EQ(feature_parameters(map, {.pruning = 0.2}).dales, 1);  // the plain
}

TEST(FeatureParameters, OfAPlateauAreOnePeak) {
    HeightMap map{Array2D::Zero(12, 12), {12.0, 12.0}, true, {}};
    map.heights.block(4, 4, 3, 4).setOnes();
    const auto result = feature_parameters(map);
    EXPECT_EQ(result.dales, 1);
    EXPECT_EQ(result.hills, 1);
}

TEST(FeatureParameters, HillsThatReachAHoleDoNotCount) {
    auto map = egg_box(120, 6, 1.0, 1.0, true);
    map.heights(23, 60) = undefined;  // on the hill at (20, 60)
    const auto result = feature_parameters(map);
    EXPECT_EQ(result.hills, 35);
}

TEST(FeatureParameters, AreConsistentForMirroredAndInvertedMaps) {
    const HeightMap map{tests::random_map(40, 50), {1.0, 1.0}};
    const HeightMap mirrored{map.heights.colwise().reverse(), {1.0, 1.0}};
    const HeightMap inverse{-map.heights, {1.0, 1.0}};
    const auto a = feature_parameters(map), b = feature_parameters(mirrored), c = feature_parameters(inverse);
    EXPECT_EQ(a.hills, b.hills);
    EXPECT_NEAR(a.Spc, b.Spc, 1e-9 * std::abs(a.Spc));
    EXPECT_EQ(a.hills, c.dales);
    EXPECT_NEAR(a.S5p, c.S5v, 1e-12);
    EXPECT_NEAR(a.Spc, -c.Svc, 1e-9 * std::abs(a.Spc));
}

TEST(FeatureParameters, OfAConstantOrTiltedMapAreEmpty) {
    const auto flat = feature_parameters({Array2D::Constant(6, 6, 0.1), {1.0, 1.0}});
    EXPECT_EQ(flat.hills, 0);
    EXPECT_TRUE(std::isnan(flat.Spc) && std::isnan(flat.S5p) && std::isnan(flat.S10z));
    EXPECT_THROW((void)feature_parameters({Array2D::Constant(6, 6, 0.1), {1.0, 1.0}}, {.pruning = -0.1}),
                 InvalidArgument);
    EXPECT_THROW((void)feature_parameters({Array2D::Constant(6, 6, undefined), {1.0, 1.0}}), UndefinedDataError);
}

TEST(FeatureParameters, AreTheSameForAnyNumberOfThreads) {
    const HeightMap map{tests::random_map(60, 70), {1.0, 1.0}};
    const auto one = feature_parameters(map, {}, {1}), two = feature_parameters(map, {}, {2});
    EXPECT_EQ(one.Spc, two.Spc);
    EXPECT_EQ(one.S10z, two.S10z);
}

}  // namespace
}  // namespace setae::texture::feature_parameters_test
