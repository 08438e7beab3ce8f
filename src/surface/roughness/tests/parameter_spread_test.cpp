// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/statistics.hpp"
#include "setae/roughness/parameter_spread.hpp"

namespace setae::roughness::parameter_spread_test {
namespace {

SpectralParameters of_height(double height) { return {.rms_height = height}; }
double height(const SpectralParameters& p) { return p.rms_height; }

TEST(ParameterSpread, IntervalIsStudentTOfJackknifedLogarithms) {
    ParameterSpread spread;
    spread.left_out = {{of_height(std::exp(0.1)), of_height(std::exp(-0.1))}};
    const auto estimate = spread.estimate(1.0, height);
    // delete-one variance ½ (0.1² + 0.1²), one degree of freedom: t = tan(0.475 π)
    const double reach = std::tan(0.475 * pi) * 0.1;
    ASSERT_TRUE(estimate.interval);
    EXPECT_NEAR(std::log(estimate.interval->upper), reach, 1e-12);
    EXPECT_NEAR(std::log(estimate.interval->lower), -reach, 1e-12);
    EXPECT_NEAR(*estimate.degrees_of_freedom, 1.0, 1e-12);
    EXPECT_EQ(estimate.method, "jackknife t on ln");
}

TEST(ParameterSpread, AddsTheGivenUncertaintiesToTheInterval) {
    ParameterSpread spread;
    spread.sources = {{"tip radius", of_height(std::exp(0.3)), of_height(std::exp(-0.3))}};
    const auto alone = spread.estimate(1.0, height);
    EXPECT_NEAR(std::log(alone.interval->upper), 0.3 * normal_quantile(0.975), 1e-12);
    EXPECT_FALSE(alone.degrees_of_freedom);
    EXPECT_EQ(alone.method, "delta on ln");
    spread.left_out = {{of_height(std::exp(0.1)), of_height(std::exp(-0.1))}};
    const auto both = spread.estimate(1.0, height);
    // v = 0.01 + 0.09, ν = 0.1²/0.01² = 100
    EXPECT_NEAR(*both.degrees_of_freedom, 100.0, 1e-9);
    EXPECT_NEAR(std::log(both.interval->upper), student_t_quantile(0.975, 100.0) * std::sqrt(0.1), 1e-9);
}

TEST(ParameterSpread, KeepsAreaRatiosAboveOne) {
    ParameterSpread spread;
    spread.left_out = {{of_height(1.001), of_height(1.2), of_height(1.01)}};
    const auto estimate = spread.estimate(1.02, height, 1.0);
    ASSERT_TRUE(estimate.interval);
    EXPECT_GT(estimate.interval->lower, 1.0);
    EXPECT_NEAR((estimate.interval->lower - 1.0) * (estimate.interval->upper - 1.0), 0.02 * 0.02, 1e-12);
}

TEST(ParameterSpread, CombinesDegreesOfFreedomOfStrata) {
    ParameterSpread spread;
    spread.left_out = {{of_height(1.0), of_height(1.2), of_height(1.4)}, {of_height(1.1), of_height(1.1)}};
    const auto term = spread.variance_term(height);
    EXPECT_NEAR(term.variance, 2.0 / 3.0 * 0.08, 1e-12);
    EXPECT_NEAR(term.degrees_of_freedom, 2.0, 1e-12);  // the second stratum adds nothing
    EXPECT_EQ(ParameterSpread{}.variance_term(height).variance, 0.0);
    EXPECT_TRUE(std::isinf(ParameterSpread{}.variance_term(height).degrees_of_freedom));
}

// ± and interval of one number have the same scatter: SE of f is s of ln f times f, to first order.
TEST(ParameterSpread, StandardErrorIsConsistentWithTheInterval) {
    ParameterSpread spread;
    spread.replicas = {of_height(1.0), of_height(3.0)};  // not used together with the jackknife
    spread.left_out = {{of_height(1.001), of_height(1.003), of_height(0.998)}};
    spread.sources = {{"tip radius", of_height(1.002), of_height(0.998)}};
    const auto estimate = spread.estimate(1.0, height);
    const double half_width = 0.5 * std::log(estimate.interval->upper / estimate.interval->lower);
    EXPECT_NEAR(half_width / (student_t_quantile(0.975, *estimate.degrees_of_freedom) * estimate.standard_error), 1.0,
                2e-3);
    EXPECT_FALSE(estimate.seed) << "no random numbers behind it";
    EXPECT_NEAR(std::pow(estimate.standard_error, 2), spread.covariance(height, height), 1e-18);
}

TEST(ParameterSpread, CovarianceWithItselfIsTheVariance) {
    ParameterSpread spread;
    spread.left_out = {{of_height(1.0), of_height(1.2), of_height(1.4)},
                       {of_height(0.9)}};  // a single one has no scatter
    const auto twice = [](const SpectralParameters& p) { return 2.0 * p.rms_height; };
    EXPECT_NEAR(spread.covariance(height, twice), 2.0 * 2.0 / 3.0 * 0.08, 1e-12);
}

TEST(ParameterSpread, UsesReplicasWithoutStrata) {
    ParameterSpread spread;
    spread.seed = 7;
    spread.replicas = {of_height(std::exp(0.1)), of_height(std::exp(-0.1))};
    const auto estimate = spread.estimate(1.0, height);
    EXPECT_EQ(estimate.method, "bootstrap on ln");
    EXPECT_EQ(estimate.seed, 7u);
    EXPECT_NEAR(std::log(estimate.interval->upper), normal_quantile(0.975) * std::sqrt(0.02), 1e-12);
    spread.replicas_are_draws = true;
    EXPECT_EQ(spread.estimate(1.0, height).method, "likelihood");
}

// Draws of variance 0.1² + 0.1² over one degree of freedom, an input of 0.3: each is included once.
TEST(ParameterSpread, AddsVariancesOfInputsAndDraws) {
    ParameterSpread spread;
    spread.replicas = {of_height(1.1), of_height(0.9)};
    spread.replicas_are_draws = true;
    spread.sources = {{"afm tip", of_height(1.3), of_height(0.7)}};
    EXPECT_NEAR(spread.covariance(height, height), 0.02 + 0.09, 1e-12);
    EXPECT_NEAR(spread.variance_term(height).variance, 0.02 + 0.09, 1e-12);
    EXPECT_NEAR(spread.standard_error(height), std::sqrt(0.11), 1e-12);
    EXPECT_EQ(spread.estimate(1.0, height).method, "likelihood");
}

TEST(ParameterSpread, HasNoIntervalWithoutReplicas) {
    EXPECT_FALSE(ParameterSpread{}.estimate(1.0, height).interval);
    ParameterSpread spread;
    spread.left_out = {{of_height(0.9), of_height(1.2)}};  // 0.9 is no area ratio
    const auto estimate = spread.estimate(1.1, height, 1.0);
    EXPECT_FALSE(estimate.interval);
    EXPECT_EQ(estimate.method, "jackknife t");
    EXPECT_NEAR(estimate.standard_error, 0.15, 1e-12);  // half of Σ 0.15²
}

}  // namespace
}  // namespace setae::roughness::parameter_spread_test
