// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "setae/core/errors.hpp"
#include "setae/loops/reference_loop.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::analysis_test {
namespace {

using tests::rubber_on_diamond;
using tests::SyntheticLoop;

const SyntheticLoop rough{.retraction_work = 0.07, .samples = 800};

bool has_alert(const LoopAnalysis& analysis, const std::string& code) {
    return std::any_of(analysis.alerts.begin(), analysis.alerts.end(),
                       [&](const Alert& alert) { return alert.code == code; });
}

/// Sampled retraction begins where the edge lets go: the pinned section is no equilibrium.
Loop without_pinned_stretch(const SyntheticLoop& shape) {
    const Loop loop = shape.make();
    const Index first = 2 * shape.samples + 2, next = 3 * shape.samples + 1;
    const Loop pressed = tests::piece(loop, 0, first), released = tests::from(loop, next);
    const auto both = [](const Array1D& a, const Array1D& b) {
        Array1D all(a.size() + b.size());
        all << a, b;
        return all;
    };
    return {.time = both(pressed.time, released.time),
            .force = both(pressed.force, released.force),
            .displacement = both(pressed.displacement, released.displacement),
            .contact_radius = both(pressed.contact_radius, released.contact_radius)};
}

TEST(Analysis, RecoversBothBranchesOfASyntheticLoop) {
    const LoopAnalysis analysis = analyse(without_pinned_stretch(rough), rubber_on_diamond());
    const BranchAnalysis& loading = analysis.loading;
    for (const auto* fit : {&*loading.radius_force, &*loading.linear_form, &*loading.force_displacement}) {
        EXPECT_NEAR(fit->contact_modulus.value / 0.92e6, 1.0, 1e-8) << fit->method;
        EXPECT_NEAR(fit->work_of_adhesion.value / 0.040, 1.0, 1e-8) << fit->method;
    }
    EXPECT_NEAR(analysis.loading.pointwise->contact_modulus.value / 0.92e6, 1.0, 1e-8);
    EXPECT_EQ(analysis.loading.range.first, 804);
    EXPECT_EQ(analysis.loading.range.n, 798);
    EXPECT_EQ(analysis.loading.sensitivity.size(), 4u);
    EXPECT_NEAR(analysis.retraction->work_of_adhesion.value / 0.070, 1.0, 1e-6);
    EXPECT_EQ(analysis.retraction->n, 6);
    // the smallest of the sampled forces lies within a step of the fold
    EXPECT_NEAR(analysis.pull_off->work_of_adhesion.value / 0.070, 1.0, 1e-5);
    // its last sample is the fold of fixed grips: −5/6 πRW after −3/2 πRW
    EXPECT_NEAR(analysis.pull_off->last_force.value / analysis.pull_off->force.value, 5.0 / 9.0, 1e-5);
    ASSERT_TRUE(analysis.pull_off->work_of_adhesion_fixed_grips);
    EXPECT_NEAR(analysis.pull_off->work_of_adhesion_fixed_grips->value / 0.070, 1.0, 1e-8);
    EXPECT_EQ(analysis.pull_off->machine_stiffness, INFINITY);
    EXPECT_NEAR(analysis.loop->energy / rough.loss(), 1.0, 1e-4);
    EXPECT_NEAR(analysis.context.ideal_smooth_sphere_loss, contact::jkr::ideal_loop_loss(rough.approach).total,
                1e-7 * rough.loss());
    EXPECT_NEAR(analysis.context.largest_contact_radius / rough.largest_radius, 1.0, 1e-8);
    EXPECT_TRUE(analysis.context.radius_measured);
    EXPECT_LT(analysis.loading.primary().relative_residual, 1e-8);
    EXPECT_FALSE(has_alert(analysis, "POOR_FIT"));
}

TEST(Analysis, FitsTheRetractionAfterThePinnedStretch) {
    Loop loop = rough.make();
    const Index peak = 2 * rough.samples + 1, released = 3 * rough.samples + 1;
    for (const bool radius_measured : {true, false}) {
        if (!radius_measured) loop.contact_radius = Array1D();
        const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
        ASSERT_TRUE(analysis.pinned) << radius_measured;
        EXPECT_EQ(analysis.pinned->first, peak);
        // where the edge lets go, give or take the rounding of a, 1e-6, over that of a step of the branch; without
        // radius behind it by what 1 % of the force hides
        EXPECT_GE(analysis.pinned->last, released - 1) << radius_measured;
        EXPECT_LE(analysis.pinned->last, released + (radius_measured ? 1 : rough.samples / 20)) << radius_measured;
        const JkrFit& fit = *analysis.unloading->force_displacement;
        // the sample of the smallest force may lie a step beyond the fold of δ(F), where the fit expects the other
        // branch
        EXPECT_NEAR(fit.work_of_adhesion.value / 0.070, 1.0, 1e-4);
        EXPECT_NEAR(fit.contact_modulus.value / 0.92e6, 1.0, 1e-4);
        EXPECT_FALSE(has_alert(analysis, "POOR_FIT"));
    }
}

TEST(Analysis, RemovesForceDriftFromBothBranches) {
    Loop loop = without_pinned_stretch(rough);
    const LoopAnalysis level = analyse(loop, rubber_on_diamond());
    loop.force += 1e-8 * loop.time;
    const LoopAnalysis drifting = analyse(loop, rubber_on_diamond());
    EXPECT_NEAR(drifting.loading.primary().work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_NEAR(drifting.unloading->force_displacement->work_of_adhesion.value / 0.070, 1.0, 1e-6);
    // the drift of a step, 1 nN, may make the neighbour the smallest sample
    EXPECT_NEAR(drifting.pull_off->work_of_adhesion.value / level.pull_off->work_of_adhesion.value, 1.0, 1e-5);
    EXPECT_NEAR(drifting.loop->energy / level.loop->energy, 1.0, 1e-8);
}

TEST(Analysis, UsesTheLastFramesBeforePullOffOfASlowCamera) {
    Loop loop = without_pinned_stretch(rough);
    for (Index i = 0; i < loop.contact_radius.size(); ++i)
        if (i % 10 != 0) loop.contact_radius[i] = undefined;
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
    ASSERT_TRUE(analysis.retraction) << analysis.retraction.reason;
    EXPECT_EQ(analysis.retraction->n, 6);
    EXPECT_EQ(analysis.retraction->last - analysis.retraction->first, 50);
    EXPECT_NEAR(analysis.retraction->work_of_adhesion.value / 0.070, 1.0, 1e-6);
}

TEST(Analysis, DoesNotUseTheLargestOfNoisyFrames) {
    std::mt19937_64 generator(5);
    constexpr double noise = 1e-6;
    Loop loop = without_pinned_stretch(rough);
    const Array1D noisy = tests::with_noise(loop.contact_radius, noise, generator);
    loop.contact_radius = (loop.contact_radius > 0.0).select(noisy.max(0.0), loop.contact_radius);
    const double radius = analyse(loop, rubber_on_diamond()).context.largest_contact_radius;
    EXPECT_GT(loop.contact_radius.maxCoeff() - rough.largest_radius, noise);
    // the mean of five frames, within three of its standard errors
    EXPECT_NEAR(radius, rough.largest_radius, 3.0 * noise / std::sqrt(5.0));
}

TEST(Analysis, WorksWithoutContactRadius) {
    Loop loop = without_pinned_stretch(rough);
    loop.contact_radius = Array1D();
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
    EXPECT_EQ(analysis.loading.primary().method, "force_displacement");
    EXPECT_FALSE(analysis.loading.radius_force);
    EXPECT_NE(analysis.loading.radius_force.reason.find("contact radius"), std::string::npos);
    EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_NEAR(analysis.context.largest_contact_radius / rough.largest_radius, 1.0, 1e-7);
    EXPECT_LT((analysis.loading.energy_release_rate.energy_release_rate / 0.040 - 1.0).abs().maxCoeff(), 1e-5);
}

TEST(Analysis, WorksWithoutDisplacement) {
    Loop loop = without_pinned_stretch(rough);
    loop.displacement = Array1D();
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
    EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_FALSE(analysis.loop);
    EXPECT_NE(analysis.loop.reason.find("displacement"), std::string::npos);
}

TEST(Analysis, IgnoresMissingFrames) {
    Loop loop = without_pinned_stretch(rough);
    loop.contact_radius[900] = undefined;
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
    EXPECT_EQ(analysis.loading.range.n, 797);
    EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / 0.040, 1.0, 1e-8);
}

TEST(Analysis, SubtractsTheMachineDeflectionFromTheStage) {
    constexpr double stiffness = 250.0;
    Loop loop = without_pinned_stretch(rough);
    loop.displacement += loop.force / stiffness;
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond(), {.machine_stiffness = stiffness});
    EXPECT_NEAR(analysis.loading.force_displacement->contact_modulus.value / 0.92e6, 1.0, 1e-8);
    const LoopAnalysis uncorrected = analyse(loop, rubber_on_diamond());
    EXPECT_GT(std::abs(uncorrected.loading.force_displacement->contact_modulus.value / 0.92e6 - 1.0), 0.01);
    EXPECT_THROW((void)analyse(loop, rubber_on_diamond(), {.machine_stiffness = 0.0}), InvalidArgument);
}

