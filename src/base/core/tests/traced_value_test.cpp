// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/traced_value.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"

namespace setae::traced_value_test {
namespace {

TracedValue input(const char* name, double value, double error) {
    return {{.value = value, .standard_error = error}, name};
}

// JCGM 100:2008, H.2: resistance, reactance and impedance from one current, voltage and phase. V and I are perfectly
// correlated through one calibration, so their ratio does not depend on it.
TEST(TracedValue, RatioOfTwoValuesCancelsTheirCommonCalibration) {
    const auto gain = input("gain", 1.0, 0.02);
    const TracedValue voltage{5.0, combined({{5.0, gain.components}})},
        current{2.0, combined({{2.0, gain.components}})};
    const TracedValue ratio{2.5, combined({{1.0 / 2.0, voltage.components}, {-5.0 / 4.0, current.components}})};
    EXPECT_NEAR(ratio.standard_error(), 0.0, 1e-15);
    EXPECT_NEAR(covariance(voltage, current), 5.0 * 2.0 * 0.02 * 0.02, 1e-15);
}

TEST(TracedValue, AddsVariancesOfIndependentInputs) {
    const auto a = input("a", 1.0, 3.0), b = input("b", 2.0, 4.0);
    const TracedValue sum{3.0, combined({{1.0, a.components}, {1.0, b.components}})};
    EXPECT_DOUBLE_EQ(sum.standard_error(), 5.0);
    EXPECT_DOUBLE_EQ(covariance(a, b), 0.0);
    EXPECT_TRUE(std::isnan(TracedValue(3.0).estimate().standard_error)) << "nothing is known";
}

// ν = (Σ v)²/Σ v²/ν_i: 25²/(9²/4 + 0)
TEST(TracedValue, HasTheDegreesOfFreedomOfItsInputs) {
    const TracedValue a({.value = 0.0, .standard_error = 3.0, .degrees_of_freedom = 4.0}, "a");
    const auto b = input("b", 0.0, 4.0);
    const TracedValue sum{0.0, combined({{1.0, a.components}, {1.0, b.components}})};
    EXPECT_NEAR(*sum.estimate().degrees_of_freedom, 625.0 * 4.0 / 81.0, 1e-12);
    EXPECT_FALSE(b.estimate().degrees_of_freedom);
}

TEST(TracedValue, BudgetListsInputsAndTheGainOfHalvingEach) {
    const auto a = input("a", 0.0, 3.0), b = input("b", 0.0, 4.0);
    const auto rows = budget_of({0.0, combined({{1.0, a.components}, {1.0, b.components}})});
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].input, "b");
    EXPECT_DOUBLE_EQ(rows[0].share, 0.64);
    EXPECT_DOUBLE_EQ(rows[0].halved, std::sqrt(9.0 + 4.0));
    EXPECT_DOUBLE_EQ(rows[1].standard_error, 3.0);
}

TEST(TracedValue, RefusesOneNameWithTwoSizes) {
    const Components one{{"s", {Array1D::Ones(1)}}}, two{{"s", {Array1D::Ones(2)}}};
    EXPECT_THROW((void)covariance(one, two), InvalidArgument);
    EXPECT_THROW((void)combined({{1.0, one}, {1.0, two}}), InvalidArgument);
}

TEST(UncertainQuantity, ReadsRanges) {
    const auto range = parse_uncertain_quantity("1.2 to 1.3 mm", positive(dimension::length));
    EXPECT_NEAR(range.value, 1.25e-3, 1e-18);
    EXPECT_NEAR(range.standard_error, 1e-4 / std::sqrt(12.0), 1e-18);
    EXPECT_EQ(range.method, "rectangular");
    EXPECT_THROW((void)parse_uncertain_quantity("1.3 to 1.2 mm", positive(dimension::length)), InvalidArgument);
    EXPECT_THROW((void)parse_uncertain_quantity("-1 to 1 mm", positive(dimension::length)), InvalidArgument);
}

TEST(UncertainQuantity, RefusesAnErrorLargerThanAPositiveValue) {
    EXPECT_THROW((void)parse_uncertain_quantity("5 ± 7 mm", positive(dimension::length)), InvalidArgument);
    EXPECT_EQ(parse_uncertain_quantity("0 ± 7 mm", dimension::length).standard_error, 7e-3);
}

}  // namespace
}  // namespace setae::traced_value_test
