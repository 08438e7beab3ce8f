// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture/spatial_parameters.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::texture::spatial_parameters_test {
namespace {

using topography::HeightMap;

/// cos(q · x) summed over wavevectors (2πk/nx, 2πm/ny).
struct Wave {
    int k, m;
    double amplitude = 1.0, phase = 0.0;
};

HeightMap waves(Index nx, Index ny, const std::vector<Wave>& list, std::array<double, 2> size, bool periodic) {
    HeightMap map{Array2D::Zero(nx, ny), size, periodic, {}};
    for (const auto& wave : list)
        for (Index i = 0; i < nx; ++i)
            for (Index j = 0; j < ny; ++j)
                map.heights(i, j) +=
                    wave.amplitude * std::cos(2.0 * pi *
                                                  (wave.k * static_cast<double>(i) / static_cast<double>(nx) +
                                                   wave.m * static_cast<double>(j) / static_cast<double>(ny)) +
                                              wave.phase);
    return map;
}

TEST(SpatialParameters, OfTwoCrossedCosinesFollowFromTheirAutocorrelation) {
    // f = (cos q t_x + cos q t_y)/2 = 0.2: nearest on the diagonal cos = 0.2, farthest on the axes cos = −0.6
    const auto map = waves(120, 120, {{3, 0}, {0, 3}}, {1.0, 1.0}, true);
    const auto result = spatial_parameters(map);
    const double q = 2.0 * pi * 3.0;
    EXPECT_NEAR(result.Sal, std::sqrt(2.0) * std::acos(0.2) / q, 2e-5);
    EXPECT_NEAR(result.longest, std::acos(-0.6) / q, 2e-5);
    EXPECT_NEAR(result.Str, std::sqrt(2.0) * std::acos(0.2) / std::acos(-0.6), 2e-4);
}

TEST(SpatialParameters, OfAGaussianAutocorrelationAreItsTwoLengths) {
    // random phases do not affect the wrapped autocorrelation: f = exp(−(t_x/a)² − (t_y/b)²)
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> phase(0.0, 2.0 * pi);
    const double a = 0.08, b = 0.16;
    std::vector<Wave> list;
    for (int k = -12; k <= 12; ++k)
        for (int m = 0; m <= 6; ++m) {
            if (m == 0 && k <= 0) continue;
            list.push_back({k, m, std::exp(-0.5 * (std::pow(pi * k * a, 2) + std::pow(pi * m * b, 2))), phase(engine)});
        }
    // the missing mean wave shifts f by a constant c: (f − c)/(1 − c) = 0.2
    double total = 0.5;
    for (const auto& wave : list) total += wave.amplitude * wave.amplitude;
    const double c = 0.5 / total, level = 0.2 * (1.0 - c) + c;
    const auto result = spatial_parameters(waves(96, 96, list, {1.0, 1.0}, true));
    EXPECT_NEAR(result.Sal, a * std::sqrt(-std::log(level)), 2e-4 * a);
    EXPECT_NEAR(result.longest, b * std::sqrt(-std::log(level)), 2e-4 * b);
    EXPECT_NEAR(result.Str, 0.5, 2e-4);
    EXPECT_NEAR(result.Std, 0.5 * pi, 0.1);  // long along y
}

TEST(SpatialParameters, OfAGratingHaveADirectionAndNoAutocorrelationLength) {
    for (const auto& [k, m] : {std::pair{7, 0}, {0, 5}, {6, 6}, {6, -3}}) {
        const auto map = waves(96, 96, {{k, m}}, {2.0, 2.0}, false);
        const auto result = spatial_parameters(map);
        double lay = std::atan2(m, k) + 0.5 * pi;
        if (lay < 0.0) lay += pi;
        EXPECT_NEAR(std::remainder(result.Std - lay, pi), 0.0, 2e-3) << k << " " << m;
        EXPECT_GT(result.directionality, 7.0);  // at most 9
        EXPECT_TRUE(std::isnan(result.Str));
        ASSERT_FALSE(result.alerts.empty());
        EXPECT_EQ(result.alerts.front().code, "STR_UNDEFINED");
    }
}

TEST(SpatialParameters, AreEqualForBothDiagonals) {
    auto map = waves(60, 60, {{4, 4}, {1, -1}}, {1.0, 1.0}, false);
    const auto up = spatial_parameters(map);
    map.heights = map.heights.rowwise().reverse().eval();
    const auto down = spatial_parameters(map);
    EXPECT_NEAR(up.Std + down.Std, pi, 1e-9);
    EXPECT_NEAR(up.Sal, down.Sal, 1e-9);
    EXPECT_NEAR(up.longest, down.longest, 1e-9);
}

TEST(SpatialParameters, OfWhiteNoiseAreBelowOnePixel) {
    const auto result = spatial_parameters({tests::random_map(80, 64), {80.0, 64.0}});
    EXPECT_LT(result.Sal, 1.0);
    EXPECT_GT(result.Str, 0.5);
    EXPECT_LT(result.directionality, 2.0);
    EXPECT_EQ(result.alerts.back().code, "STD_WITHOUT_DIRECTION");
}

TEST(SpatialParameters, WithHolesUsePairsOfDefinedPoints) {
    auto map = waves(120, 120, {{3, 0}, {0, 3}}, {1.0, 1.0}, true);
    const auto whole = spatial_parameters(map);
    for (Index k = 0; k < 120; k += 7) map.heights(k, (k * 11) % 120) = undefined;
    const auto holed = spatial_parameters(map);
    EXPECT_NEAR(holed.Sal / whole.Sal, 1.0, 2e-3);
    EXPECT_NEAR(holed.Str / whole.Str, 1.0, 5e-3);
}

TEST(SpatialParameters, AreUnaffectedByAnOffset) {
    auto map = waves(64, 64, {{3, 1}, {1, 4, 0.5}, {2, -3, 0.7}}, {1.0, 1.0}, false);
    const auto plain = spatial_parameters(map);
    map.heights += 1e7;
    const auto lifted = spatial_parameters(map);
    EXPECT_NEAR(lifted.Sal, plain.Sal, 1e-6 * plain.Sal);
    EXPECT_NEAR(lifted.Std, plain.Std, 1e-6);
}

TEST(SpatialParameters, OfAConstantMapAreRefused) {
    EXPECT_THROW((void)spatial_parameters({Array2D::Constant(8, 8, 0.1), {1.0, 1.0}}), UndefinedDataError);
    EXPECT_THROW((void)spatial_parameters({tests::random_map(8, 8), {1.0, 1.0}}, {.threshold = 1.0}), InvalidArgument);
}

TEST(SpatialParameters, AreTheSameForAnyNumberOfThreads) {
    const HeightMap map{tests::random_map(90, 70), {1.0, 1.0}};
    const auto one = spatial_parameters(map, {}, {1}), three = spatial_parameters(map, {}, {3});
    EXPECT_EQ(one.Sal, three.Sal);
    EXPECT_EQ(one.Std, three.Std);
}

// Two islands, one high and one low: pairs within an island are similar, pairs of its size do not exist.
TEST(SpatialParameters, OfFlatIslandsHaveNoAutocorrelationLength) {
    HeightMap map{Array2D::Constant(24, 24, undefined), {1.0, 1.0}, false, {}};
    map.heights.block(4, 4, 2, 2) = 1.0;
    map.heights.block(16, 16, 2, 2) = -1.0;
    const auto result = spatial_parameters(map);
    EXPECT_TRUE(std::isnan(result.Sal));
    ASSERT_EQ(result.alerts.size(), 2U);
    EXPECT_EQ(result.alerts[0].code, "SAL_UNDEFINED");
    EXPECT_EQ(result.alerts[1].code, "STR_UNDEFINED");
}

}  // namespace
}  // namespace setae::texture::spatial_parameters_test