TEST(Analysis, FitsTheModulusOfTheRetractionOnRequest) {
    const LoopAnalysis analysis =
        analyse(without_pinned_stretch(rough), rubber_on_diamond(), {.retraction_modulus_free = true});
    EXPECT_NEAR(analysis.retraction->contact_modulus.value / 0.92e6, 1.0, 1e-6);
    EXPECT_NEAR(analysis.retraction->work_of_adhesion.value / 0.070, 1.0, 1e-6);
    EXPECT_TRUE(analysis.retraction->modulus_free);
}

TEST(Analysis, PrefersEffectiveVarianceIfBothErrorsAreKnown) {
    std::mt19937_64 generator(2);
    Loop loop = without_pinned_stretch(rough);
    loop.force = tests::with_noise(loop.force, 1e-7, generator);
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond(), {.contact_radius_noise = 1e-8});
    EXPECT_EQ(analysis.loading.primary().method, "radius_force_effective_variance");
    EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / 0.040, 1.0, 0.01);
    const LoopAnalysis plain =
        analyse(loop, rubber_on_diamond(), {.effective_variance = false, .contact_radius_noise = 1e-8});
    EXPECT_EQ(plain.loading.primary().method, "radius_force");
}

TEST(Analysis, OfALoadingOnlyGivesTheReasonForNoLoop) {
    const LoopAnalysis analysis = analyse(tests::piece(rough.make(), 0, 1602), rubber_on_diamond());
    EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_FALSE(analysis.unloading);
    EXPECT_FALSE(analysis.pull_off);
    EXPECT_FALSE(analysis.retraction);
    EXPECT_FALSE(analysis.loop);
    EXPECT_NE(analysis.loop.reason.find("the loop is not closed"), std::string::npos);
    EXPECT_TRUE(has_alert(analysis, "NO_RETRACTION"));
    EXPECT_THROW((void)evaluate_reference(analysis), UndefinedDataError);
}

