// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "setae/core/estimate.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/simulation/loop_simulation.hpp"

/// What the analysis of a contact experiment finds in loops whose every property is known.
namespace setae::simulation::loop_recovery_test {
namespace {

constexpr hysteresis::HystereticSphere rough{
    .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.040, .work_retraction = 0.075};
constexpr LoopArtefacts noise{.force_noise = 1e-7, .displacement_noise = 5e-10, .radius_noise = 1e-7};

loops::LoopAnalysis analysed(const loops::Loop& loop, const hysteresis::HystereticSphere& specimen) {
    return loops::analyse(
        loop, {.radius = specimen.radius, .counter_youngs_modulus = std::numeric_limits<double>::infinity()});
}

bool has_alert(const loops::LoopAnalysis& analysis, const std::string& code) {
    return std::any_of(analysis.alerts.begin(), analysis.alerts.end(),
                       [&](const Alert& alert) { return alert.code == code; });
}

TEST(LoopRecovery, RecoversTrueValuesWithoutNoise) {
    for (const double stiffness : {300.0, std::numeric_limits<double>::infinity()}) {
        const SimulatedLoop made = simulated_loop(rough, {.hold_time = 5.0, .machine_stiffness = stiffness});
        const loops::LoopAnalysis analysis = analysed(made.loop, rough);
        EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / rough.work_approach, 1.0, 1e-8);
        EXPECT_NEAR(analysis.loading.primary().contact_modulus.value / rough.contact_modulus, 1.0, 1e-8);
        EXPECT_NEAR(analysis.unloading->primary().work_of_adhesion.value / rough.work_retraction, 1.0, 1e-6);
        EXPECT_NEAR(analysis.unloading->primary().contact_modulus.value / rough.contact_modulus, 1.0, 1e-6);
        EXPECT_NEAR(analysis.retraction->work_of_adhesion.value / rough.work_retraction, 1.0, 1e-6);
        // the smallest sample lies within a step of the fold, or of the instability of the spring
        EXPECT_NEAR(analysis.pull_off->work_of_adhesion.value / rough.work_retraction, 1.0, 3e-4);
        EXPECT_NEAR(analysis.context.largest_contact_radius / made.truth.turning_point.contact_radius, 1.0, 1e-4);
        // each jump falls somewhere within a step: half a step of 6 nm times a force of 4/3 and 5/6 πRW
        EXPECT_NEAR(analysis.loop->energy / made.truth.energy_loss(), 1.0, 1e-3);
        EXPECT_FALSE(has_alert(analysis, "POOR_FIT"));
    }
}

TEST(LoopRecovery, RecoversTheStretchWithPinnedEdge) {
    const SimulatedLoop made = simulated_loop(rough, {});
    const loops::LoopAnalysis analysis = analysed(made.loop, rough);
    ASSERT_TRUE(analysis.pinned);
    EXPECT_NEAR(made.loop.force[analysis.pinned->first], made.truth.turning_point.force, 1e-5);
    // frames come every tenth sample
    constexpr double force_between_frames = 1.6e-5;
    EXPECT_NEAR(made.loop.force[analysis.pinned->last], made.truth.unpinned.force, force_between_frames);
}

// The twentieth part of a long record that is taken for free flight reaches into the contact, which the camera shows a
// frame late: what is no free flight is left out, and the noise stays that of the sensor.
TEST(LoopRecovery, EstimatesNoiseWhereTheContactBeginsEarly) {
    hysteresis::HystereticSphere soft = rough;
    soft.contact_modulus = 0.25e6;
    const SimulatedLoop made = simulated_loop(soft, {.camera_rate = 2.0}, noise);
    const auto touch = static_cast<Index>(10.0 * 2e-6 / 60e-9);
    ASSERT_GT(made.loop.force.size() / 20, touch + 1);
    const loops::LoopAnalysis analysis = analysed(made.loop, soft);
    EXPECT_NEAR(analysis.segments.before.force_noise / noise.force_noise, 1.0, 0.2);
    EXPECT_LE(analysis.segments.before.range->last, touch);
}

// Where W is almost 0, a(F) is vertical at F = 0: least squares in a alone takes noise of the force for the contact,
// errors in both do not.
TEST(LoopRecovery, IsUnbiasedWithoutAdhesionOnlyWithErrorsOfForce) {
    const hysteresis::HystereticSphere dry{
        .radius = 1.25e-3, .contact_modulus = 1.3333e6, .work_approach = 1e-7, .work_retraction = 0.02};
    constexpr int loops = 60;
    double by_radius = 0.0, by_both = 0.0;
    int held_by_radius = 0, held_by_both = 0;
    for (std::uint64_t seed = 1; seed <= loops; ++seed) {
        const SimulatedLoop made =
            simulated_loop(dry, {.camera_rate = 2.0},
                           {.force_noise = 1e-6, .displacement_noise = 5e-10, .radius_noise = 3e-7, .key = {seed, 0}});
        const auto loading = analysed(made.loop, dry).loading;
        const auto add = [&](const Estimate& modulus, double& bias, int& held) {
            bias += (modulus.value / dry.contact_modulus - 1.0) / loops;
            const auto interval = interval_of(modulus);
            held +=
                interval && interval->lower <= dry.contact_modulus && dry.contact_modulus <= interval->upper ? 1 : 0;
        };
        add(loading.radius_force->contact_modulus, by_radius, held_by_radius);
        add(loading.radius_force_effective_variance->contact_modulus, by_both, held_by_both);
    }
    // one loop scatters by 0.25 % with the errors of both, by 1 % without
    EXPECT_GT(by_radius, 3e-3);
    EXPECT_LT(held_by_radius, 45);
    EXPECT_NEAR(by_both, 0.0, 1e-3);
    EXPECT_GE(held_by_both, 51);
}

TEST(LoopRecovery, FindsEqualWorkOnBothBranchesOfASmoothReference) {
    hysteresis::HystereticSphere smooth = rough;
    smooth.work_retraction = smooth.work_approach;
    const loops::LoopAnalysis analysis = analysed(simulated_loop(smooth, {}).loop, smooth);
    EXPECT_FALSE(analysis.pinned);
    EXPECT_NEAR(analysis.unloading->primary().work_of_adhesion.value / smooth.work_approach, 1.0, 1e-6);
    EXPECT_NEAR(analysis.loop->energy / analysis.context.ideal_smooth_sphere_loss, 1.0, 3e-3);
}

/// Coverage of intervals, and deviations of values in units of their standard errors.
struct Coverage {
    int loops = 0;
    int held = 0;
    double deviation = 0.0;

