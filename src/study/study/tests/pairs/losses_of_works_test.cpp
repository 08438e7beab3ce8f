// SPDX-License-Identifier: GPL-3.0-or-later
// What loops with the measured works would lose, beside what they lost.
#include "results/losses_of_works.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "setae/core/constants.hpp"

namespace setae::study::losses_of_works_test {
namespace {

Estimate given(double value, double error) { return {value, error, "given"}; }

/// The smooth reference on the softest elastomer, Tables S1 to S3 of [D19], under 1 mN; with its loss.
Study study_with(const Estimate& loss) {
    Study study;
    ElastomerInput elastomer;
    elastomer.name = "E0.7";
    elastomer.youngs_modulus = given(0.69e6, 0.02e6);
    elastomer.surface_energy = given(0.025, 0.005);
    elastomer.sphere_radius = Estimate{1.25e-3, 0.0};
    elastomer.preload = 1e-3;
    study.elastomers = {elastomer};
    study.counter_youngs_modulus = 1100e9;
    study.counter_poisson_ratio = 0.06;
    study.published.push_back(
        {.elastomer = "E0.7", .approach = given(39.6e-3, 1.2e-3), .retraction = given(59.3e-3, 1.0e-3), .loss = loss});
    return study;
}

bool contradicted(const Estimate& loss) {
    const auto result = run_study(study_with(loss), {1});
    return std::ranges::any_of(result.alerts,
                               [](const Alert& alert) { return alert.code == "LOSS_CONTRADICTS_WORKS"; });
}

// E_in(W_app) + (W_ret − W_app) π a_max² + E_out(W_ret) of JKR under fixed grips, computed apart in Python
TEST(LossFromWorks, MatchAFlatPunchBetweenTwoJumps) {
    const auto result = run_study(study_with(given(0.38e-9, 0.02e-9)), {1});
    const auto found = loss_of_works(result.elastomer("E0.7"), TracedValue(39.6e-3), TracedValue(59.3e-3));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->energy.value / 1.6733136599069894e-9, 1.0, 1e-8);
    EXPECT_NEAR(found->contact_area / 5.921169464683932e-8, 1.0, 1e-8);
    // without hysteresis the two jumps are left, whatever is said of W_ret below W_app
    for (const double retraction : {39.6e-3, 20e-3})
        EXPECT_NEAR(
            loss_of_works(result.elastomer("E0.7"), TracedValue(39.6e-3), TracedValue(retraction))->energy.value /
                4.644736464588389e-10,
            1.0, 1e-8);
    EXPECT_FALSE(loss_of_works(result.elastomer("E0.7"), TracedValue(0.0), TracedValue(59.3e-3)));
}

TEST(LossFromWorks, AreComparedWithTheMeasuredLoss) {
    EXPECT_TRUE(contradicted(given(0.38e-9, 0.02e-9)));
    EXPECT_FALSE(contradicted(given(1.67e-9, 0.02e-9)));
    EXPECT_FALSE(contradicted(given(0.38e-9, 0.6e-9))) << "within three standard errors";
    EXPECT_FALSE(contradicted(given(1.45e-9, 0.001e-9))) << "within a fifth";
}

TEST(LossFromWorks, HaveNoSlopeForFewerThanTwoPairs) {
    EXPECT_FALSE(loss_slope_of_works(run_study(study_with(given(0.38e-9, 0.02e-9)), {1})));
}

}  // namespace
}  // namespace setae::study::losses_of_works_test
