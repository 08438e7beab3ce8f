// SPDX-License-Identifier: GPL-3.0-or-later
// One surface and one elastomer have one work of adhesion, whichever command is asked.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/answers/adhesion_fields.hpp"
#include "setae/answers/patch_survey_fields.hpp"
#include "setae/core/constants.hpp"
#include "setae/hysteresis/smooth_limit.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/study/hysteresis.hpp"
#include "setae/study/study_result.hpp"

namespace setae::answers::consistent_prediction_test {
namespace {

constexpr double work = 0.040, gamma_1 = 0.025;

/// A self-affine surface from published moments, on an elastomer of that modulus.
study::Study study_of(double youngs_modulus, double roughness = 1.0) {
    study::Study study;
    study::SurfaceInput surface;
    surface.name = "A";
    surface.moments = study::PublishedMoments{.rms_height = {roughness * 20e-9, 0.0, "given"},
                                              .rms_slope = {roughness * 0.2, 0.0, "given"},
                                              .rms_curvature = {roughness * 1e8, 0.0, "given"},
                                              .short_wavevector = {2e9}};
    study.surfaces = {surface};
    study::ElastomerInput elastomer;
    elastomer.name = "soft solid";
    elastomer.youngs_modulus = {youngs_modulus, 0.0, "given"};
    elastomer.surface_energy = {gamma_1, 0.0, "given"};
    elastomer.sphere_radius = Estimate{5e-3, 0.0};
    elastomer.preload = 1e-3;
    study.elastomers = {elastomer};
    study.counter_youngs_modulus = std::numeric_limits<double>::infinity();
    study.work_of_adhesion = Estimate{work, 0.0, "given"};
    return study;
}

Adhesion adhesion_of(const study::Study& study) {
    AdhesionRequest request;
    request.youngs_modulus = std::to_string(study.elastomers.front().youngs_modulus.value) + " Pa";
    request.work = "40 mJ/m2";
    request.surface_energy = "25 mJ/m2";
    request.radius = "5 mm";
    request.preload = "1 mN";
    return adhesion({.surface = study::analyse_surface(study.surfaces.front(), study.analysis, {1}), .map = {}},
                    study.analysis, request);
}

double recommended_in(const output::Json& answers) {
    for (const auto& theory : answers["theories"])
        if (theory["theory"] == answers["recommended"] && theory["recommended"])
            return theory["work_of_adhesion"]["value"].get<double>();
    ADD_FAILURE() << "no theory is recommended";
    return NAN;
}

PatchSurveyRequest few_patches() {
    PatchSurveyRequest request;
    request.points = {32};
    request.points_per_wave = {8.0};
    request.waves_per_side = 2;
    request.squared_ratios = {1.0};
    request.seeds = 1;
    return request;
}

TEST(ConsistentPrediction, IsTheSameInEveryCommand) {
    for (const double modulus : {1e6, 1.2e8, 2.5e8}) {  // full contact, part of the area, little of it
        const auto study = study_of(modulus);
        const auto result = study::run_study(study, {1});
        const auto& pair = result.pairs.at(0);
        ASSERT_TRUE(pair.partial_contact);
        const double answer = pair.partial_contact->value;
        const auto adhesion = output::described(adhesion_of(study));
        EXPECT_NEAR(adhesion["work_of_adhesion"]["value"].get<double>(), answer, 1e-9 * answer);
        EXPECT_NEAR(recommended_in(adhesion["answers"]), answer, 1e-9 * answer);
        const auto of_study = output::to_json(result);
        EXPECT_NEAR(recommended_in(of_study["pairs"][0]["answers"]), answer, 1e-12 * answer);
        const auto hysteresis = study::hysteresis_of(result);
        EXPECT_NEAR(hysteresis.pairs.at(0).work_approach.value, answer, 1e-12 * answer);
        const auto conform = output::described(patch_survey(result, few_patches()));
        EXPECT_NEAR(recommended_in(conform["rows"][0]["answers"]), answer, 1e-12 * answer);
    }
}

TEST(ConsistentPrediction, IsListedWithOtherTheories) {
    const auto study = study_of(1.2e8);
    const auto json = output::described(adhesion_of(study))["answers"];
    ASSERT_EQ(json["theories"].size(), 3U);
    const double e = [&] {
        const auto pair = study::run_study(study, {1}).pairs.at(0);
        return pair.stored_energy.value / (pair.stored_energy.value + pair.modified->work.raw);
    }();
    EXPECT_GT(e, 0.3) << "a pair that full contact does not describe";
    EXPECT_LT(e, 1.0);
    for (const auto& theory : json["theories"]) {
        EXPECT_FALSE(theory["assumes"].get<std::string>().empty());
        EXPECT_GE(theory["work_of_adhesion"]["value"].get<double>(), 0.0);
        const double area = theory["area_fraction"]["value"].get<double>();
        EXPECT_EQ(area < 1.0, theory["theory"] != "full_contact") << theory["theory"];
    }
}

// in full contact all theories are the full-contact balance
TEST(ConsistentPrediction, EqualsEveryTheoryInFullContact) {
    const auto json = output::described(adhesion_of(study_of(1e6)));
    const double balance = json["work_of_adhesion_modified"]["value"].get<double>();
    EXPECT_TRUE(json["conforms"].get<bool>());
    EXPECT_EQ(json["contact"], "spontaneous full contact");
    for (const auto& theory : json["answers"]["theories"])
        EXPECT_NEAR(theory["work_of_adhesion"]["value"].get<double>(), balance, 2e-3 * balance) << theory["theory"];
}

// every printed pull-off: 3/2 πRW of JKR as the roughness tends to zero
TEST(ConsistentPrediction, TendsToJkrInEveryCommandWithAPullOff) {
    const double force = 1.5 * pi * 5e-3 * work;
    for (const double roughness : {1e-2, 1e-3}) {
        const auto study = study_of(1.5e6, roughness);
        const auto json = output::described(adhesion_of(study));
        EXPECT_NEAR(json["pull_off_force"]["value"].get<double>(), force, 5.0 * roughness * roughness * force);
        EXPECT_GT(json["conformal_smooth_sphere_pull_off_force"]["value"].get<double>(), 1.5 * force);
        const auto result = study::run_study(study, {1});
        const auto of_study = output::to_json(result)["pairs"][0]["loop"];
        EXPECT_NEAR(of_study["pull_off_force"]["value"].get<double>(), force, 5.0 * roughness * roughness * force);
        const auto hysteresis = study::hysteresis_of(result);
        const auto& predicted = hysteresis.pairs.at(0);
        EXPECT_EQ(predicted.choice, study::ModelChoice::assumed);
        EXPECT_NEAR(predicted.pull_off_force->value, force, 5.0 * roughness * roughness * force);
        ASSERT_TRUE(predicted.loop);
        EXPECT_NEAR(predicted.loop->pull_off_force.value, force, 5.0 * roughness * roughness * force);
    }
}

/// The published pairs, whose likeliest model has no smooth limit, and a nearly smooth surface without measurements.
study::StudyResult published_with(double roughness) {
    auto study = study::read_study("examples/nanodiamond/published.toml");
    auto smooth = study_of(1e6, roughness).surfaces.front();
    smooth.name = "smooth";
    study.surfaces.push_back(smooth);
    return study::run_study(study, {});
}

// with measured pairs, too: 3/2 πR W_int by models without the crack tip, times W_ret/W_app of the reference by others
TEST(ConsistentPrediction, TendsToJkrWithAModelChosenByPairs) {
    for (const double roughness : {1e-2, 1e-3}) {
        const auto result = published_with(roughness);
        ASSERT_TRUE(result.hysteresis) << result.hysteresis.reason;
        const auto& h = *result.hysteresis;
        int found = 0;
        for (const auto& pair : h.pairs) {
            EXPECT_TRUE(hysteresis::has_smooth_limit(pair.model)) << pair.model.name();
            if (pair.surface != "smooth") continue;
            ++found;
            EXPECT_NE(pair.choice, study::ModelChoice::assumed);
            ASSERT_TRUE(pair.tip_factor && pair.loop && pair.pull_off_force);
            const auto* chosen = h.conforming.best_with_smooth_limit();
            ASSERT_TRUE(chosen && chosen->fitted.model == pair.model);
            const double W = chosen->fitted.work_of_adhesion ? chosen->fitted.work_of_adhesion->value
                                                             : result.work_of_adhesion->value;
            const double factor = pair.model.tip == hysteresis::Tip::none ? 1.0 : pair.tip_factor->value;
            const double force = 1.5 * pi * 1.25e-3 * factor * W, error = 10.0 * roughness * roughness * force;
            EXPECT_NEAR(pair.pull_off_force->value, force, error);
            EXPECT_NEAR(pair.loop->pull_off_force.value, force, error);
            // beside it, named, the likeliest: it puts a work on the true area of a mirror, too
            ASSERT_TRUE(pair.likelier);
            EXPECT_FALSE(hysteresis::has_smooth_limit(pair.likelier->model));
            EXPECT_GT(pair.likelier->pull_off_force->value, 1.1 * force);
        }
        EXPECT_EQ(found, 4);
        const auto json = output::to_json(result);
        for (const auto& pair : json["pairs"])
            if (pair["surface"] == "smooth" && pair["loop"].is_object()) {
                EXPECT_NEAR(pair["loop"]["pull_off_force"]["value"].get<double>(),
                            1.5 * pi * 1.25e-3 * result.work_of_adhesion->value, 10.0 * roughness * roughness * 3e-4);
            }
    }
}

}  // namespace
}  // namespace setae::answers::consistent_prediction_test
