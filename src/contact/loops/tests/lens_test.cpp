// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pulls.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/lens_radius.hpp"
#include "setae/loops/rubber.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::lens_test {
namespace {

/// Points on an arc of a circle about (1, −2) mm.
struct Arc {
    Array1D x, y;
};
Arc arc(double radius, double half_angle, Index n) {
    const Array1D angle = Array1D::LinSpaced(n, -half_angle, half_angle);
    return {.x = 1e-3 + radius * angle.sin(), .y = -2e-3 + radius * angle.cos()};
}

TEST(CircleThrough, ThreePointsIsTheirCircle) {
    const Arc points = arc(1.25e-3, 0.4, 3);
    const Circle circle = circle_through(points.x, points.y);
    EXPECT_NEAR(circle.radius.value / 1.25e-3, 1.0, 1e-12);
    EXPECT_NEAR(circle.centre_x / 1e-3, 1.0, 1e-12);
    EXPECT_NEAR(circle.centre_y / -2e-3, 1.0, 1e-12);
}

TEST(CircleThrough, RefusesPointsOnALineAndOtherNumbersOfPoints) {
    EXPECT_THROW((void)circle_through(Array1D::LinSpaced(3, 0.0, 1.0), Array1D::LinSpaced(3, 0.0, 2.0)),
                 InvalidArgument);
    EXPECT_THROW((void)circle_through(Array1D::LinSpaced(4, 0.0, 1.0), Array1D::Zero(4)), InvalidArgument);
    EXPECT_THROW((void)circle_through(Array1D::Zero(3), Array1D::Zero(3)), InvalidArgument);
}

TEST(FitCircle, RecoversAnArc) {
    const Arc points = arc(1.25e-3, 0.3, 50);
    const Circle circle = fit_circle(points.x, points.y);
    EXPECT_NEAR(circle.radius.value / 1.25e-3, 1.0, 1e-11);
    EXPECT_LT(circle.rms_residual, 1e-14);
}

/// A conic of revolution, by its equation solved for z at each x.
Array1D conic_heights(const Array1D& x, double radius, double constant) {
    const double c = 1.0 / radius;
    // c r² − 2 s + (1 + κ) c s² = 0
    return x.unaryExpr([&](double r) {
        const double a = (1.0 + constant) * c;
        return a == 0.0 ? -0.5 * c * r * r : -(1.0 - std::sqrt(1.0 - a * c * r * r)) / a;
    });
}

TEST(FitConic, RecoversSpheresParaboloidsAndSpheroids) {
    const Array1D x = Array1D::LinSpaced(101, -0.5e-3, 0.6e-3);
    for (const double constant : {0.0, -1.0, -2.5, 1.5}) {
        const Array1D z = conic_heights(x, 1.25e-3, constant);
        for (const double side : {1.0, -1.0}) {
            const Conic conic = fit_conic(2e-3 + x, 7e-3 + side * z);
            EXPECT_NEAR(conic.radius.value / 1.25e-3, 1.0, 1e-8) << constant;
            EXPECT_NEAR(conic.conic_constant.value, constant, 1e-6);
            EXPECT_NEAR(conic.apex_x / 2e-3, 1.0, 1e-8);
            EXPECT_NEAR(conic.apex_z / 7e-3, 1.0, 1e-8);
            // κ r⁴/8R³ and what follows it
            const Array1D edge = Array1D::Constant(1, 0.6e-3);
            EXPECT_NEAR(conic.departure,
                        side * (conic_heights(edge, 1.25e-3, constant) - conic_heights(edge, 1.25e-3, 0.0))[0], 1e-10);
        }
    }
}

TEST(FitConic, DistinguishesSpheresFromOtherLenses) {
    const Array1D x = Array1D::LinSpaced(200, -0.45e-3, 0.45e-3);
    int found = 0, false_alarms = 0, held = 0;
    constexpr int seeds = 100;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 engine(static_cast<unsigned>(seed));
        std::normal_distribution<double> noise(0.0, 0.2e-6);
        const auto measured = [&](double constant) -> Array1D {
            return conic_heights(x, 1.25e-3, constant) + x.unaryExpr([&](double) { return noise(engine); });
        };
        found += fit_conic(x, measured(-0.5)).probability < 0.01 ? 1 : 0;
        const auto sphere = fit_conic(x, measured(0.0));
        false_alarms += sphere.probability < 0.05 ? 1 : 0;
        const auto interval = *interval_of(sphere.radius);
        held += interval.lower <= 1.25e-3 && 1.25e-3 <= interval.upper ? 1 : 0;
    }
    EXPECT_EQ(found, seeds);
    EXPECT_LE(false_alarms, 12);
    EXPECT_GE(held, 88);
    EXPECT_LE(held, 99);
}

TEST(FitConic, RefusesPointsWithoutAnApex) {
    const Array1D flank = Array1D::LinSpaced(40, 0.3e-3, 0.6e-3);
    EXPECT_THROW((void)fit_conic(flank, conic_heights(flank, 1.25e-3, 0.0)), UndefinedDataError);
    EXPECT_THROW((void)fit_conic(flank.head(5), flank.head(5).square()), UndefinedDataError);
}

TEST(FitCircle, CoversTheTrueRadiusWithItsStandardError) {
    const Arc points = arc(1.25e-3, 0.5, 60);
    int covered = 0;
    setae::tests::Pulls pulls;
    constexpr int seeds = 200;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        const Array1D x = tests::with_noise(points.x, 2e-6, generator);
        const Circle circle = fit_circle(x, tests::with_noise(points.y, 2e-6, generator));
        covered += std::abs(circle.radius.value - 1.25e-3) < 2.0 * circle.radius.standard_error;
        pulls.add(circle.radius, 1.25e-3);
    }
    // 95 % ± 3 binomial standard deviations
    EXPECT_GE(covered, 181);
    expect_honest(pulls);
}

TEST(FitCircle, RefusesTooFewOrUndefinedPoints) {
    EXPECT_THROW((void)fit_circle(Array1D::LinSpaced(3, 0.0, 1.0), Array1D::Zero(3)), UndefinedDataError);
    EXPECT_THROW((void)fit_circle(Array1D::LinSpaced(5, 0.0, 1.0), Array1D::Zero(4)), InvalidArgument);
    EXPECT_THROW((void)fit_circle(Array1D::LinSpaced(5, 0.0, 1.0), Array1D::Constant(5, undefined)), InvalidArgument);
    EXPECT_THROW((void)fit_circle(Array1D::LinSpaced(5, 0.0, 1.0), Array1D::Zero(5)), InvalidArgument);
}

TEST(RubberModulus, IsDensityTimesGasConstantTimesTemperatureOverMolarMass) {
    // 970 · 8.314463 · 298.15 / 6 = 400 764.7 Pa
    EXPECT_NEAR(rubber_modulus(970.0, 298.15, 6.0), 400764.7, 0.1);
    EXPECT_THROW((void)rubber_modulus(970.0, 298.15, 0.0), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::lens_test
