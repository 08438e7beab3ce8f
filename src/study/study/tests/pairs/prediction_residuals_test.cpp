// SPDX-License-Identifier: GPL-3.0-or-later
// Measured against predicted values: χ² of true values over seeds.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <random>
#include <utility>

#include "setae/output/json.hpp"
#include "setae/output/study_tables.hpp"

namespace setae::study::prediction_residuals_test {
namespace {

/// Three surfaces by their moments and three elastomers, every input uncertain.
Study study_of_nine_pairs() {
    Study study;
    // polished diamond, flatter and steeper
    for (const auto& [name, scale] : {std::pair{"A", 0.7}, std::pair{"B", 1.0}, std::pair{"C", 1.3}}) {
        SurfaceInput surface;
        surface.name = name;
        surface.moments = PublishedMoments{.rms_height = {scale * 4.6e-9, 0.3e-9, "given"},
                                           .rms_slope = {scale * 0.39, 0.02, "given"},
                                           .rms_curvature = {scale * 1.13e9, 0.05e9, "given"},
                                           .short_wavevector = {1.6e10}};
        study.surfaces.push_back(surface);
    }
    for (const double modulus : {1e6, 3e6, 8e6}) {
        ElastomerInput elastomer;
        elastomer.name = std::to_string(modulus);
        elastomer.youngs_modulus = {modulus, 0.05 * modulus, "given"};
        elastomer.surface_energy = {0.025, 0.002, "given"};
        study.elastomers.push_back(elastomer);
    }
    study.counter_youngs_modulus = INFINITY;
    study.work_of_adhesion = Estimate{0.045, 0.001, "given"};
    return study;
}

/// The study with values measured on true inputs, which differ from the stated inputs by their standard errors.
Study simulated_study(const Study& nominal, std::mt19937_64& random, double measured_error) {
    std::normal_distribution<double> normal;
    const auto drawn = [&](Estimate& estimate) { estimate.value += estimate.standard_error * normal(random); };
    auto truth = nominal;
    for (auto& surface : truth.surfaces)
        for (auto* moment :
             {&surface.moments->rms_height, &surface.moments->rms_slope, &surface.moments->rms_curvature})
            drawn(*moment);
    for (auto& elastomer : truth.elastomers) {
        drawn(elastomer.youngs_modulus);
        drawn(elastomer.surface_energy);
    }
    drawn(*truth.work_of_adhesion);
    const auto true_result = run_study(truth, {1});
    auto study = nominal;
    for (const auto& pair : true_result.pairs)
        study.published.push_back(
            {.surface = pair.surface,
             .elastomer = pair.elastomer,
             .approach = Estimate{pair.modified->work.raw + measured_error * normal(random), measured_error, "given"}});
    return study;
}

TEST(PredictionTest, OfTrueModelsHasTheExpectedChiSquared) {
    const auto nominal = study_of_nine_pairs();
    std::mt19937_64 random(11);
    constexpr int seeds = 30;
    double given = 0.0, fitted = 0.0;
    for (int seed = 0; seed < seeds; ++seed) {
        auto study = simulated_study(nominal, random, 0.002);
        const auto result = run_study(study, {1});
        ASSERT_TRUE(result.prediction_test) << result.prediction_test.reason;
        ASSERT_GT(result.pairs.back().modified->work.raw, 0.0);  // the floor is not met
        EXPECT_EQ(result.prediction_test->degrees_of_freedom, 9);
        given += result.prediction_test->chi_squared / seeds;
        study.work_of_adhesion.reset();
        const auto with_fit = run_study(study, {1});
        EXPECT_EQ(with_fit.prediction_test->degrees_of_freedom, 8);
        EXPECT_TRUE(with_fit.prediction_test->work_fitted);
        fitted += with_fit.prediction_test->chi_squared / seeds;
    }
    // means of 30 χ²: scatter √(2ν/30), three of it, and 5 % for what is not linear
    EXPECT_NEAR(given, 9.0, 3.0 * std::sqrt(18.0 / seeds) + 0.45);
    EXPECT_NEAR(fitted, 8.0, 3.0 * std::sqrt(16.0 / seeds) + 0.40);
}

TEST(PredictionTest, ExcludesPairsWithoutErrorsByName) {
    auto study = study_of_nine_pairs();
    study.published.push_back({.surface = "A", .elastomer = study.elastomers[0].name, .approach = Estimate{0.03}});
    study.published.push_back(
        {.surface = "B", .elastomer = study.elastomers[0].name, .approach = Estimate{0.03, 0.002, "given"}});
    const auto result = run_study(study, {1});
    ASSERT_TRUE(result.prediction_test) << result.prediction_test.reason;
    EXPECT_EQ(result.prediction_test->n, 1);
    EXPECT_EQ(result.prediction_test->left_out.at(0),
              "A × " + study.elastomers[0].name + ": the measured value has no standard error");
    const auto json = output::to_json(result);
    EXPECT_DOUBLE_EQ(json.at("prediction_test").at("chi_squared").at("value").get<double>(),
                     result.prediction_test->chi_squared);
    const auto table = output::prediction_test_table(result);
    ASSERT_EQ(table.rows.size(), 2U);
    EXPECT_EQ(table.rows[0].size(), table.columns.size());
    EXPECT_EQ(table.rows[1].size(), table.columns.size());
}

TEST(PredictionTest, WithoutMeasuredValuesGivesTheReason) {
    const auto result = run_study(study_of_nine_pairs(), {1});
    EXPECT_FALSE(result.prediction_test);
    EXPECT_NE(result.prediction_test.reason.find("no pairs"), std::string::npos);
    EXPECT_TRUE(output::to_json(result).at("prediction_test").is_null());
}

TEST(PredictionCurve, PassesThroughThePredictionsOfPairs) {
    const auto study = study_of_nine_pairs();
    const auto result = run_study(study, {1});
    for (const auto& pair : result.pairs) {
        ASSERT_TRUE(pair.modified);
        const auto& surface = result.surface(pair.surface);
        const auto curve =
            adhesion::prediction_curve({surface.name, surface.used().parameters, surface.used().spread},
                                       TracedValue(study.elastomers[0].surface_energy, "surface energy"),
                                       TracedValue(*study.work_of_adhesion, "work_of_adhesion"),
                                       Array1D::Constant(1, result.elastomer(pair.elastomer).contact_modulus.value));
        EXPECT_NEAR(curve.work_of_adhesion[0], pair.modified->work.floored, 1e-15);
        // the pair's error without that of its modulus, normal
        const double error =
            std::sqrt(pair.modified->estimate.variance() - pair.budget->modulus * pair.budget->modulus);
        EXPECT_NEAR(curve.upper[0] - curve.work_of_adhesion[0], 1.959964 * error, 1e-4 * error);
    }
}

}  // namespace
}  // namespace setae::study::prediction_residuals_test
