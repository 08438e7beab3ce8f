// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::force_drift_test {
namespace {

using tests::rubber_on_diamond;
using tests::SyntheticLoop;

const SyntheticLoop smooth{.samples = 400};
constexpr double rate = 2e-8;  // N/s

Loop drifting() {
    Loop loop = smooth.make();
    loop.force += rate * loop.time + 3e-5;
    return loop;
}

AnalysisOptions with(DriftModel drift) { return {.segments = {.drift = drift}}; }

bool has(const LoopAnalysis& analysis, const std::string& code) {
    return std::any_of(analysis.alerts.begin(), analysis.alerts.end(),
                       [&](const Alert& alert) { return alert.code == code; });
}

double pull_off_of(const SyntheticLoop& shape) {
    return -contact::jkr::pull_off_at_fixed_load(shape.retraction()).force;
}

TEST(ForceDrift, IsMeasuredInFreeFlightWithItsError) {
    double pulls = 0.0;
    constexpr int seeds = 100;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        Loop loop = drifting();
        loop.force = tests::with_noise(loop.force, 1e-7, generator);
        const Estimate change = analyse(loop, rubber_on_diamond()).force_zero.drift.change;
        const double true_change = rate * (loop.time[loop.time.size() - 1] - loop.time[0]);
        pulls += std::pow((change.value - true_change) / change.standard_error, 2) / seeds;
    }
    // the mean square of 100 pulls is 1 ± 0.14
    EXPECT_NEAR(std::sqrt(pulls), 1.0, 0.25);
}

TEST(ForceDrift, OfAnySizeDoesNotChangeResults) {
    std::mt19937_64 generator(3);
    const SyntheticLoop rough{.retraction_work = 0.06, .samples = 300};
    Loop flat = rough.make();
    flat.contact_radius = Array1D();
    const double pull = pull_off_of(rough);
    flat.force = tests::with_noise(flat.force, 0.01 * pull, generator);
    const LoopAnalysis expected = analyse(flat, rubber_on_diamond());
    for (const double share : {-1.0, -0.3, 0.033, 0.1, 1.0, 3.0}) {
        Loop loop = flat;
        loop.force += share * pull * loop.time / loop.time[loop.time.size() - 1] - 2.0 * pull;
        const LoopAnalysis found = analyse(loop, rubber_on_diamond());
        const auto same = [&](const Estimate& one, const Estimate& other) {
            EXPECT_NEAR(one.value, other.value, 0.01 * other.standard_error) << share;
        };
        same(found.loading.primary().contact_modulus, expected.loading.primary().contact_modulus);
        same(found.loading.primary().work_of_adhesion, expected.loading.primary().work_of_adhesion);
        ASSERT_TRUE(found.unloading) << share;
        same(found.unloading->primary().work_of_adhesion, expected.unloading->primary().work_of_adhesion);
        same(found.loop->estimate(), expected.loop->estimate());
        same(found.pull_off->work_of_adhesion, expected.pull_off->work_of_adhesion);
        EXPECT_EQ(has(found, "FORCE_DRIFT"), std::abs(share) > 0.05) << share;
    }
}

TEST(ForceDrift, WithCurvatureIsFittedByACurve) {
    const SyntheticLoop shape{.samples = 300};
    Loop flat = shape.make();
    flat.contact_radius = Array1D();
    const double pull = pull_off_of(shape), work = 0.040;
    for (const double share : {0.2, 1.0}) {
        std::mt19937_64 generator(5);
        Loop loop = flat;
        const Array1D tau = loop.time / loop.time[loop.time.size() - 1];
        loop.force = tests::with_noise(flat.force + share * pull * tau.square(), 0.005 * pull, generator);
        const LoopAnalysis found = analyse(loop, rubber_on_diamond());
        const Estimate& loading = found.loading.primary().work_of_adhesion;
        EXPECT_EQ(found.force_zero.drift.degree, 2) << share;
        EXPECT_TRUE(has(found, "DRIFT_NOT_LINEAR")) << share;
        EXPECT_NEAR(loading.value, work, 3.0 * loading.standard_error) << share;
        EXPECT_NEAR(loading.value, work, 0.02 * work) << share;
        const Estimate by_line =
            analyse(loop, rubber_on_diamond(), with(DriftModel::linear)).loading.primary().work_of_adhesion;
        EXPECT_GT(std::abs(by_line.value - work), 2.0 * by_line.standard_error) << share;
    }
}

TEST(ForceDrift, FollowsTheRequestedModel) {
    // the sensor drifts until the last press and stands still from there on: the line between the baselines is wrong
    Loop loop = smooth.make();
    const Index peak = 2 * smooth.samples + 1;
    loop.force += rate * loop.time.min(loop.time[peak]);
    const auto error_of = [&](DriftModel model) {
        return std::abs(
            analyse(loop, rubber_on_diamond(), with(model)).loading.radius_force->work_of_adhesion.value / 0.040 - 1.0);
    };
    EXPECT_LT(error_of(DriftModel::extrapolated), 1e-8);
    EXPECT_GT(error_of(DriftModel::linear), 1e-4);
    EXPECT_GT(error_of(DriftModel::constant), 1e-5);
    for (const DriftModel model : {DriftModel::automatic, DriftModel::constant, DriftModel::linear,
                                   DriftModel::quadratic, DriftModel::cubic, DriftModel::extrapolated})
        EXPECT_EQ(drift_model_named(to_string(model)), model);
    EXPECT_THROW((void)drift_model_named("line"), InvalidArgument);
}