TEST(Analysis, WarnsOfGeometryAndRange) {
    LensAndCounterBody bodies = rubber_on_diamond();
    bodies.layer_thickness = 500e-6;
    AnalysisOptions options;
    options.interaction_range.value = 1e-3;
    options.limits.contact_radius_per_sphere_radius = 0.05;
    const LoopAnalysis analysis = analyse(rough.make(), bodies, options, "spot 3");
    for (const char* code : {"THIN_LAYER", "TABOR_RANGE", "LARGE_STRAIN"})
        EXPECT_TRUE(has_alert(analysis, code)) << code;
    EXPECT_EQ(analysis.alerts.front().subject, "spot 3");
}

// mu ∝ (W/E*)^(2/3)/z0
TEST(Analysis, PropagatesErrorsToTheTaborParameter) {
    AnalysisOptions options;
    const auto mu_of = [&](double share) {
        options.interaction_range.standard_error = share * options.interaction_range.value;
        const auto analysis = analyse(rough.make(), rubber_on_diamond(), options);
        return std::pair(analysis.context.tabor_parameter, analysis.loading.primary());
    };
    const auto [of_fit, fit] = mu_of(0.0);
    const auto with_range = mu_of(0.1).first;
    const double modulus = fit.contact_modulus.standard_error / fit.contact_modulus.value,
                 work = fit.work_of_adhesion.standard_error / fit.work_of_adhesion.value,
                 ratio = std::sqrt(modulus * modulus + work * work - 2.0 * fit.correlation * modulus * work);
    ASSERT_GT(ratio, 0.0);
    EXPECT_NEAR(of_fit.standard_error / of_fit.value, 2.0 / 3.0 * ratio, 1e-12);
    EXPECT_EQ(with_range.value, of_fit.value);
    EXPECT_NEAR(with_range.standard_error / with_range.value, std::hypot(2.0 / 3.0 * ratio, 0.1), 1e-12);
}

