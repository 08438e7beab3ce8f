// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/contact/bulk_crack_factor.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::contact::crack_speed::bulk_crack_factor_test {
namespace {

const std::vector<RelaxationTerm> rubber{{0.6, 1e-3}, {0.9, 2e-2}, {0.3, 1.0}};
constexpr double tip = 5e-9;

// scipy's quad and brentq with the formula as it stands in the header
TEST(BulkCrackFactor, MatchesAnotherQuadrature) {
    for (const auto& [speed, factor] : {std::pair{1e-9, 1.1477712326012377},
                                        {1e-8, 1.362064686014133},
                                        {1e-7, 1.8049134882975144},
                                        {1e-6, 2.2873236165852164},
                                        {1e-4, 2.7858771833044824}})
        EXPECT_NEAR(bulk_factor(speed, rubber, tip), factor, 1e-8) << speed;
}

// f − 1 = π (v/a0) Σ g τ
TEST(BulkCrackFactor, IsLinearInASlowSpeed) {
    const double sum = 0.6 * 1e-3 + 0.9 * 2e-2 + 0.3;
    for (const double speed : {1e-14, 1e-13})
        EXPECT_NEAR((bulk_factor(speed, rubber, tip) - 1.0) / (pi * speed / tip * sum), 1.0, 1e-3);
    EXPECT_EQ(bulk_factor(0.0, rubber, tip), 1.0);
}

TEST(BulkCrackFactor, IsBoundedByTheInstantaneousModulus) {
    EXPECT_DOUBLE_EQ(largest_bulk_factor(rubber), 2.8);
    EXPECT_NEAR(bulk_factor(1.0, rubber, tip), 2.8, 1e-4);
    double last = 1.0;
    for (double speed = 1e-12; speed < 1.0; speed *= 3.0) {
        const double factor = bulk_factor(speed, rubber, tip);
        EXPECT_GT(factor, last);
        EXPECT_LT(factor, 2.8);
        last = factor;
    }
}

TEST(BulkCrackFactor, IsOneWithoutRelaxation) {
    EXPECT_EQ(bulk_factor(1e-6, {}, tip), 1.0);
    EXPECT_EQ(bulk_factor(1e-6, {{0.0, 1.0}}, tip), 1.0);
}

TEST(BulkCrackFactor, RefusesValuesOutsideItsDomain) {
    EXPECT_THROW((void)bulk_factor(-1.0, rubber, tip), InvalidArgument);
    EXPECT_THROW((void)bulk_factor(1.0, rubber, 0.0), InvalidArgument);
    EXPECT_THROW((void)largest_bulk_factor({{0.1, 0.0}}), InvalidArgument);
    EXPECT_THROW((void)largest_bulk_factor({{-0.1, 1.0}}), InvalidArgument);
}

}  // namespace
}  // namespace setae::contact::crack_speed::bulk_crack_factor_test
