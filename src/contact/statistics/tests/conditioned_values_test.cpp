// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/statistics/conditioned_values.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::statistics {
namespace {

TracedValue known(double value, double error, const std::string& name) {
    return {Estimate{.value = value, .standard_error = error}, name};
}

TracedValue minus(const TracedValue& a, const TracedValue& b) {
    return {a.value - b.value, combined({{1.0, a.components}, {-1.0, b.components}})};
}

TEST(ConditionedValues, OfOneMeasurementEqualTheWeightedMean) {
    const auto before = known(10.0, 2.0, "x"), measured = known(13.0, 1.0, "noise");
    const ConditionedValues fit({minus(measured, before)});
    const auto after = fit.updated(before);
    EXPECT_NEAR(after.value, (10.0 / 4.0 + 13.0) / (1.0 / 4.0 + 1.0), 1e-12);
    EXPECT_NEAR(after.standard_error(), std::sqrt(1.0 / (1.0 / 4.0 + 1.0)), 1e-12);
    EXPECT_NEAR(fit.updated(measured).value, after.value, 1e-12) << "both say the same afterwards";
    EXPECT_NEAR(fit.chi2(), 9.0 / 5.0, 1e-12);
    EXPECT_NEAR(fit.log_likelihood(), -0.5 * (std::log(2.0 * pi * 5.0) + 9.0 / 5.0), 1e-12);
    EXPECT_NEAR(fit.moves().at("x"), std::abs(after.value - 10.0) / 2.0, 1e-12);
}

TEST(ConditionedValues, OfPartsWithKnownSumAreCorrelated) {
    // two parts of which the sum is measured ten times better than each: they can no longer be distinguished
    const auto a = known(3.0, 1.0, "a"), b = known(4.0, 1.0, "b"), sum = known(8.0, 0.1, "noise");
    const TracedValue parts(a.value + b.value, combined({{1.0, a.components}, {1.0, b.components}}));
    const ConditionedValues fit({minus(sum, parts)});
    const auto x = fit.updated(a), y = fit.updated(b), both = fit.updated(parts);
    EXPECT_NEAR(x.value + y.value, both.value, 1e-12);
    EXPECT_NEAR(both.value, fit.updated(sum).value, 1e-12);
    EXPECT_NEAR(covariance(x, y) / (x.standard_error() * y.standard_error()), -1.0, 0.02);
    EXPECT_NEAR(both.standard_error(), 0.1, 1e-3);
    EXPECT_NEAR(both.variance(), x.variance() + y.variance() + 2.0 * covariance(x, y), 1e-12);
}

TEST(ConditionedValues, EqualLeastSquares) {
    // a line through three points with a vague prior: ordinary least squares
    const auto slope = known(0.0, 1e4, "slope"), offset = known(0.0, 1e4, "offset");
    const double x[] = {0.0, 1.0, 3.0}, y[] = {1.1, 2.8, 7.2};
    std::vector<TracedValue> residuals;
    for (int i = 0; i < 3; ++i) {
        const TracedValue line(0.0, combined({{x[i], slope.components}, {1.0, offset.components}}));
        residuals.push_back(minus(known(y[i], 0.1, "noise " + std::to_string(i)), line));
    }
    const ConditionedValues fit(residuals);
    // Σ(x − 4/3)² = 14/3, Σ(x − 4/3)(y − 3.7) = 9.6
    EXPECT_NEAR(fit.updated(slope).value, 9.6 / (14.0 / 3.0), 1e-6);
    EXPECT_NEAR(fit.updated(slope).standard_error(), 0.1 / std::sqrt(14.0 / 3.0), 1e-6);
    EXPECT_NEAR(fit.updated(offset).value, 3.7 - 9.6 / (14.0 / 3.0) * 4.0 / 3.0, 1e-6);
}

TEST(ConditionedValues, DoNotChangeIndependentValues) {
    const auto other = known(5.0, 0.5, "other");
    const ConditionedValues fit({minus(known(1.0, 1.0, "noise"), known(0.0, 1.0, "x"))});
    EXPECT_EQ(fit.updated(other).value, 5.0);
    EXPECT_DOUBLE_EQ(fit.updated(other).standard_error(), 0.5);
}

TEST(ConditionedValues, RefuseDuplicatesAndValuesWithoutError) {
    const auto x = known(1.0, 1.0, "x");
    EXPECT_THROW(ConditionedValues({x, x}), UndefinedDataError);
    EXPECT_THROW(ConditionedValues({TracedValue(1.0)}), UndefinedDataError);
}

}  // namespace
}  // namespace setae::statistics
