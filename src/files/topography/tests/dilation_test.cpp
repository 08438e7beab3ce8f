// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/dilation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "samples.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography::dilation_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

HeightMap flat_map(Index nx, Index ny, double pixel = 1.0) {
    return {Array2D::Zero(nx, ny), {static_cast<double>(nx) * pixel, static_cast<double>(ny) * pixel}};
}

HeightMap rough_map(Index nx, Index ny, bool periodic = false) {
    return {tests::random_map(nx, ny, 7), {static_cast<double>(nx), static_cast<double>(ny)}, periodic};
}

/// Dilation by its definition, point by point.
Array2D slow_dilation(const HeightMap& surface, const TipImage& tip) {
    const auto [nx, ny] = surface.shape();
    Array2D result = Array2D::Constant(nx, ny, -infinite);
    for (Index x = 0; x < nx; ++x)
        for (Index y = 0; y < ny; ++y)
            for (Index i = -tip.centre_x; i <= tip.centre_x; ++i)
                for (Index j = -tip.centre_y; j <= tip.centre_y; ++j) {
                    Index at_x = x + i, at_y = y + j;
                    if (surface.periodic) {
                        at_x = ((at_x % nx) + nx) % nx;
                        at_y = ((at_y % ny) + ny) % ny;
                    } else if (at_x < 0 || at_y < 0 || at_x >= nx || at_y >= ny) {
                        continue;
                    }
                    result(x, y) = std::max(
                        result(x, y), surface.heights(at_x, at_y) - tip.heights(i + tip.centre_x, j + tip.centre_y));
                }
    return result;
}

TEST(Dilation, OfASpikeIsTheInvertedTip) {
    auto surface = flat_map(41, 37);
    surface.heights(20, 18) = 6.0;
    const auto image = dilated(surface, SphereTip{10.0});
    for (Index i = 0; i < 41; ++i)
        for (Index j = 0; j < 37; ++j) {
            const double distance = std::hypot(static_cast<double>(i - 20), static_cast<double>(j - 18));
            const double expected =
                std::max(0.0, 6.0 - (distance <= 10.0 ? 10.0 - std::sqrt(100.0 - distance * distance) : 10.0));
            EXPECT_NEAR(image.heights(i, j), expected, 1e-14) << i << ' ' << j;
        }
}

TEST(Dilation, OfABallIsABallOfTheSumOfRadii) {
    // contacts are between grid points: their error is second order, pixel²/8 (1/R + 1/R_s) = 0.0021 of a pixel at the
    // top
    const double bump = 120.0, tip = 200.0;
    auto surface = flat_map(101, 101);
    for (Index i = 0; i < 101; ++i)
        for (Index j = 0; j < 101; ++j) {
            const double x = static_cast<double>(i - 50), y = static_cast<double>(j - 50);
            surface.heights(i, j) = std::sqrt(bump * bump - x * x - y * y);
        }
    const auto image = dilated(surface, SphereTip{tip});
    for (const Index k : {0, 5, 13, 25}) {
        const double expected = std::sqrt((bump + tip) * (bump + tip) - static_cast<double>(2 * k * k)) - tip;
        EXPECT_LE(image.heights(50 + k, 50 - k), expected + 1e-12);
        EXPECT_NEAR(image.heights(50 + k, 50 - k), expected, 0.004);
    }
}

TEST(Dilation, OfAGentleCosineFollowsItsParallelCurve) {
    // z = a cos(kx), a k² < 1/R: each point of the surface is touched, with the centre of the sphere along its normal
    const Index n = 4000;
    const double amplitude = 0.3, wave = 2.0 * pi, radius = 0.05, step = 1.0 / static_cast<double>(n);
    LineScan surface{Array1D(n), 1.0, true};
    for (Index k = 0; k < n; ++k) surface.heights[k] = amplitude * std::cos(wave * static_cast<double>(k) * step);
    const auto image = dilated(surface, SphereTip{radius});
    for (const double touched : {0.0, 0.1, 0.2, 0.25, 0.4, 0.5}) {
        const double slope = -amplitude * wave * std::sin(wave * touched), length = std::sqrt(1.0 + slope * slope);
        const double x = touched - radius * slope / length;
        const double expected = amplitude * std::cos(wave * touched) + radius / length - radius;
        const auto left = static_cast<Index>(std::floor(x / step));
        const double fraction = x / step - static_cast<double>(left);
        const double read = (1.0 - fraction) * image.heights[left % n] + fraction * image.heights[(left + 1) % n];
        EXPECT_NEAR(read, expected, 3e-6) << touched;  // step²/8 (z'' + t''), t'' = (1 + slope²)^(3/2)/R
    }
}

