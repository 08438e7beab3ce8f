// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/edge_speeds.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "setae/study/study_result.hpp"

namespace setae::study::edge_speeds_test {
namespace {

constexpr double slow = 0.1e-6, fast = 10e-6;

double rate(double threshold, double speed, double exponent, double at) {
    return threshold * (1.0 + std::pow(at / speed, exponent));
}

/// A fit with an error of 1 % of ln G at the slowest, the middle and the fastest of its speeds.
loops::CrackSpeedFit fit_of(double threshold, double speed, double exponent) {
    loops::CrackSpeedFit fit;
    fit.law = {threshold, speed, exponent};
    fit.threshold = {.value = threshold};
    fit.reference_speed = {.value = speed};
    fit.exponent = {.value = exponent};
    fit.slow_speed = slow;
    fit.speed_ratio = fast / slow;
    Eigen::Matrix3d slopes;
    const double speeds[] = {slow, std::sqrt(slow * fast), fast};
    for (int k = 0; k < 3; ++k) {
        const auto ln_rate = [&](double a, double b, double c) { return std::log(rate(a, b, c, speeds[k])); };
        constexpr double h = 1e-5;
        slopes(k, 0) = (ln_rate(threshold * (1 + h), speed, exponent) - ln_rate(threshold * (1 - h), speed, exponent)) /
                       (2 * h * threshold);
        slopes(k, 1) = (ln_rate(threshold, speed * (1 + h), exponent) - ln_rate(threshold, speed * (1 - h), exponent)) /
                       (2 * h * speed);
        slopes(k, 2) = (ln_rate(threshold, speed, exponent * (1 + h)) - ln_rate(threshold, speed, exponent * (1 - h))) /
                       (2 * h * exponent);
    }
    const Eigen::Matrix3d back = slopes.inverse();
    fit.covariance.topLeftCorner<3, 3>() = 1e-4 * back * back.transpose();
    return fit;
}

StudyResult study_of(const std::vector<loops::Outcome<loops::CrackSpeedFit>>& fits) {
    StudyResult result;
    result.elastomers.emplace_back().input.name = "E";
    for (const auto& fit : fits) {
        auto& e = result.experiments.emplace_back();
        e.input.file = "reference.csv";
        e.input.elastomer = "E";
        e.input.reference = true;
        e.edge_speed = fit;
        loops::JkrFit loading;
        loading.work_of_adhesion = {.value = 0.040, .standard_error = 1e-5};
        e.analysis.emplace();
        e.analysis->loading.radius_force = loading;
    }
    return result;
}

TEST(EdgeSpeeds, OfConsistentReferencesHaveSmallerErrors) {
    const auto one = edge_speed_of(study_of({fit_of(0.041, 1e-6, 0.6)}), "E"),
               two = edge_speed_of(study_of({fit_of(0.041, 1e-6, 0.6), fit_of(0.041, 1e-6, 0.6)}), "E");
    ASSERT_TRUE(one && two);
    EXPECT_EQ(two->references, 2);
    EXPECT_NEAR(two->law.reference_speed.value / 1e-6, 1.0, 1e-9);
    EXPECT_NEAR(two->law.exponent.value, 0.6, 1e-9);
    EXPECT_NEAR(two->law.rest_factor.value, 0.041 / 0.040, 1e-9);
    EXPECT_NEAR(two->law.exponent.standard_error() / one->law.exponent.standard_error(), std::sqrt(0.5), 1e-6);
}

// Errors of G0, v0 and n lie along a curved ridge: both fits give almost the same G at every speed.
TEST(EdgeSpeeds, OfReferencesAlongACorrelationAreCombinedAlongIt) {
    const auto first = fit_of(0.040, 1e-6, 0.60), second = fit_of(0.044, 1.45e-6, 0.66);
    const auto found = edge_speed_of(study_of({first, second}), "E");
    ASSERT_TRUE(found);
    const double middle = std::sqrt(slow * fast);
    const double expected = std::sqrt(rate(0.040, 1e-6, 0.60, middle) * rate(0.044, 1.45e-6, 0.66, middle));
    EXPECT_NEAR(
        rate(found->threshold->value, found->law.reference_speed.value, found->law.exponent.value, middle) / expected,
        1.0, 1e-9);
    EXPECT_GT(found->law.reference_speed.value, 1e-6);
    EXPECT_LT(found->law.reference_speed.value, 1.45e-6);
    EXPECT_GE(found->law.reference_speed.standard_error(), std::sqrt(0.5) * std::sqrt(first.covariance(1, 1)) * 0.9)
        << "two fits know it no better than √2 times one";
}

TEST(EdgeSpeeds, OfReferencesWithoutResultGiveTheReason) {
    using Fit = loops::Outcome<loops::CrackSpeedFit>;
    const auto none = edge_speed_of(study_of({Fit::missing("the contact edge does not move inwards")}), "E");
    EXPECT_FALSE(none);
    EXPECT_EQ(none.reason, "reference.csv: the contact edge does not move inwards");
    EXPECT_EQ(edge_speed_of(study_of({}), "E").reason, "no loop on a smooth reference");
    auto without_errors = fit_of(0.04, 1e-6, 0.6);
    without_errors.covariance.setZero();
    EXPECT_NE(edge_speed_of(study_of({Fit(without_errors)}), "E").reason.find("no standard errors"), std::string::npos);
}

TEST(EdgeSpeeds, UseStatedValues) {
    auto result = study_of({fit_of(0.04, 1e-6, 0.6)});
    result.elastomers[0].input.crack_speed = StatedEdgeSpeed{{.value = 2e-6, .standard_error = 1e-7}, {.value = 0.5}};
    const auto found = edge_speed_of(result, "E");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->references, 0);
    EXPECT_EQ(found->law.reference_speed.value, 2e-6);
    EXPECT_EQ(found->law.rest_factor.value, 1.0);
    EXPECT_DOUBLE_EQ(found->law.reference_speed.standard_error(), 1e-7);
}

}  // namespace
}  // namespace setae::study::edge_speeds_test