TEST(Analysis, WarnsOfInconsistentContactPoints) {
    Loop loop = without_pinned_stretch(rough);
    for (Index i = 1602; i < loop.displacement.size(); ++i) loop.displacement[i] -= 2e-6;
    EXPECT_TRUE(has_alert(analyse(loop, rubber_on_diamond()), "CONTACT_POINT_SPREAD"));
    EXPECT_FALSE(has_alert(analyse(without_pinned_stretch(rough), rubber_on_diamond()), "CONTACT_POINT_SPREAD"));
}

TEST(Analysis, WarnsOfACoarselySampledLoop) {
    const SyntheticLoop coarse{.samples = 8};
    EXPECT_TRUE(has_alert(analyse(coarse.make(), rubber_on_diamond()), "LOOP_UNDERSAMPLED"));
    EXPECT_FALSE(has_alert(analyse(rough.make(), rubber_on_diamond()), "LOOP_UNDERSAMPLED"));
}

TEST(ReferenceLoop, OfASmoothSphereLosesTheJumpsOnly) {
    std::mt19937_64 generator(4);
    const SyntheticLoop smooth{.samples = 2000};
    Loop loop = smooth.make();
    loop.displacement = tests::with_noise(loop.displacement, 1e-10, generator);
    const ReferenceLoop reference = evaluate_reference(analyse(loop, rubber_on_diamond()));
    EXPECT_NEAR(reference.work_of_adhesion_loading.value / 0.040, 1.0, 1e-3);
    EXPECT_NEAR(reference.work_of_adhesion_retraction.value / 0.040, 1.0, 1e-3);
    EXPECT_NEAR(reference.excess_energy.value / reference.ideal_loss, 1.0, 1e-3);
    EXPECT_LT(std::abs(reference.beyond_ideal), 1e-3 * reference.ideal_loss);
    const Array1D ratio = loss_ratios(Array1D::Constant(1, 10.0 * smooth.loss()), {reference, reference});
    EXPECT_NEAR(ratio[0], 10.0, 0.01);
    EXPECT_EQ(change(reference, reference).excess_energy.value, 0.0);
    EXPECT_THROW((void)loss_ratios(Array1D::Ones(1), {}), UndefinedDataError);
}

}  // namespace
}  // namespace setae::loops::analysis_test
