// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/micrograph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pictures/polygon_coverage.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::simulation::micrograph_test {
namespace {

PixelCurve curve_of(std::initializer_list<std::array<double, 2>> points) {
    PixelCurve curve{Array1D(static_cast<Index>(points.size())), Array1D(static_cast<Index>(points.size()))};
    Index i = 0;
    for (const auto& [x, y] : points) {
        curve.x[i] = x;
        curve.y[i++] = y;
    }
    return curve;
}

/// A wave over a picture and its surroundings.
PixelCurve wave(double mean, double height, double length, double width) {
    const auto points = static_cast<Index>(4.0 * (width + 80.0)) + 1;
    PixelCurve curve{Array1D::LinSpaced(points, -40.0, width + 40.0), Array1D(points)};
    curve.y = mean + height * (2.0 * pi / length * curve.x).sin();
    return curve;
}

/// No noise, no blur: vacuum 0 and sample 1, so that grey levels are areas.
MicrographOptions exact(long width, long height) {
    return {.width = width, .height = height, .vacuum_level = 0.0, .sample_level = 1.0, .noise = 0.0, .blur = 0.0};
}

double standard_deviation(const Array2D& values) { return std::sqrt((values - values.mean()).square().mean()); }

TEST(PolygonCoverage, SumsToThePolygonAreaEvenWithOverhangs) {
    // a mushroom: the curve runs back over itself; shoelace area of what is below within 0 … 40 × 0 … 30, corners at −½
    const auto curve = curve_of({{-3.0, 20.3},
                                 {15.2, 19.7},
                                 {15.7, 14.1},
                                 {9.3, 12.2},
                                 {12.4, 6.9},
                                 {21.8, 4.4},
                                 {31.1, 9.6},
                                 {24.6, 13.3},
                                 {23.9, 20.8},
                                 {45.0, 18.2}});
    const Array2D coverage = coverage_below(curve, {0, 0, 40, 30});
    const auto at = [](double x, double x0, double y0, double x1, double y1) {
        return y0 + (y1 - y0) * (x - x0) / (x1 - x0);
    };
    double area = 0.0;
    PixelCurve clipped = curve;
    clipped.y[0] = at(-0.5, -3.0, 20.3, 15.2, 19.7);
    clipped.x[0] = -0.5;
    clipped.y[9] = at(39.5, 23.9, 20.8, 45.0, 18.2);
    clipped.x[9] = 39.5;
    for (Index i = 1; i < 10; ++i)
        area += (clipped.x[i] - clipped.x[i - 1]) * (29.5 - 0.5 * (clipped.y[i] + clipped.y[i - 1]));
    EXPECT_NEAR(coverage.sum(), area, 1e-9);
    EXPECT_GE(coverage.minCoeff(), -1e-12);
    EXPECT_LE(coverage.maxCoeff(), 1.0 + 1e-12);
    EXPECT_EQ(coverage(14, 11), coverage(0, 0));  // vacuum below the cap
    EXPECT_NEAR(coverage(9, 18), 1.0, 1e-12);     // within it
    EXPECT_NEAR(coverage(29, 12), 1.0, 1e-12);
}

TEST(PolygonCoverage, OfOnePixelEqualsTheCoveredShare) {
    // the line y = x/2 through the pixel (0, 0), whose square is ±½: half of it; pixel (0, 1), x in ½ … 1½: ½ − ½ = 0
    // at its middle
    const auto curve = curve_of({{-4.0, -2.0}, {4.0, 2.0}});
    const Array2D coverage = coverage_below(curve, {-1, -1, 3, 3});
    EXPECT_NEAR(coverage(1, 1), 0.5, 1e-15);
    EXPECT_NEAR(coverage(1, 2), 0.0625, 1e-15);  // triangle of ½ × ¼ under the line from (½, ¼) to (1, ½)
    EXPECT_NEAR(coverage(0, 0), 1.0 - 0.9375, 1e-15);
    EXPECT_NEAR(coverage(0, 2), 0.0, 1e-15);
    EXPECT_NEAR(coverage(2, 0), 1.0, 1e-15);
}

TEST(PolygonCoverage, IsOneBelowACurveAboveTheWindow) {
    const Array2D coverage =
        coverage_below(curve_of({{-4.0, -7.0}, {1.3, -2.0}, {1.3, -9.0}, {9.0, -3.0}}), {0, 0, 6, 5});
    EXPECT_TRUE((coverage - 1.0).abs().maxCoeff() < 1e-14);
    EXPECT_EQ(coverage_below(curve_of({{-4.0, 7.0}, {1.3, 12.0}, {9.0, 6.0}}), {0, 0, 6, 5}).abs().maxCoeff(), 0.0);
}

TEST(SignedDistance, ToARoofIsTheDistanceToItsNearerSideOrRidge) {
    const auto curve = curve_of({{-30.0, 50.0}, {20.0, 0.0}, {70.0, 50.0}});
    const Array2D distance = signed_distance(curve, {0, 0, 41, 41}, 12.0);
    EXPECT_NEAR(distance(10, 20), -10.0 / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(distance(10, 5), 5.0 / std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(signed_distance(curve, {0, -10, 41, 41}, 12.0)(4, 21), std::hypot(6.0, 1.0), 1e-12);
    EXPECT_EQ(distance(40, 20), -12.0);
    EXPECT_EQ(distance(0, 0), 12.0);
}

TEST(Micrograph, EdgeLiesOnTheCurve) {
    // the sum of 1 − I down a column is the curve's mean depth over it: blur and an odd fringe leave it where it is
    const auto curve = curve_of({{-60.0, 40.0}, {160.0, 62.0}});
    auto options = exact(100, 100);
    options.blur = 1.3;
    options.fringe_amplitude = 0.3;
    const auto pixels = render_micrograph(curve, options);
    for (long column = 0; column < 100; ++column) {
        const double place = static_cast<double>((1.0f - pixels.col(column)).cast<double>().sum()) - 0.5;
        EXPECT_NEAR(place, 46.0 + 0.1 * static_cast<double>(column), 1e-3) << column;
    }
}

TEST(Micrograph, BlurHasTheRequestedStandardDeviation) {
    // the edge's profile is an error function of the blur and of one pixel's square: variances add
    auto options = exact(60, 60);
    options.blur = 2.0;
    const Array2D pixels = render_micrograph(curve_of({{-60.0, 29.5}, {160.0, 29.5}}), options).cast<double>();
    double mass = 0.0, mean = 0.0, square = 0.0;
    for (long row = 1; row < 60; ++row) {
        const double step = pixels(row, 30) - pixels(row - 1, 30), place = static_cast<double>(row) - 0.5;
        mass += step;
        mean += step * place;
        square += step * place * place;
    }
    EXPECT_NEAR(mass, 1.0, 1e-6);
    EXPECT_NEAR(mean, 29.5, 1e-5);
    EXPECT_NEAR(std::sqrt(square - mean * mean), 2.0, 1e-3);
}

TEST(Micrograph, FringeIsOddWithItsFirstLineAtTheFringeWidth) {
    auto options = exact(30, 80);
    options.fringe_amplitude = 0.4;
    options.fringe_width = 5.0;
    const auto curve = curve_of({{-60.0, 40.0}, {160.0, 40.0}});
    const Array2D fringe = (render_micrograph(curve, options) - render_micrograph(curve, exact(30, 80))).cast<double>();
    Index row = 0, column = 0;
    EXPECT_NEAR(fringe.maxCoeff(&row, &column), 0.4, 1e-6);
    EXPECT_EQ(row, 35);
    for (long d = 0; d < 30; ++d) EXPECT_NEAR(fringe(40 + d, 7), -fringe(40 - d, 7), 1e-6) << d;
}

TEST(Micrograph, NoiseHasTheRequestedStandardDeviationWithAndWithoutBlur) {
    for (const double blur : {0.0, 1.0}) {
        MicrographOptions options{.width = 300, .height = 300, .noise = 0.5, .noise_blur = blur, .key = {7, 0}};
        const auto curve = wave(150.0, 20.0, 90.0, 300.0);
        auto quiet = options;
        quiet.noise = 0.0;
        const Array2D noise = (render_micrograph(curve, options) - render_micrograph(curve, quiet)).cast<double>();
        // 90 000 numbers, a 4π of them to each independent one where blurred by 1 px: 0.24 % and 0.85 %
        EXPECT_NEAR(standard_deviation(noise), 0.5, blur > 0.0 ? 0.013 : 0.004) << blur;
        EXPECT_NEAR(noise.mean(), 0.0, blur > 0.0 ? 0.018 : 0.005) << blur;
        const double neighbours = (noise.leftCols(299) * noise.rightCols(299)).mean() / 0.25;
        EXPECT_NEAR(neighbours, blur > 0.0 ? std::exp(-0.25) : 0.0, 0.03) << blur;
    }
}

TEST(Micrograph, TextureAndLatticeLieInTheSampleOnly) {
    auto options = exact(240, 200);
    options.key = {3, 0};
    const auto curve = curve_of({{-60.0, 60.5}, {400.0, 60.5}});
    const Array2D bare = render_micrograph(curve, options).cast<double>();
    auto with_texture = options, with_lattice = options;
    with_texture.texture = 0.2;
    with_lattice.lattice_amplitude = 0.3;
    const Array2D texture = render_micrograph(curve, with_texture).cast<double>() - bare,
                  lattice = render_micrograph(curve, with_lattice).cast<double>() - bare;
    EXPECT_EQ(texture.topRows(61).abs().maxCoeff(), 0.0);
    EXPECT_EQ(lattice.topRows(61).abs().maxCoeff(), 0.0);
    // 139 × 240 pixels, 8π of them to an independent one: 2 %
    EXPECT_NEAR(standard_deviation(texture.bottomRows(139)), 0.2, 0.012);
    EXPECT_NEAR(standard_deviation(lattice.bottomRows(139)), 0.3 / std::sqrt(2.0), 0.01);
    // two pixels apart the texture's correlation is exp(−2²/(2·2²))
    const Array2D inside = texture.bottomRows(139);
    EXPECT_NEAR((inside.leftCols(238) * inside.rightCols(238)).mean() / 0.04, std::exp(-0.5), 0.08);
}

TEST(Micrograph, DriftRisesFromCornerToCorner) {
    auto options = exact(101, 101);
    options.drift = 0.4;
    const auto pixels = render_micrograph(curve_of({{-1.0, 300.0}, {200.0, 300.0}}), options);
    EXPECT_NEAR(pixels(0, 0), 0.0, 1e-7);
    EXPECT_NEAR(pixels(50, 50), 0.4, 1e-6);  // half of the rise and the parabola's height, half of the drift
    EXPECT_NEAR(pixels(100, 100), 0.4, 1e-6);
}

TEST(Micrograph, DependsOnTheKeyOnly) {
    const auto curve = wave(30.0, 6.0, 40.0, 64.0);
    MicrographOptions options{.width = 64, .height = 64, .lattice_amplitude = 0.2, .texture = 0.1, .key = {5, 2}};
    const auto first = render_micrograph(curve, options), again = render_micrograph(curve, options);
    EXPECT_TRUE((first == again).all());
    options.key.seed = 6;
    EXPECT_FALSE((render_micrograph(curve, options) == first).all());
}

TEST(Micrograph, RefusesInvalidOptions) {
    const auto curve = wave(30.0, 6.0, 40.0, 64.0);
    const MicrographOptions good{.width = 64, .height = 64};
    const auto refused = [&](auto change) {
        MicrographOptions options = good;
        change(options);
        EXPECT_THROW((void)render_micrograph(curve, options), InvalidArgument);
    };
    refused([](auto& o) { o.width = 0; });
    refused([](auto& o) { o.blur = -1.0; });
    refused([](auto& o) { o.noise = std::numeric_limits<double>::quiet_NaN(); });
    refused([](auto& o) { o.fringe_width = 0.0; });
    refused([](auto& o) { o.lattice_period = 0.0; });
    refused([](auto& o) { o.texture = -0.1; });
    refused([](auto& o) { o.width = 200; });  // the curve ends before
    EXPECT_THROW((void)render_micrograph(curve_of({{-1.0, 3.0}}), good), InvalidArgument);
    EXPECT_THROW(
        (void)render_micrograph(curve_of({{-1.0, 3.0}, {70.0, std::numeric_limits<double>::infinity()}}), good),
        InvalidArgument);
    // a loop that crosses itself
    EXPECT_THROW(
        (void)render_micrograph(curve_of({{-1.0, 30.0}, {40.0, 30.0}, {30.0, 10.0}, {20.0, 40.0}, {70.0, 35.0}}), good),
        InvalidArgument);
}

}  // namespace
}  // namespace setae::simulation::micrograph_test
