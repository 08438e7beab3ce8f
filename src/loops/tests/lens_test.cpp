// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

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

TEST(FitCircle, CoversTheTruthWithItsStandardError) {
    const Arc points = arc(1.25e-3, 0.5, 60);
    int covered = 0;
    constexpr int seeds = 200;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        const Array1D x = tests::with_noise(points.x, 2e-6, generator);
        const Circle circle = fit_circle(x, tests::with_noise(points.y, 2e-6, generator));
        covered += std::abs(circle.radius.value - 1.25e-3) < 2.0 * circle.radius.standard_error;
    }
    // 95 % ± 3 binomial standard deviations
    EXPECT_GE(covered, 181);
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