TEST(ForceDrift, OfTheWholeRecordIsRemovedByEitherModel) {
    const Loop loop = drifting();
    const double energy = analyse(smooth.make(), rubber_on_diamond()).loop->energy;
    for (const DriftModel model : {DriftModel::automatic, DriftModel::extrapolated}) {
        const LoopAnalysis analysis = analyse(loop, rubber_on_diamond(), with(model));
        EXPECT_NEAR(analysis.loading.radius_force->work_of_adhesion.value / 0.040, 1.0, 1e-8);
        EXPECT_NEAR(analysis.loop->energy / energy, 1.0, 1e-6);
        EXPECT_GT(std::abs(analysis.loop->without_drift / analysis.loop->energy - 1.0), 1e-4);
    }
}

TEST(ForceDrift, PropagatesItsErrorToTheEnergy) {
    // the energy changes with every mode of the zero as in its error budget
    std::mt19937_64 generator(2);
    Loop loop = smooth.make();
    loop.force = tests::with_noise(loop.force, 1e-6, generator);
    const LoopAnalysis found = analyse(loop, rubber_on_diamond());
    ASSERT_EQ(found.force_zero.modes.cols(), 2);
    const Index first = found.segments.before.range->last, last = found.segments.after->range->first;
    double squares = 0.0;
    for (Index mode = 0; mode < 2; ++mode) {
        double work = 0.0;
        for (Index i = first; i < last; ++i)
            work += 0.5 * (found.force_zero.modes(i, mode) + found.force_zero.modes(i + 1, mode)) *
                    (loop.displacement[i + 1] - loop.displacement[i]);
        squares += work * work;
    }
    EXPECT_NEAR(found.loop->standard_error.drift / std::sqrt(squares), 1.0, 1e-9);
}

TEST(ForceDrift, OfOneStretchIsExtrapolatedWithItsError) {
    const SyntheticLoop shape{.samples = 300};
    const Loop whole = shape.make();
    const Index peak = 2 * shape.samples + 1;
    double pulls = 0.0;
    constexpr int seeds = 60;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(100 + seed));
        Loop loop = tests::piece(whole, 0, peak + 1);
        loop.contact_radius = Array1D();
        loop.force = tests::with_noise(loop.force + 1e-7 * loop.time, 0.01 * pull_off_of(shape), generator);
        const LoopAnalysis found = analyse(loop, rubber_on_diamond());
        EXPECT_TRUE(has(found, "ONE_BASELINE"));
        const Estimate& work = found.loading.primary().work_of_adhesion;
        pulls += std::pow((work.value - 0.040) / work.standard_error, 2) / seeds;
    }
    EXPECT_NEAR(std::sqrt(pulls), 1.0, 0.3);  // of 60 pulls 1 ± 0.09
}

TEST(FreeFlight, IsSplitAtStepsOfTheForce) {
    const SyntheticLoop shape{.samples = 300};
    const double pull = pull_off_of(shape);
    std::mt19937_64 generator(7);
    Loop loop = shape.make();
    loop.contact_radius = Array1D();
    loop.force = tests::with_noise(loop.force, 0.01 * pull, generator);
    loop.force.head(150) += 0.2 * pull;
    const LoopAnalysis found = analyse(loop, rubber_on_diamond());
    ASSERT_EQ(found.segments.steps.size(), 1u);
    EXPECT_NEAR(static_cast<double>(found.segments.steps.front().sample), 149.0, 2.0);
    EXPECT_NEAR(found.segments.steps.front().size, -0.2 * pull, 0.02 * pull);
    EXPECT_TRUE(has(found, "STEP_IN_FREE_FLIGHT"));
    EXPECT_GE(found.segments.before.range->first, 148);
    const Estimate& work = found.loading.primary().work_of_adhesion;
    EXPECT_NEAR(work.value, 0.040, 3.0 * work.standard_error);
}

TEST(FreeFlight, WithoutStepsIsNotSplit) {
    const SyntheticLoop shape{.samples = 300};
    int cut = 0;
    for (int seed = 0; seed < 100; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        Loop loop = shape.make();
        loop.force = tests::with_noise(loop.force, 0.01 * pull_off_of(shape), generator);
        if (!find_segments(loop).steps.empty()) ++cut;
    }
    EXPECT_EQ(cut, 0);
}

TEST(Contact, ReportsStepsOfTheForce) {
    const SyntheticLoop shape{.samples = 400};
    const double pull = pull_off_of(shape);
    std::mt19937_64 generator(11);
    Loop loop = shape.make();
    loop.contact_radius = Array1D();
    loop.force = tests::with_noise(loop.force, 0.005 * pull, generator);
    EXPECT_TRUE(analyse(loop, rubber_on_diamond()).steps_in_contact.empty());
    const Index at = shape.samples + 200;
    loop.force.tail(loop.force.size() - at) += 0.2 * pull;
    const LoopAnalysis found = analyse(loop, rubber_on_diamond());
    ASSERT_EQ(found.steps_in_contact.size(), 1u);
    EXPECT_NEAR(static_cast<double>(found.steps_in_contact.front().sample), static_cast<double>(at - 1), 2.0);
    EXPECT_TRUE(has(found, "STEP_IN_CONTACT"));
}

TEST(DisplacementDrift, IsRemovedAtAKnownRate) {
    Loop loop = smooth.make();
    loop.displacement += 1e-9 * loop.time;
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond(), {.displacement_drift_rate = 1e-9});
    EXPECT_NEAR(analysis.loading.force_displacement->work_of_adhesion.value / 0.040, 1.0, 1e-7);
    EXPECT_GT(
        std::abs(analyse(loop, rubber_on_diamond()).loading.force_displacement->work_of_adhesion.value / 0.040 - 1.0),
        1e-4);
    loop.time = Array1D();
    EXPECT_THROW((void)analyse(loop, rubber_on_diamond(), {.displacement_drift_rate = 1e-9}), InvalidArgument);
}

}  // namespace
}  // namespace setae::loops::force_drift_test