    void add(const Estimate& estimate, double truth) {
        const Interval interval = *interval_of(estimate);
        ++loops;
        held += interval.lower <= truth && truth <= interval.upper ? 1 : 0;
        deviation += (estimate.value - truth) / estimate.standard_error;
    }
};

TEST(LoopRecovery, CoversTrueValuesWithNoiseAndDrift) {
    constexpr int loops = 40;
    std::map<std::string, Coverage> found;
    LoopArtefacts artefacts = noise;
    artefacts.force_drift_rate = 2e-9;
    artefacts.baseline_offset = 2e-5;
    for (std::uint64_t seed = 1; seed <= loops; ++seed) {
        artefacts.key = {.seed = seed};
        // where within a sample the jumps fall is another chance
        const LoadingProtocol protocol{.start_gap =
                                           2e-6 + 6e-9 * numerics::uniform_number({.seed = seed, .stream = 1}, 0)};
        const SimulatedLoop made = simulated_loop(rough, protocol, artefacts);
        const loops::LoopAnalysis analysis = analysed(made.loop, rough);
        EXPECT_FALSE(has_alert(analysis, "POOR_FIT")) << seed;
        const auto add_branch = [&](const std::string& name, const loops::BranchAnalysis& branch, double work) {
            for (const auto* fit : {&branch.radius_force_effective_variance, &branch.force_displacement}) {
                found[name + " W, " + (*fit)->method].add((*fit)->work_of_adhesion, work);
                found[name + " E*, " + (*fit)->method].add((*fit)->contact_modulus, rough.contact_modulus);
            }
        };
        add_branch("loading", analysis.loading, rough.work_approach);
        add_branch("unloading", *analysis.unloading, rough.work_retraction);
        found["retraction W"].add(analysis.retraction->work_of_adhesion, rough.work_retraction);
        found["loss"].add(analysis.loop->estimate(), made.truth.energy_loss());
        // five frames: σ_a/√5; the worst of forty lies within four standard errors
        EXPECT_NEAR(analysis.context.largest_contact_radius, made.truth.turning_point.contact_radius,
                    4.0 * noise.radius_noise / std::sqrt(5.0));
    }
    for (const auto& [name, coverage] : found) {
        // 95 % of 40 loops is 38 ± 1.4: fewer than 33 has a probability of 7e-4
        EXPECT_GE(coverage.held, 33) << name;
        EXPECT_LT(std::abs(coverage.deviation) / loops, 4.0 / std::sqrt(loops)) << name;
    }
}

}  // namespace
}  // namespace setae::simulation::loop_recovery_test
