// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "contours/edge_band.hpp"
#include "contours/edge_shape.hpp"
#include "contours/live_wire.hpp"
#include "contours/phase_cut.hpp"
#include "contours/plane_curve.hpp"
#include "rendered_edge.hpp"

namespace setae::imaging::edge_parts_test {
namespace {

constexpr double pi = 3.14159265358979323846;

PlaneCurve circle(double radius, Index points) {
    PlaneCurve curve{Array1D(points), Array1D(points), true};
    for (Index i = 0; i < points; ++i) {
        const double t = 2 * pi * static_cast<double>(i) / static_cast<double>(points);
        curve.x[i] = 100 + radius * std::cos(t);
        curve.y[i] = 100 + radius * std::sin(t);
    }
    return curve;
}

TEST(PlaneCurve, IsResampledOnACubicToFourthOrder) {
    // the polygon of a circle deviates by step²/(8 R), the cubic by far less
    double coarse = 0, fine = 0;
    for (const Index points : {40, 80}) {
        const auto curve = resampled(circle(30, points), 1.0, true);
        double most = 0;
        for (Index i = 0; i < curve.size(); ++i)
            most = std::max(most, std::abs(std::hypot(curve.x[i] - 100, curve.y[i] - 100) - 30));
        (points == 40 ? coarse : fine) = most;
    }
    EXPECT_LT(coarse, 0.01);
    EXPECT_GT(coarse / fine, 10);
}

TEST(PlaneCurve, KeepsItsEndsWhenSmoothedOrResampled) {
    PlaneCurve curve{Array1D::LinSpaced(50, 0, 60), Array1D::LinSpaced(50, 3, 20).square(), false};
    for (const auto& changed : {smoothed(curve, 3.0), resampled(curve, 1.0, true), resampled(curve, 1.0, false)}) {
        EXPECT_NEAR(changed.x[0], curve.x[0], 1e-9);
        EXPECT_NEAR(changed.y[changed.size() - 1], curve.y[49], 1e-9);
    }
    const auto straight = smoothed({Array1D::LinSpaced(50, 0, 60), Array1D::LinSpaced(50, 5, 9), false}, 3.0);
    EXPECT_NEAR(straight.y[25], 5 + 4.0 * 25 / 49, 1e-12);
}

TEST(PlaneCurve, HasNormalsToTheLeftInThePicture) {
    const PlaneCurve right{Array1D::LinSpaced(3, 0, 2), Array1D::Zero(3), false};
    EXPECT_DOUBLE_EQ(normals(right).y[1], -1);  // up the screen
}

TEST(EdgeBand, GivesPositionAndDistanceOfEachPixel) {
    const FramePixels pixels = FramePixels::Zero(40, 50);
    PixelMask hidden = PixelMask::Zero(40, 50);
    hidden(18, 20) = 1;
    EdgeBand band(pixels, hidden);
    const PlaneCurve line{Array1D::LinSpaced(41, 5, 45), Array1D::Constant(41, 19.25), false};
    const auto found = band.near(line, 3.0);
    EXPECT_EQ(found.size(), 41U * 6U - 1U);  // rows 17 … 22, columns 5 … 45, one hidden
    for (const auto& p : found) {
        const double above = p.distance - 0.25;
        EXPECT_NEAR(above, std::round(above), 1e-12);
    }
    EXPECT_EQ(band.near(line, 3.0).size(), found.size());
}

TEST(EdgeShape, IsRecoveredFromTheEdgeProfile) {
    const tests::EdgePicture picture{.blur = 1.1, .noise = 10, .fringe = 0.3, .fringe_width = 4};
    const auto edge = [](double x, double y) { return 100.3 + 0.1 * x - y; };
    const auto pixels = tests::rendered(picture, [&](double x, double y) { return edge(x, y) / std::hypot(1, 0.1); });
    const PixelMask hidden = PixelMask::Zero(pixels.rows(), pixels.cols());
    EdgeBand band(pixels, hidden);
    PlaneCurve line{Array1D::LinSpaced(250, 2, 250), Array1D(250), false};
    line.y = 100.3 + 0.1 * line.x + 2.0;  // 2 px into the sample
    const auto shape = fitted_shape(edge_profile(band.near(line, 12.0), 12.0));
    EXPECT_NEAR(shape.place, 2.0 / std::hypot(1, 0.1), 0.05);
    EXPECT_NEAR(shape.width, 1.1, 0.1);
    EXPECT_NEAR(shape.step, 100, 5);
    EXPECT_NEAR(shape.fringe, 30, 5);
    EXPECT_NEAR(shape.fringe_width, 4, 0.6);
}

TEST(EdgeShape, SlopeIsTheDerivativeOfTheValue) {
    const EdgeShape shape{.step = 3, .width = 1.3, .fringe = -0.8, .fringe_width = 2.4};
    for (const double d : {-3.0, -0.4, 0.0, 1.7})
        EXPECT_NEAR(shape.slope(d), (shape.value(d + 1e-5) - shape.value(d - 1e-5)) / 2e-5, 1e-8);
}

TEST(EdgeShape, OfAPlainStepHasNoFringe) {
    const auto pixels = tests::rendered({.noise = 20}, [](double, double y) { return 100.4 - y; });
    const PixelMask hidden = PixelMask::Zero(pixels.rows(), pixels.cols());
    EdgeBand band(pixels, hidden);
    const PlaneCurve line{Array1D::LinSpaced(250, 2, 250), Array1D::Constant(250, 100.0), false};
    EXPECT_EQ(fitted_shape(edge_profile(band.near(line, 10.0), 10.0)).fringe, 0.0);
}

TEST(PhaseCut, IsTheDivisionOfMinimumEnergy) {
    // all 2^12 divisions of a 3 × 4 grid, by the same energy with the weights of sides π/8 · 2 and of diagonals π/(8√2)
    CellMap wish(3, 4);
    wish << 1, -2, 0.3, 1.5, -0.7, 0.9, -1.1, 0.2, 2, -0.4, -1.3, 0.6;
    const double cost = 0.8, side = cost * pi / 4, diagonal = cost * pi / (8 * std::sqrt(2.0));
    const auto energy = [&](const PixelMask& labels) {
        double sum = 0;
        for (long r = 0; r < 3; ++r)
            for (long c = 0; c < 4; ++c) {
                if (labels(r, c) == 1) sum += wish(r, c);
                if (c + 1 < 4 && labels(r, c) != labels(r, c + 1)) sum += side;
                if (r + 1 < 3 && labels(r, c) != labels(r + 1, c)) sum += side;
                if (r + 1 < 3 && c + 1 < 4 && labels(r, c) != labels(r + 1, c + 1)) sum += diagonal;
                if (r + 1 < 3 && c > 0 && labels(r, c) != labels(r + 1, c - 1)) sum += diagonal;
            }
        return sum;
    };
    double least = 1e300;
    for (int bits = 0; bits < 1 << 12; ++bits) {
        PixelMask labels(3, 4);
        for (long i = 0; i < 12; ++i) labels.data()[i] = static_cast<std::uint8_t>((bits >> i) & 1);
        least = std::min(least, energy(labels));
    }
    EXPECT_NEAR(energy(minimum_cut(wish, cost, PixelMask::Ones(3, 4), PixelMask::Zero(3, 4))), least, 1e-12);
}

TEST(PhaseCut, WithoutFreePixelsIsUnchanged) {
    const PixelMask labels = PixelMask::Ones(4, 5);
    EXPECT_TRUE((minimum_cut(CellMap::Zero(4, 5), 1.0, PixelMask::Zero(4, 5), labels) == labels).all());
}

TEST(PhaseCut, DoesNotChangeFixedPixels) {
    PixelMask labels = PixelMask::Zero(3, 9);
    labels.rightCols(4) = 1;
    PixelMask free = PixelMask::Zero(3, 9);
    free.middleCols(3, 3) = 1;
    const auto cut = minimum_cut(CellMap::Constant(3, 9, 100.0), 1.0, free, labels);  // all prefer vacuum
    EXPECT_TRUE((cut.rightCols(3) == 1).all());
    EXPECT_TRUE((cut.leftCols(6) == 0).all());
}

TEST(LiveWire, FollowsTheEdgeBetweenAnchors) {
    const tests::Wave wave;
    const auto pixels = tests::rendered({.noise = 30}, wave);
    const auto path = LiveWire(pixels, Vacuum::bright).through({{20, wave.height(20)}, {230, wave.height(230)}});
    double most = 0;
    for (Index i = 0; i < path.size(); ++i) most = std::max(most, std::abs(wave(path.x[i], path.y[i])));
    EXPECT_LT(most, 4);
    EXPECT_DOUBLE_EQ(path.x[0], 20);
    EXPECT_DOUBLE_EQ(path.x[path.size() - 1], 230);
}

}  // namespace
}  // namespace setae::imaging::edge_parts_test
