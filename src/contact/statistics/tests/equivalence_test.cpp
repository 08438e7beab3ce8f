// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/statistics/equivalence.hpp"

namespace setae::statistics::equivalence_test {

TEST(Equivalence, IsShownIfTheIntervalIsWithinTheMargin) {
    // t at 10 degrees of freedom: 1.812461 leaves 5 % above it
    const Estimate difference{.value = 2.0, .standard_error = 1.0, .degrees_of_freedom = 10.0};
    const auto at_the_edge = test_equivalence(difference, 3.812461);
    EXPECT_NEAR(at_the_edge.probability, 0.05, 1e-6);
    EXPECT_NEAR(at_the_edge.interval->upper, 3.812461, 1e-5);
    EXPECT_DOUBLE_EQ(at_the_edge.interval->level, 0.9);
    EXPECT_EQ(test_equivalence(difference, 3.82).verdict, Verdict::equivalent);
    EXPECT_EQ(test_equivalence(difference, 3.80).verdict, Verdict::undecided);
    EXPECT_EQ(test_equivalence(difference, 0.1).verdict, Verdict::different);
    EXPECT_EQ(test_equivalence({.value = -2.0, .standard_error = 1.0, .degrees_of_freedom = 10.0}, 3.82).verdict,
              Verdict::equivalent);
}

TEST(Equivalence, OfTableS3IsUndecidedOnTheStiffestElastomerOnly) {
    // [D19] Table S3: W of retraction less W of approach on smooth silicon, in mJ/m²
    const auto verdict = [](double approach, double its_error, double retraction, double error) {
        return test_equivalence(difference({.value = retraction, .standard_error = error},
                                           {.value = approach, .standard_error = its_error}),
                                5.0)
            .verdict;
    };
    EXPECT_EQ(verdict(39.6, 1.2, 59.3, 1.0), Verdict::different);
    EXPECT_EQ(verdict(36.8, 0.8, 52.5, 4.8), Verdict::different);
    EXPECT_EQ(verdict(38.8, 2.9, 52.2, 1.3), Verdict::different);
    EXPECT_EQ(verdict(51.0, 4.8, 56.4, 1.8), Verdict::undecided);
}

TEST(Equivalence, HasTheStatedFalsePositiveRateAtTheMargin) {
    std::mt19937_64 engine(11);
    std::normal_distribution<double> normal;
    int shown = 0;
    constexpr int trials = 4000, n = 6;
    for (int trial = 0; trial < trials; ++trial) {
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < n; ++i) {
            const double x = 3.0 + normal(engine);
            sum += x;
            squares += x * x;
        }
        const double mean = sum / n, variance = (squares - n * mean * mean) / (n - 1);
        const Estimate difference{
            .value = mean, .standard_error = std::sqrt(variance / n), .degrees_of_freedom = n - 1.0};
        shown += test_equivalence(difference, 3.0).verdict == Verdict::equivalent ? 1 : 0;
    }
    EXPECT_NEAR(shown / double{trials}, 0.05, 0.012);
}

TEST(Equivalence, WithoutAnErrorIsUndecided) {
    const auto test = test_equivalence({.value = 0.0}, 1.0);
    EXPECT_EQ(test.verdict, Verdict::undecided);
    EXPECT_TRUE(std::isnan(test.probability));
    EXPECT_FALSE(test.interval);
}

TEST(Equivalence, RequiresAMargin) {
    EXPECT_THROW((void)test_equivalence({.value = 1.0, .standard_error = 1.0}, 0.0), InvalidArgument);
    EXPECT_THROW((void)test_equivalence({.value = 1.0, .standard_error = 1.0}, 1.0, 0.5), InvalidArgument);
}

}  // namespace setae::statistics::equivalence_test
