// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/rough_curve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::simulation::rough_curve_test {
namespace {

double rms(const Array1D& values) { return std::sqrt((values - values.mean()).square().mean()); }

TEST(RoughCurve, SpansThePictureWithTheRequestedHeights) {
    double mean_square = 0.0;
    constexpr int seeds = 40;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const auto curve =
            rough_curve({.width = 400, .height = 300, .rms_height = 6.0, .rolloff_wavelength = 100.0, .key = {seed, 0}})
                .curve;
        EXPECT_LE(curve.x[0], -0.5);
        EXPECT_GE(curve.x[curve.x.size() - 1], 399.5);
        EXPECT_TRUE((curve.x.tail(curve.x.size() - 1) > curve.x.head(curve.x.size() - 1)).all());
        mean_square += (curve.y - 149.5).square().mean() / seeds;
    }
    // a third of the period is not shown: about 10 independent waves in each of 40 curves, so 5 % of 36, 3 standard
    // errors
    EXPECT_NEAR(mean_square, 36.0, 5.4);
}

TEST(RoughCurve, HasNoWavesBelowItsCutoff) {
    // between points of a quarter pixel, a wave of length λ >= 12 px bends by at most (2π/λ)² of its height
    const auto curve = rough_curve({.width = 600, .height = 300, .cutoff_wavelength = 12.0, .key = {2, 0}}).curve;
    const Index n = curve.x.size();
    const Array1D bend = (curve.y.head(n - 2) - 2.0 * curve.y.segment(1, n - 2) + curve.y.tail(n - 2)) / (0.25 * 0.25);
    const auto rougher = rough_curve({.width = 600, .height = 300, .cutoff_wavelength = 4.0, .key = {2, 0}}).curve;
    const Array1D more =
        (rougher.y.head(n - 2) - 2.0 * rougher.y.segment(1, n - 2) + rougher.y.tail(n - 2)) / (0.25 * 0.25);
    // ∫ q^4 C dq goes as cutoff^(2H − 4): the rms bend by (12/4)^1.2 = 3.74; scatter of curvatures of 50 waves: 10 %
    EXPECT_NEAR(rms(more) / rms(bend), std::pow(3.0, 1.2), 0.8);
}

TEST(RoughCurve, HasAnOverhangOfTheStatedDepthAtEveryBulge) {
    const auto rough = rough_curve({.width = 800,
                                    .height = 400,
                                    .rms_height = 4.0,
                                    .bulges = 4,
                                    .min_depth = 5.0,
                                    .largest_depth = 10.0,
                                    .key = {9, 0}});
    ASSERT_EQ(rough.overhangs.size(), 8u);
    const auto& x = rough.curve.x;
    // runs to the left, longer than rounding
    std::vector<double> depths;
    for (Index i = 1; i < x.size(); ++i) {
        if (x[i] >= x[i - 1]) continue;
        const double from = x[i - 1];
        while (i < x.size() && x[i] < x[i - 1]) ++i;
        depths.push_back(from - x[i - 1]);
    }
    ASSERT_EQ(depths.size(), 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        // points of arcs lie a quarter pixel apart: within 0.25²/(8 · 5) of the turning point
        EXPECT_NEAR(depths[i], rough.overhangs[i].depth, 0.004) << i;
        EXPECT_GE(rough.overhangs[i].depth, 5.0);
        EXPECT_LE(rough.overhangs[i].depth, 10.0);
        const double nearest =
            ((x - rough.overhangs[i].x).square() + (rough.curve.y - rough.overhangs[i].y).square()).minCoeff();
        EXPECT_LT(std::sqrt(nearest), 0.2) << i;
    }
}

TEST(RoughCurve, WithOverhangsCanBeRendered) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const auto rough =
            rough_curve({.width = 500, .height = 300, .rms_height = 8.0, .tilt = 0.35, .bulges = 5, .key = {seed, 0}});
        EXPECT_NO_THROW((void)render_micrograph(rough.curve, {.width = 500, .height = 300, .noise = 0.0})) << seed;
    }
}

TEST(RoughCurve, IsRotatedByItsTilt) {
    const auto level = rough_curve({.width = 300, .height = 300, .key = {4, 0}}).curve,
               tilted = rough_curve({.width = 300, .height = 300, .tilt = 0.3, .key = {4, 0}}).curve;
    const auto slope = [](const PixelCurve& c) {
        return (c.y[c.y.size() - 1] - c.y[0]) / (c.x[c.x.size() - 1] - c.x[0]);
    };
    EXPECT_LT(std::abs(slope(level)), 0.2);  // ends of a curve 8 px high, 420 px apart
    EXPECT_NEAR(slope(tilted), std::tan(0.3), 0.2);
}

TEST(RoughCurve, DependsOnTheKeyOnlyAndRefusesInvalidOptions) {
    const RoughCurveOptions good{.width = 200, .height = 200, .bulges = 1, .key = {1, 2}};
    EXPECT_TRUE((rough_curve(good).curve.y == rough_curve(good).curve.y).all());
    const auto refused = [&](auto change) {
        auto options = good;
        change(options);
        EXPECT_THROW((void)rough_curve(options), InvalidArgument);
    };
    refused([](auto& o) { o.width = 3; });
    refused([](auto& o) { o.rms_height = 0.0; });
    refused([](auto& o) { o.hurst_exponent = 1.2; });
    refused([](auto& o) { o.cutoff_wavelength = 1.0; });
    refused([](auto& o) { o.cutoff_wavelength = 2000.0; });
    refused([](auto& o) { o.tilt = 1.2; });
    refused([](auto& o) { o.bulges = 3; });
    refused([](auto& o) { o.min_depth = 11.0; });
}

}  // namespace
}  // namespace setae::simulation::rough_curve_test
