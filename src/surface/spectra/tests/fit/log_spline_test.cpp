// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectral_fit/log_spline.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::spectral_fit::log_spline_test {
namespace {

constexpr double lowest = 1e4, shortest = 1.5e10;

Eigen::VectorXd of_positions(const LogSpline& spline, double (*value)(double)) {
    return Eigen::VectorXd::NullaryExpr(spline.coefficients(),
                                        [&](Eigen::Index m) { return value(spline.position(m)); });
}

// Cubic B-splines sum to one and keep straight lines: coefficients on a line at their positions are that line.
TEST(LogSpline, ReproducesPowerLaws) {
    const LogSpline spline(lowest, shortest);
    const auto theta = of_positions(spline, [](double u) { return 2.0 - 3.6 * u; });
    for (const double q : {1e4, 3.3e6, 7e9, 1.5e10})
        EXPECT_NEAR(std::log(spline.value(theta, q)), 2.0 - 3.6 * std::log(q), 1e-10) << q;
}

TEST(LogSpline, IsZeroAboveAndConstantBelowItsRange) {
    const LogSpline spline(lowest, shortest);
    const auto theta = of_positions(spline, [](double u) { return -2.0 * u; });
    EXPECT_EQ(spline.value(theta, 1.001 * shortest), 0.0);
    EXPECT_GT(spline.value(theta, shortest), 0.0);
    EXPECT_EQ(spline.value(theta, 10.0), spline.value(theta, 1.0));
    EXPECT_LE(std::exp(spline.position(1)), lowest * (1.0 + 1e-12));
}

TEST(LogSpline, DesignMatrixGivesTheLogarithmOfTheValue) {
    const LogSpline spline(lowest, shortest);
    const auto theta = of_positions(spline, [](double u) { return std::sin(3.0 * u); });
    Array1D q(4);
    q << 1.3e4, 2e6, 5e8, 1.49e10;
    const Eigen::VectorXd log_values = spline.design(q) * theta;
    for (Index i = 0; i < q.size(); ++i) EXPECT_NEAR(log_values[i], std::log(spline.value(theta, q[i])), 1e-12);
}

TEST(LogSpline, RefusesInvalidRanges) {
    EXPECT_THROW(LogSpline(0.0, 1.0), InvalidArgument);
    EXPECT_THROW(LogSpline(2.0, 1.0), InvalidArgument);
}

}  // namespace
}  // namespace setae::spectral_fit::log_spline_test
