// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/runs_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace setae::loops::runs_test_test {
namespace {

Array1D signs(const std::string& text) {
    Array1D values(static_cast<Index>(text.size()));
    for (Index i = 0; i < values.size(); ++i) values[i] = text[static_cast<std::size_t>(i)] == '+' ? 0.7 : -0.3;
    return values;
}

TEST(RunsTest, CountsRunsAndSigns) {
    Array1D values = signs("++--+---");
    values[2] = 0.0;  // left out
    const RunsTest test = runs_test(values);
    EXPECT_EQ(test.runs, 4);
    EXPECT_EQ(test.above, 3);
    EXPECT_EQ(test.below, 4);
}

TEST(RunsTest, OfFewResidualsIsExact) {
    // all C(6, 3) = 20 arrangements: 2 with 2 runs, 4 with 3, 8 with 4, 4 with 5, 2 with 6
    EXPECT_NEAR(runs_test(signs("+++---")).p_value, 2.0 / 20, 1e-12);
    EXPECT_NEAR(runs_test(signs("++---+")).p_value, 6.0 / 20, 1e-12);
    EXPECT_NEAR(runs_test(signs("++-+--")).p_value, 14.0 / 20, 1e-12);
    EXPECT_NEAR(runs_test(signs("+-+--+")).p_value, 18.0 / 20, 1e-12);
    EXPECT_NEAR(runs_test(signs("+-+-+-")).p_value, 1.0, 1e-12);
}

TEST(RunsTest, IsContinuousWithTheNormalApproximation) {
    // 25 of each sign are counted exactly, one residual more is not: the two agree to what an odd sign and the normal
    // leave
    const std::string pairs = "++--+-+--+";
    std::string text;
    for (int i = 0; i < 5; ++i) text += pairs;
    const double exact = runs_test(signs(text)).p_value;
    const RunsTest longer = runs_test(signs(text + "+"));
    EXPECT_EQ(longer.above + longer.below, 51);
    EXPECT_NEAR(longer.p_value, exact, 0.06);
    EXPECT_GT(exact, 0.5);
}

TEST(RunsTest, RejectsIndependentResidualsAtItsLevel) {
    constexpr int seeds = 400;
    int refused = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        std::normal_distribution<double> normal;
        Array1D values(300);
        for (double& value : values) value = normal(generator);
        refused += runs_test(values).p_value < 0.05;
    }
    // 20 expected, standard deviation 4.4
    EXPECT_GE(refused, 8);
    EXPECT_LE(refused, 33);
}

TEST(RunsTest, DetectsACurveInTheResiduals) {
    const Array1D angle = Array1D::LinSpaced(200, 0.0, 6.0);
    EXPECT_LT(runs_test(Array1D(angle.cos())).p_value, 1e-6);
}

TEST(RunsTest, IsUndefinedForOneSign) {
    EXPECT_TRUE(std::isnan(runs_test(signs("+++")).p_value));
    EXPECT_EQ(runs_test(signs("+++")).runs, 1);
    EXPECT_TRUE(std::isnan(runs_test(Array1D()).p_value));
}

}  // namespace
}  // namespace setae::loops::runs_test_test