TEST(Dilation, EqualsItsDefinitionOnRoughSurfaces) {
    for (const bool periodic : {false, true})
        for (const Tip& tip : {Tip(SphereTip{4.0}), Tip(ConeTip{0.9, 1.0}), Tip(ParabolicTip{9.0})}) {
            const auto surface = rough_map(45, 70, periodic);
            const double range = surface.heights.maxCoeff() - surface.heights.minCoeff();
            const auto image = dilated(surface, tip);
            const auto expected = slow_dilation(surface, tip_image(tip, 1.0, 1.0, tip_reach(tip, range)));
            EXPECT_TRUE((image.heights == expected).all()) << tip.index() << periodic;
        }
}

TEST(Dilation, EqualsItsDefinitionForTipsOfAnyShape) {
    // flanks are not monotonic, points are missing: bounds over blocks must not depend on either
    ArrayTip tip{tests::random_map(27, 21, 4).abs(), {1.0, 1.0}, 5, 17};
    tip.heights = (tip.heights > 2.0).select(infinite, tip.heights);
    tip.heights(5, 17) = 0.0;
    TipImage image{Array2D::Constant(55, 55, infinite), 27, 27};
    image.heights.block(27 - 5, 27 - 17, 27, 21) = tip.heights;
    for (const bool periodic : {false, true}) {
        const auto surface = rough_map(64, 83, periodic);
        EXPECT_TRUE((dilated(surface, tip).heights == slow_dilation(surface, image)).all()) << periodic;
    }
}

TEST(Dilation, OfAPeriodicMapWrapsTipsLargerThanThePeriod) {
    auto surface = rough_map(5, 9, true);
    const Tip tip = ParabolicTip{30.0};
    const double range = surface.heights.maxCoeff() - surface.heights.minCoeff();
    ASSERT_GT(tip_reach(tip, range), 9.0);
    EXPECT_TRUE(
        (dilated(surface, tip).heights == slow_dilation(surface, tip_image(tip, 1.0, 1.0, tip_reach(tip, range))))
            .all());
}

TEST(Dilation, TreatsBothWindowEndsAlike) {
    LineScan line{Array1D::Zero(5), 5.0};
    line.heights[4] = 10.0;
    const auto at_right = dilated(line, ParabolicTip{0.5}, {.height_range = 4.0});
    line.heights.reverseInPlace();
    const auto at_left = dilated(line, ParabolicTip{0.5}, {.height_range = 4.0});
    EXPECT_EQ(at_right.heights[3], 9.0);
    EXPECT_TRUE((at_right.heights == at_left.heights.reverse()).all());
}

TEST(Dilation, IsTheSameForAnyNumberOfThreads) {
    const auto surface = rough_map(67, 1100);
    const auto one = dilated(surface, SphereTip{12.0}, {.threads = {1}}),
               three = dilated(surface, SphereTip{12.0}, {.threads = {3}});
    EXPECT_TRUE((one.heights == three.heights).all());
}

TEST(Dilation, IgnoresUndefinedHeightsAndDoesNotSpreadThem) {
    auto surface = flat_map(20, 20);
    surface.heights(10, 10) = undefined;
    surface.heights(3, 3) = 1.0;
    const auto kept = dilated(surface, SphereTip{3.0});
    EXPECT_TRUE(std::isnan(kept.heights(10, 10)));
    EXPECT_EQ(kept.heights.isNaN().count(), 1);
    const auto filled = dilated(surface, SphereTip{3.0}, {.keep_undefined = false});
    EXPECT_NEAR(filled.heights(10, 10), -(3.0 - std::sqrt(8.0)), 1e-15);
}

TEST(Dilation, OfALineScanUsesTheLineOnly) {
    auto surface = flat_map(30, 30);
    surface.heights.row(10).setConstant(2.0);
    LineScan line{surface.heights.col(5), 30.0};
    line.heights[10] = 0.0;
    EXPECT_EQ(dilated(line, SphereTip{5.0}).heights.abs().maxCoeff(), 0.0);
    EXPECT_GT(dilated(surface, SphereTip{5.0}).heights(12, 5), 1.0);
}

