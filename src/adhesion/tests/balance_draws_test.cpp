// SPDX-License-Identifier: GPL-3.0-or-later
// Draws of everything a balance rests on against linear propagation, where that is exact and where it is not.
#include "setae/adhesion/balance_draws.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace setae::adhesion::balance_draws_test {
namespace {

constexpr double W = 0.04, gamma_1 = 0.025;

Components one(const std::string& name, double size) { return {{name, {Array1D::Constant(1, size)}}}; }

std::vector<PairPoint> pairs(double stored) {
    std::vector<PairPoint> list;
    for (int s = 0; s < 4; ++s)
        for (int e = 0; e < 3; ++e) {
            PairPoint p{.surface = "s" + std::to_string(s), .elastomer = "e" + std::to_string(e)};
            p.slope = 1.0 + 0.1 * s;
            p.offset = gamma_1 * (p.slope - 1.0) + stored * s * (e + 1);
            p.measured = {p.prediction(W), 0.001};
            p.measured_inputs = one("lens", 0.02 * p.measured.value);
            p.offset_inputs = one("gamma", 0.005 * (p.slope - 1.0));
            list.push_back(std::move(p));
        }
    return list;
}

// 20 000 draws know a standard deviation to 0.5 %
TEST(BalanceDraws, AgreeWithLinearPropagationWhereNothingIsFloored) {
    const auto list = pairs(0.001);
    const auto fit = fit_generalised(list, ModelScatter{});
    const auto draws = draw_balances(list, fit, list, 20000, 3);
    ASSERT_TRUE(draws.work_of_adhesion);
    EXPECT_NEAR(draws.work_of_adhesion->standard_error / fit.work_of_adhesion.standard_error(), 1.0, 0.02);
    EXPECT_FALSE(draws.work_of_adhesion->parts);
    for (const auto& prediction : draws.predictions) {
        EXPECT_NEAR(prediction.standard_error / prediction.linear_standard_error, 1.0, 0.02);
        EXPECT_FALSE(prediction.parts);
    }
}

// A balance at 0 ± s: half of the draws lie on the floor, and the other half is half a normal distribution,
// √(1/2 − 1/2π) s
TEST(BalanceDraws, PartWhereThePredictionIsFloored) {
    PairPoint line{.surface = "a", .elastomer = "b", .slope = 1.0, .offset = W};
    line.offset_inputs = one("modulus", 0.002);
    const GeneralisedFit given{.work_of_adhesion = W};
    const auto draws = draw_balances({}, given, {line}, 20000, 3);
    EXPECT_FALSE(draws.work_of_adhesion);
    const auto& floored = draws.predictions.front();
    EXPECT_TRUE(floored.parts);
    EXPECT_EQ(floored.interval.lower, 0.0);
    EXPECT_NEAR(floored.standard_error / 0.002, std::sqrt(0.5 - 0.5 / 3.141592653589793), 0.015);
    EXPECT_NEAR(floored.interval.upper / 0.002, 1.96, 0.04);
}

TEST(BalanceDraws, OfARectangularInputAreUniform) {
    PairPoint line{.surface = "a", .elastomer = "b", .slope = 1.0, .offset = 0.0};
    line.offset_inputs = TracedValue({0.0, 0.002, "rectangular"}, "radius").components;
    const auto draws = draw_balances({}, {.work_of_adhesion = W}, {line}, 20000, 3);
    const auto& value = draws.predictions.front();
    // 95 % of a uniform distribution are 0.95 · √3 standard deviations either way
    EXPECT_NEAR((value.interval.upper - W) / 0.002, 0.95 * std::sqrt(3.0), 0.02);
}

TEST(BalanceDraws, AreTheSameForASeed) {
    const auto list = pairs(0.001);
    const auto fit = fit_generalised(list);
    EXPECT_EQ(draw_balances(list, fit, list, 50, 3).predictions.back().standard_error,
              draw_balances(list, fit, list, 50, 3).predictions.back().standard_error);
    EXPECT_NE(draw_balances(list, fit, list, 50, 3).predictions.back().standard_error,
              draw_balances(list, fit, list, 50, 4).predictions.back().standard_error);
}

}  // namespace
}  // namespace setae::adhesion::balance_draws_test
