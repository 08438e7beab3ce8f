// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/stretch.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::spectral_fit::stretch_test {
namespace {

constexpr double wide = std::numeric_limits<double>::infinity();

/// A quarter of a patch, so it is not periodic. Offsets of its lines are a tenth of its rms height.
topography::HeightMap stretched_map(std::uint64_t seed, double stretch, double angle, bool line_offsets = false) {
    constexpr Index points = 256, fine = 2 * points;
    constexpr double pixel = 10e-9, size = fine * pixel;
    const spectra::SelfAffine model{.plateau = 2e-29,
                                    .rolloff_wavevector = 2.0 * pi / 500e-9,
                                    .hurst_exponent = 0.8,
                                    .short_wavevector = pi / pixel};
    const auto patch = synthesis::random_surface(spectra::density(model), {fine, fine, size, size},
                                                 {.key = {seed, 3}, .anisotropy = {stretch, angle}, .threads = {1}});
    topography::HeightMap map{patch.heights.topLeftCorner(points, points), {0.5 * size, 0.5 * size}, false, {}};
    if (line_offsets) {
        const double rms = std::sqrt(map.heights.square().mean());
        for (Index j = 0; j < points; ++j)
            map.heights.col(j) += 0.1 * rms * std::sin(12.9898 * static_cast<double>(j * j));
    }
    return map;
}

TEST(Stretch, KeepsAreasAndRotatesWithItsAxes) {
    const Stretch stretch{{std::log(2.0) * std::cos(0.6), std::log(2.0) * std::sin(0.6)}};
    EXPECT_NEAR(stretch.ratio(), 2.0, 1e-12);
    EXPECT_NEAR(stretch.direction(), 0.3, 1e-12);
    // q is longest, and lines are shortest, along the long axis: by √2 and 1/√2
    EXPECT_NEAR(stretch.wave_square(0.3), 2.0, 1e-12);
    EXPECT_NEAR(stretch.wave_square(0.3 + 0.5 * pi), 0.5, 1e-12);
    EXPECT_NEAR(stretch.length_square(0.3), 0.5, 1e-12);
    EXPECT_NEAR(stretch.length_square(0.3 + 0.5 * pi), 2.0, 1e-12);
    EXPECT_NEAR(Stretch{}.wave_square(1.0), 1.0, 1e-15);
}

TEST(StretchLaw, IsLinearBetweenItsNodes) {
    const StretchLaw law({std::log(1e6), std::log(1e8)}, {{0.2, 0.0}, {0.4, 0.2}});
    EXPECT_NEAR(law.at(1e7).vector[0], 0.3, 1e-12);
    EXPECT_NEAR(law.at(1e7).vector[1], 0.1, 1e-12);
    EXPECT_EQ(law.at(1e3).vector[0], 0.2);
    EXPECT_EQ(law.at(1e12).vector[1], 0.2);
    EXPECT_TRUE(StretchLaw{}.isotropic());
    EXPECT_EQ(StretchLaw{}.at(1e7).ratio(), 1.0);
}

// Four maps of each of five surfaces and of an isotropic one.
TEST(ObservedStretch, RecoversTheTrueAnisotropy) {
    double chi_squared = 0.0;
    std::uint64_t seed = 0;
    for (const auto& [stretch, angle] :
         {std::pair{1.0, 0.0}, {1.5, 0.0}, {1.5, pi / 6.0}, {2.0, 0.5 * pi}, {3.0, -1.0}, {1.2, 0.8}}) {
        std::vector<ObservedStretch> all;
        for (int map = 0; map < 4; ++map)
            for (const auto& one : observed_stretch(stretched_map(seed++, stretch, angle), {0.0, wide}, {1}))
                all.push_back(one);
        const auto found = combined_stretch(all);
        if (stretch == 1.0) {
            EXPECT_TRUE(found.law.isotropic());
            continue;
        }
        ASSERT_EQ(found.law.knots(), 1) << stretch << " along " << angle;
        const Eigen::Vector2d known = std::log(stretch) * Eigen::Vector2d(std::cos(2.0 * angle), std::sin(2.0 * angle));
        const Eigen::Vector2d off = found.law.values() - known;
        chi_squared += off.dot(found.information * off);
        EXPECT_GT(found.information(0, 0), 1.0 / (0.05 * 0.05));
    }
    EXPECT_LT(chi_squared, 23.2);  // p 0.01 of ten degrees of freedom
    EXPECT_GT(chi_squared, 2.6);   // and of errors that are too large
}

TEST(ObservedStretch, IsUnaffectedByLineOffsets) {
    std::vector<ObservedStretch> all;
    for (std::uint64_t seed = 0; seed < 4; ++seed)
        for (const auto& one : observed_stretch(stretched_map(seed, 1.0, 0.0, true), {0.0, wide}, {1}))
            all.push_back(one);
    EXPECT_GE(all.size(), 4u);
    EXPECT_TRUE(combined_stretch(all).law.isotropic());
}

TEST(CombinedStretch, MayDependOnTheScale) {
    std::vector<ObservedStretch> observed;
    for (const double q : {2e6, 4e6, 2e7, 4e7}) {
        ObservedStretch one{.wavevector = q};
        one.stretch.vector[0] = q < 1e7 ? 0.5 : 0.1;
        one.information = Eigen::Matrix2d::Identity() * 1e4;
        observed.push_back(one);
    }
    const auto found = combined_stretch(observed);
    EXPECT_LT(found.constancy, 1e-6);
    ASSERT_EQ(found.law.knots(), 2);
    EXPECT_NEAR(found.law.at(1e6).vector[0], 0.5, 1e-12);
    EXPECT_NEAR(found.law.at(1e9).vector[0], 0.1, 1e-12);
}

TEST(ObservedStretch, IsEmptyWithoutModesOrWithUndefinedHeights) {
    auto map = stretched_map(1, 1.5, 0.0);
    EXPECT_TRUE(observed_stretch(map, {1e9, wide}, {1}).empty());
    map.heights(3, 3) = undefined;
    EXPECT_TRUE(observed_stretch(map, {0.0, wide}, {1}).empty());
    EXPECT_TRUE(combined_stretch({}).law.isotropic());
}

}  // namespace
}  // namespace setae::spectral_fit::stretch_test