TEST(DilatedAt, EqualsTheDilatedMapAtItsPoints) {
    const auto surface = rough_map(200, 150, true);
    const Tip tip = SphereTip{40.0};
    const auto image = dilated(surface, tip);
    const Index n = 700;
    Array1D x(n), y(n);
    for (Index k = 0; k < n; ++k) {
        x[k] = static_cast<double>(k) - 100.0;  // beyond both ends
        y[k] = static_cast<double>((k * k) % 150) + 0.3;
    }
    const auto readings = dilated_at(surface, tip, x, y);
    for (Index k = 0; k < n; ++k) EXPECT_EQ(readings[k], image.heights((k + 100) % 200, (k * k) % 150));
}

TEST(Dilator, GivesSinglePointsEqualToTheMap) {
    const auto surface = rough_map(40, 30, true);
    const Dilator dilator(surface, SphereTip{6.0});
    const Array2D image = dilator.readings();
    for (const Index k : {0, 7, 29}) {
        EXPECT_EQ(dilator.reading(k, 29 - k), image(k, 29 - k));
        EXPECT_EQ(dilator.reading(k - 40, 59 - k), image(k, 29 - k));
    }
    const auto cut = rough_map(40, 30);
    EXPECT_THROW((void)Dilator(cut, SphereTip{6.0}).reading(40, 0), InvalidArgument);
}

TEST(DilatedAt, RefusesPointsOutsideAndUnequalLists) {
    const auto surface = rough_map(50, 50);
    EXPECT_THROW((void)dilated_at(surface, SphereTip{3.0}, Array1D::Constant(1, 50.0), Array1D::Zero(1)),
                 InvalidArgument);
    EXPECT_THROW((void)dilated_at(surface, SphereTip{3.0}, Array1D::Zero(2), Array1D::Zero(1)), InvalidArgument);
    EXPECT_THROW((void)dilated_at(surface, SphereTip{3.0}, Array1D::Constant(1, undefined), Array1D::Zero(1)),
                 InvalidArgument);
}

TEST(Dilation, RefusesATipLargerThanTheScanWithBothLengths) {
    auto surface = flat_map(10, 30);
    surface.heights(3, 3) = 20.0;
    try {
        (void)dilated(surface, SphereTip{50.0});
        FAIL();
    } catch (const InvalidArgument& error) {
        const std::string message = error.what();
        EXPECT_NE(message.find("40 m from its axis"), std::string::npos) << message;
        EXPECT_NE(message.find("10 m by 30 m"), std::string::npos) << message;
    }
    EXPECT_THROW((void)dilated(LineScan{surface.heights.col(3), 10.0}, SphereTip{50.0}), InvalidArgument);
    surface.heights.setConstant(undefined);
    EXPECT_THROW((void)dilated(surface, SphereTip{50.0}), UndefinedDataError);
}

TEST(Erosion, RecoversASurfaceNoSharperThanTheTip) {
    LineScan line{Array1D(200), 200.0, true};
    for (Index k = 0; k < 200; ++k) line.heights[k] = std::cos(2.0 * pi * static_cast<double>(k) / 200.0);
    const Tip tip = ParabolicTip{100.0};  // 1/R = 0.01 > (2π/200)² = 0.001
    const auto back = eroded(dilated(line, tip), tip);
    // apexes on the grid skip some points: there the reconstruction is on the tip between, pixel²/(8R) above
    EXPECT_LT((back.heights - line.heights).maxCoeff(), 1.0 / 800.0);
    EXPECT_GT((back.heights - line.heights).minCoeff(), -1e-12);
}

TEST(Erosion, OfAnAsymmetricTipUsesItsMirrorImage) {
    ArrayTip tip{Array2D::Constant(3, 3, infinite), {1.0, 1.0}, 1, 1};
    tip.heights(1, 1) = 0.0;
    tip.heights(2, 1) = 0.25;  // extends only towards larger x
    const auto surface = rough_map(30, 20);
    const auto image = dilated(surface, tip);
    EXPECT_EQ(image.heights(10, 5), std::max(surface.heights(10, 5), surface.heights(11, 5) - 0.25));
    const auto back = eroded(image, tip);
    EXPECT_TRUE((back.heights >= surface.heights - 1e-12).all());
    EXPECT_LT((dilated(back, tip).heights - image.heights).abs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace setae::topography::dilation_test
