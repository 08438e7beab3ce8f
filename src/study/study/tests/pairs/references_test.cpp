// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth references and repeated loops without labels, and their results for a pair.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "results/statistics.hpp"
#include "setae/core/constants.hpp"
#include "setae/study/study_result.hpp"

namespace setae::study::references_test {
namespace {

/// NCD and the smooth reference on the softest elastomer, Tables S1 to S3 of [D19].
Study study_with_reference(double contact_radius = undefined) {
    Study study;
    SurfaceInput surface;
    surface.name = "NCD";
    surface.moments = PublishedMoments{.rms_height = {121.7e-9, 8e-9, "given"},
                                       .rms_slope = {1.15, 0.04, "given"},
                                       .rms_curvature = {3.19e9, 0.1e9, "given"},
                                       .short_wavevector = {1.6e10}};
    study.surfaces = {surface};
    ElastomerInput elastomer;
    elastomer.name = "E0.7";
    elastomer.youngs_modulus = {0.69e6, 0.02e6, "given"};
    elastomer.surface_energy = {0.025, 0.005, "given"};
    elastomer.sphere_radius = Estimate{1.25e-3, 0.0};
    study.elastomers = {elastomer};
    study.counter_youngs_modulus = 1100e9;
    study.counter_poisson_ratio = 0.06;
    const auto of = [](double value, double error) { return Estimate{value, error, "given"}; };
    study.published.push_back({.surface = "NCD",
                               .elastomer = "E0.7",
                               .approach = of(21.73e-3, 0.60e-3),
                               .retraction = of(116.2e-3, 5.76e-3)});
    study.published.push_back(
        {.elastomer = "E0.7", .approach = of(39.6e-3, 1.2e-3), .retraction = of(59.3e-3, 1.0e-3)});
    auto& reference = study.published.back();
    reference.loss = of(0.38e-9, 0.02e-9);
    if (std::isfinite(contact_radius)) reference.contact_radius = contact_radius;
    return study;
}

std::vector<Alert> alerts_with(const StudyResult& result, const std::string& code) {
    std::vector<Alert> found;
    for (const auto& alert : result.alerts)
        if (alert.code == code) found.push_back(alert);
    return found;
}

TEST(PublishedPair, DoesNotDetermineTheWorkAlongTheRetraction) {
    auto study = study_with_reference();
    const auto along = run_study(study, {1}).pairs.at(0).work_along_retraction;
    EXPECT_FALSE(along);
    EXPECT_EQ(along.reason, "undetermined: only W_ret at pull-off is known");
    study.published.front().retraction.reset();
    EXPECT_EQ(run_study(study, {1}).pairs.at(0).work_along_retraction.reason, "the retraction was not measured");
}

TEST(SmoothReference, OfTableS3HasHysteresisAndItsShareOfRoughHysteresis) {
    const auto result = run_study(study_with_reference(), {1});
    const auto& test = result.references.at(0).hysteresis;
    EXPECT_NEAR(test.difference.value, 19.7e-3, 1e-9);
    EXPECT_NEAR(test.difference.standard_error, std::hypot(1.2e-3, 1.0e-3), 1e-9);
    EXPECT_EQ(test.verdict, statistics::Verdict::different);
    const auto alerts = alerts_with(result, "REFERENCE_HYSTERESIS");
    ASSERT_EQ(alerts.size(), 1U);
    EXPECT_NE(alerts[0].message.find("19.70 mJ/m² ± 1.6 mJ/m², more than the margin of 5.000 mJ/m²"), std::string::npos)
        << alerts[0].message;
    EXPECT_NE(alerts[0].message.find("21 % of NCD"), std::string::npos) << alerts[0].message;
    const auto& share = result.pairs.at(0).reference_share;
    ASSERT_TRUE(share);
    EXPECT_NEAR(share->value, 19.7 / (116.2 - 21.73), 1e-9);
    EXPECT_NEAR(share->standard_error / share->value,
                std::hypot(std::hypot(1.2, 1.0) / 19.7, std::hypot(5.76, 0.6) / 94.47), 1e-3);
}

TEST(SmoothReference, WithAWideMarginIsEquivalentWithoutWarning) {
    auto study = study_with_reference();
    study.comparison.margin = 23e-3;
    const auto result = run_study(study, {1});
    EXPECT_EQ(result.references.at(0).hysteresis.verdict, statistics::Verdict::equivalent);
    EXPECT_TRUE(alerts_with(result, "REFERENCE_HYSTERESIS").empty());
}

TEST(SmoothReference, IsTestedByItsLossPerAreaBeyondAnIdealSphere) {
    // 0.38 nJ are less than the jumps of the ideal sphere cost: what is beyond is small and negative
    const double radius = 120e-6, area = pi * radius * radius;
    const auto result = run_study(study_with_reference(radius), {1});
    const auto& reference = result.references.at(0);
    ASSERT_TRUE(reference.loss_per_area);
    EXPECT_NEAR(reference.loss_per_area->difference.value, (0.38e-9 - *reference.ideal_loss) / area, 1e-9);
    EXPECT_EQ(reference.loss_per_area->verdict, statistics::Verdict::equivalent);
    EXPECT_TRUE(alerts_with(result, "REFERENCE_LOSS").empty());

    auto lossy = study_with_reference(radius);
    lossy.published.back().loss = Estimate{2e-9, 0.1e-9, "given"};
    const auto alerts = alerts_with(run_study(lossy, {1}), "REFERENCE_LOSS");
    ASSERT_EQ(alerts.size(), 1U);
    EXPECT_NE(alerts[0].message.find("more than the margin"), std::string::npos) << alerts[0].message;
}

/// Coverage of the 95 % interval over 2000 means of n loops. Loops scatter by 3, their fits' errors are so
/// large.
double coverage(int n, double fit_error) {
    std::mt19937_64 engine(17);
    std::normal_distribution<double> normal;
    int held = 0;
    constexpr int trials = 2000;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<Estimate> loops;
        for (int i = 0; i < n; ++i)
            loops.push_back({40.0 + 3.0 * normal(engine) + fit_error * normal(engine), fit_error, "fit"});
        const auto interval = *interval_of(mean_of(loops));
        held += interval.lower <= 40.0 && 40.0 <= interval.upper ? 1 : 0;
    }
    return held / double{trials};
}

TEST(LoopsWithoutLabels, HaveMeansWhoseIntervalsCoverTheTrueValue) {
    // ±1.96 SE would hold 70 % of two loops, 81 % of three
    for (const int n : {2, 3, 5})
        for (const double fit_error : {0.1, 1.0}) {
            const double share = coverage(n, fit_error);
            EXPECT_GE(share, 0.915) << n << " " << fit_error;
            EXPECT_LE(share, 0.975) << n << " " << fit_error;
        }
}

TEST(LoopsWithoutLabels, OfOneLoopEqualThatLoop) {
    const auto mean = mean_of({Estimate{40.0, 2.0, "fit"}});
    EXPECT_EQ(mean.value, 40.0);
    EXPECT_EQ(mean.standard_error, 2.0);
    EXPECT_EQ(mean.method, "fit");
}

}  // namespace
}  // namespace setae::study::references_test
