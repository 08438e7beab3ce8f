// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "bootstrap_intervals.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/resampling.hpp"
#include "setae/core/sample_mean.hpp"
#include "setae/core/statistics.hpp"

namespace setae::statistics_test {
namespace {

TEST(FExceedance, MatchesClosedForms) {
    // 2 and n degrees of freedom: (1 + 2x/n)^(−n/2); 1 and n: the two tails of Student's t
    EXPECT_NEAR(f_exceedance(3.0, 2.0, 10.0), std::pow(1.6, -5.0), 1e-14);
    const double t = student_t_quantile(0.975, 7.0);
    EXPECT_NEAR(f_exceedance(t * t, 1.0, 7.0), 0.05, 1e-12);
    EXPECT_EQ(f_exceedance(0.0, 3.0, 4.0), 1.0);
    EXPECT_THROW((void)f_exceedance(-1.0, 3.0, 4.0), InvalidArgument);
}

TEST(SampleMean, HasTheStandardErrorOfItsScatter) {
    // of 1, 2, 3, 4: 5/2 ± √(5/12)
    const auto mean = sample_mean(Array1D::LinSpaced(4, 1.0, 4.0), "samples");
    EXPECT_DOUBLE_EQ(mean.value, 2.5);
    EXPECT_DOUBLE_EQ(mean.standard_error, std::sqrt(5.0 / 12.0));
    EXPECT_EQ(mean.degrees_of_freedom, 3.0);
    EXPECT_EQ(mean.method, "samples");
    const auto alone = sample_mean(Array1D::Constant(1, 7.0), "samples");
    EXPECT_EQ(alone.value, 7.0);
    EXPECT_FALSE(alone.uncertain());
    EXPECT_FALSE(alone.degrees_of_freedom);
}

TEST(StudentTQuantile, MatchesClosedForms) {
    // one degree of freedom: tan(π(p − ½)); two: (2p − 1)/√(2p(1 − p)); Abramowitz & Stegun 26.7
    for (const double p : {0.6, 0.9, 0.975, 0.999}) {
        EXPECT_NEAR(student_t_quantile(p, 1.0) / std::tan(pi * (p - 0.5)), 1.0, 1e-12) << p;
        EXPECT_NEAR(student_t_quantile(p, 2.0) / ((2.0 * p - 1.0) / std::sqrt(2.0 * p * (1.0 - p))), 1.0, 1e-12) << p;
        EXPECT_NEAR(student_t_quantile(1.0 - p, 5.0), -student_t_quantile(p, 5.0), 1e-12) << p;
    }
    EXPECT_NEAR(student_t_quantile(0.975, 15.0), 2.131, 5e-4);  // printed tables
    EXPECT_NEAR(student_t_quantile(0.975, std::numeric_limits<double>::infinity()), 1.959964, 5e-7);
    EXPECT_THROW((void)student_t_quantile(1.0, 3.0), InvalidArgument);
    EXPECT_THROW((void)student_t_quantile(0.5, 0.0), InvalidArgument);
}

TEST(NormalProbability, InvertsTheQuantile) {
    for (const double p : {0.001, 0.3, 0.5, 0.975}) EXPECT_NEAR(normal_probability(normal_quantile(p)), p, 1e-14);
}

TEST(ChiSquaredExceedance, MatchesClosedForms) {
    EXPECT_NEAR(chi_squared_exceedance(3.0, 2.0), std::exp(-1.5), 1e-14);
    EXPECT_NEAR(chi_squared_exceedance(1.96 * 1.96, 1.0), 2.0 * normal_probability(-1.96), 1e-14);
    EXPECT_EQ(chi_squared_exceedance(0.0, 3.0), 1.0);
    EXPECT_EQ(chi_squared_exceedance(std::numeric_limits<double>::infinity(), 3.0), 0.0);
    EXPECT_THROW((void)chi_squared_exceedance(-1.0, 3.0), InvalidArgument);
    EXPECT_THROW((void)chi_squared_exceedance(1.0, 0.0), InvalidArgument);
}

TEST(Satterthwaite, AddsDegreesOfFreedomOfEqualTerms) {
    EXPECT_NEAR(satterthwaite_degrees_of_freedom(std::array{VarianceTerm{2.0, 4.0}, VarianceTerm{2.0, 4.0}}), 8.0,
                1e-12);
    EXPECT_NEAR(satterthwaite_degrees_of_freedom(std::array{VarianceTerm{1.0, 3.0}, VarianceTerm{1.0}}), 12.0, 1e-12);
    EXPECT_TRUE(std::isinf(satterthwaite_degrees_of_freedom(std::array{VarianceTerm{1.0}})));
}

TEST(SortedQuantile, InterpolatesLinearly) {
    const std::array numbers{1.0, 2.0, 4.0};
    EXPECT_EQ(sorted_quantile(numbers, 0.0), 1.0);
    EXPECT_EQ(sorted_quantile(numbers, 0.75), 3.0);
    EXPECT_EQ(sorted_quantile(numbers, 1.0), 4.0);
}

TEST(Propagated, FullContactBalanceMatchesTwentyThousandDraws) {
    // W_app = W_int r − γ1 (r − 1) − E u with the published ± of a polished surface on a soft elastomer, r, u exact
    constexpr double ratio = 1.07125, energy = 0.177e-9;
    const auto balance = [](const Array1D& x) { return x[0] * ratio - x[1] * (ratio - 1.0) - x[2] * energy; };
    const std::array inputs{Estimate{0.0370, 0.0037, "given"}, Estimate{0.025, 0.005, "given"},
                            Estimate{13.37e6, 1.17e6, "given"}};
    const auto linear = propagated(balance, inputs);
    const double exact =
        std::sqrt(std::pow(ratio * 0.0037, 2) + std::pow((ratio - 1.0) * 0.005, 2) + std::pow(energy * 1.17e6, 2));
    EXPECT_NEAR(linear.standard_error / exact, 1.0, 1e-9);
    EXPECT_EQ(linear.method, "delta");
    std::mt19937_64 engine(5);
    std::normal_distribution<double> normal;
    constexpr int draws = 20000;
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < draws; ++i) {
        Array1D x(3);
        for (std::size_t k = 0; k < 3; ++k)
            x[static_cast<Index>(k)] = inputs[k].value + inputs[k].standard_error * normal(engine);
        const double difference = balance(x) - linear.value;
        sum += difference;
        squares += difference * difference;
    }
    const double deviation = std::sqrt(squares / draws);
    // the mean of 20000 draws scatters by σ/141, the standard deviation by σ/200; four of each
    EXPECT_NEAR(sum / draws, 0.0, 4.0 * exact / std::sqrt(draws));
    EXPECT_NEAR(deviation / linear.standard_error, 1.0, 4.0 / std::sqrt(2.0 * draws));
}

TEST(Propagated, UsesTheCovarianceOfAFit) {
    // slope and intercept of a line, fully anticorrelated: at x = 2 they cancel
    Array2D covariance(2, 2);
    covariance << 1.0, -2.0, -2.0, 4.0;
    const Array1D line = (Array1D(2) << 3.0, 1.0).finished();
    EXPECT_NEAR(propagated([](const Array1D& p) { return 2.0 * p[0] + p[1]; }, line, covariance).standard_error, 0.0,
                1e-7);
    EXPECT_NEAR(propagated([](const Array1D& p) { return p[1]; }, line, covariance).standard_error, 2.0, 1e-9);
    EXPECT_THROW((void)propagated([](const Array1D& p) { return p[0]; }, line, Array2D::Zero(1, 1)), InvalidArgument);
}

TEST(JackknifeEstimate, OfAMeanHasTheStandardErrorOfTheMean) {
    // values 1, 2, 4, 9 without each: (16 − v)/3; s²/n = 38/3/4
    const std::vector<LeaveOneOut> strata{{5.0, 14.0 / 3.0, 4.0, 7.0 / 3.0}};
    const auto estimate = jackknife_estimate(4.0, strata);
    EXPECT_NEAR(estimate.standard_error, std::sqrt(38.0 / 12.0), 1e-12);
    EXPECT_NEAR(*estimate.degrees_of_freedom, 3.0, 1e-12);
    EXPECT_NEAR(estimate.interval->upper - 4.0, student_t_quantile(0.975, 3.0) * estimate.standard_error, 1e-12);
    EXPECT_TRUE(std::isnan(jackknife_estimate(4.0, std::vector<LeaveOneOut>{{1.0}}).standard_error));
}

TEST(BcaInterval, OfSymmetricReplicasEqualsThePercentileInterval) {
    std::vector<double> replicas;
    for (int i = -500; i < 500; ++i) replicas.push_back(i + 0.5);
    const std::vector<LeaveOneOut> symmetric{{-1.0, 0.0, 1.0}};
    const auto bca = tests::bca_interval(0.0, replicas, symmetric), percentile = percentile_interval(replicas);
    EXPECT_NEAR(bca.lower, percentile.lower, 1e-9);
    EXPECT_NEAR(bca.upper, percentile.upper, 1e-9);
    // members whose absence lowers the value more than others raise it: influence is skewed upwards, and so is the
    // interval
    const auto skewed = tests::bca_interval(0.0, replicas, std::vector<LeaveOneOut>{{-2.0, 1.0, 1.0}});
    EXPECT_GT(skewed.upper, bca.upper);
    EXPECT_GT(skewed.lower, bca.lower);
    EXPECT_THROW((void)percentile_interval({1.0}), InvalidArgument);
}

TEST(BootstrapTInterval, ReversesTheStudentisedQuantiles) {
    const std::vector<double> replicas{0.0, 1.0, 2.0, 5.0}, errors{1.0, 1.0, 1.0, 1.0};
    // studentised −1, 0, 1, 4 about 1 with SE 2: from 1 − 2·4 to 1 + 2·1
    const auto interval = tests::bootstrap_t_interval({1.0, 2.0}, replicas, errors, 1.0 - 1e-12);
    EXPECT_NEAR(interval.lower, -7.0, 1e-6);
    EXPECT_NEAR(interval.upper, 3.0, 1e-6);
    EXPECT_THROW((void)tests::bootstrap_t_interval({1.0, 2.0}, replicas, {}, 0.95), InvalidArgument);
}

TEST(Estimate, IntervalUsesDegreesOfFreedom) {
    EXPECT_FALSE(interval_of({1.0}));
    EXPECT_NEAR(interval_of({1.0, 2.0})->upper, 1.0 + 2.0 * 1.959964, 1e-6);
    Estimate few{1.0, 2.0};
    few.degrees_of_freedom = 1.0;
    EXPECT_NEAR(interval_of(few)->lower, 1.0 - 2.0 * std::tan(0.475 * pi), 1e-9);
    EXPECT_NEAR(interval_of(scaled(few, -3.0))->lower, -3.0 - 6.0 * std::tan(0.475 * pi), 1e-9);
}

TEST(Difference, AddsVariancesAndKeepsUnknownErrorsUnknown) {
    EXPECT_NEAR(difference({5.0, 3.0}, {1.0, 4.0}).standard_error, 5.0, 1e-12);
    EXPECT_EQ(difference({5.0, 3.0}, {1.0, 4.0}).value, 4.0);
    EXPECT_TRUE(std::isnan(difference({5.0, 3.0}, {1.0}).standard_error));
}

}  // namespace
}  // namespace setae::statistics_test
