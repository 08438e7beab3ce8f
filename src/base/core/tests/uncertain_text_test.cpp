// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/core/uncertain_text.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"

namespace setae::uncertain_text_test {
namespace {

std::string of(double value, double error, double factor = 1.0) { return uncertain_number({value, error}, factor); }

TEST(UncertainNumber, ShowsTwoDigitsOfTheErrorAndAlignsTheValue) {
    EXPECT_EQ(of(37.0, 3.7), "37.0 ± 3.7");
    EXPECT_EQ(of(37.012, 0.00312), "37.0120 ± 0.0031");
    EXPECT_EQ(of(351.2, 120.0), "350 ± 120");
    EXPECT_EQ(of(0.7, 0.00018), "0.70000 ± 0.00018");
    EXPECT_EQ(of(11.06, 200.7), "10 ± 200");
    EXPECT_EQ(of(5.0, 0.0996), "5.00 ± 0.10") << "rounding carries";
    EXPECT_EQ(of(-0.0001, 0.12), "0.00 ± 0.12");
    EXPECT_EQ(of(3.7e-2, 1e-3, 1e-3), "37.0 ± 1.0");
    EXPECT_EQ(of(1e-30, 2e-31), "(1.00 ± 0.20)×10⁻³⁰");
}

TEST(UncertainNumber, WithoutErrorShowsFourDigits) {
    EXPECT_EQ(of(37.0123, 0.0), "37.01");
    EXPECT_EQ(of(37.0123, undefined), "37.01");
    EXPECT_EQ(of(1.5e9, 0.0), "1.500×10⁹");
    EXPECT_EQ(of(0.0, undefined), "0");
    EXPECT_EQ(of(undefined, 1.0), "–");
    EXPECT_EQ(of(std::numeric_limits<double>::infinity(), 1.0), "infinite");
    EXPECT_EQ(of(37.0, std::numeric_limits<double>::infinity()), "37.00 ± infinite");
}

TEST(UncertainNumber, ShowsItsInterval) {
    const Estimate work{.value = 36.9756, .standard_error = 0.1512, .interval = Interval{36.67, 37.284}};
    EXPECT_EQ(number_with_interval(work), "36.98 [36.67, 37.28]");
    EXPECT_EQ(full_number(work), "36.98 ± 0.15 [36.67, 37.28]");
    EXPECT_EQ(number_with_interval({.value = 2.0, .interval = Interval{1.0, 3.0}}), "2.00 [1.00, 3.00]");
    EXPECT_EQ(number_with_interval({2.0}), "2.000");
}

TEST(FormatUncertain, UsesOneUnitForValueAndError) {
    EXPECT_EQ(format_uncertain({9.5668e6, 2.29e5}, "1/m"), "9.57 ± 0.23 µm⁻¹");
    EXPECT_EQ(format_uncertain({3.7e-2, 3.7e-3}, "J/m2"), "37.0 ± 3.7 mJ/m²");
    EXPECT_EQ(format_uncertain({2e-22, 3e-9}, "m"), "0.0 ± 3.0 nm");
    EXPECT_EQ(format_uncertain({1.058, 0.0037}, "1"), "1.0580 ± 0.0037");
    EXPECT_EQ(format_interval({.value = 3.6976e-2, .standard_error = 1.5e-4, .interval = Interval{3.667e-2, 3.728e-2}},
                              "J/m2"),
              "36.98 [36.67, 37.28] mJ/m²");
    EXPECT_EQ(format_uncertain({undefined}, "m"), "–");
}

TEST(ProbabilityText, FormatsAsInPapers) {
    EXPECT_EQ(probability_text(1.0), "1");
    EXPECT_EQ(probability_text(0.5734), "0.57");
    EXPECT_EQ(probability_text(4.1e-33), "4·10⁻³³");
    EXPECT_EQ(probability_text(9.7e-5), "1·10⁻⁴");
    EXPECT_EQ(probability_text(0.0), "0");
}

}  // namespace
}  // namespace setae::uncertain_text_test
