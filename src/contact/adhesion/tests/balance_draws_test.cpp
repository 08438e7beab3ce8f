// SPDX-License-Identifier: GPL-3.0-or-later
// Draws of everything a balance rests on against linear propagation, where that is exact and where it is not.
#include "setae/adhesion/balance_draws.hpp"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace setae::adhesion::balance_draws_test {
namespace {

constexpr double W = 0.04, gamma_1 = 0.025;

Components one(const std::string& name, double size) { return {{name, {Array1D::Constant(1, size)}}}; }

PairPoint line_at(double offset, Components inputs) {
    PairPoint line{.surface = "a", .elastomer = "b", .slope = 1.0, .offset = offset};
    line.offset_inputs = std::move(inputs);
    return line;
}

// 20 000 draws determine a standard deviation to 0.5 %; far above the floor variances add
TEST(BalanceDraws, AgreeWithLinearPropagationAboveTheFloor) {
    const TracedValue work{W, one("work", 0.003)};
    const auto draws = draw_balances(work, {}, {line_at(0.01, one("modulus", 0.004))}, 20000, 3);
    EXPECT_FALSE(draws.work_of_adhesion);
    EXPECT_NEAR(draws.predictions.front().standard_error / 0.005, 1.0, 0.015);
    EXPECT_NEAR((draws.predictions.front().interval.upper - (W - 0.01)) / 0.005, 1.96, 0.05);
}

// A balance at 0 ± s: half of the draws lie on the floor, and the other half is half a normal distribution,
// √(1/2 − 1/2π) s
TEST(BalanceDraws, AreLimitedAtTheFloor) {
    const auto draws = draw_balances(W, {}, {line_at(W, one("modulus", 0.002))}, 20000, 3);
    const auto& floored = draws.predictions.front();
    EXPECT_EQ(floored.interval.lower, 0.0);
    EXPECT_NEAR(floored.standard_error / 0.002, std::sqrt(0.5 - 0.5 / 3.141592653589793), 0.015);
    EXPECT_NEAR(floored.interval.upper / 0.002, 1.96, 0.04);
}

TEST(BalanceDraws, OfARectangularInputAreUniform) {
    const auto draws =
        draw_balances(W, {}, {line_at(0.0, TracedValue({0.0, 0.002, "rectangular"}, "radius").components)}, 20000, 3);
    // 95 % of a uniform distribution are 0.95 · √3 standard deviations either way
    EXPECT_NEAR((draws.predictions.front().interval.upper - W) / 0.002, 0.95 * std::sqrt(3.0), 0.02);
}

TEST(BalanceDraws, AreTheSameForASeed) {
    const std::vector<PairPoint> lines{line_at(0.01, one("modulus", 0.004))};
    const auto of_seed = [&](std::uint64_t seed) {
        return draw_balances(W, {}, lines, 50, seed).predictions.front().standard_error;
    };
    EXPECT_EQ(of_seed(3), of_seed(3));
    EXPECT_NE(of_seed(3), of_seed(4));
}

}  // namespace
}  // namespace setae::adhesion::balance_draws_test
