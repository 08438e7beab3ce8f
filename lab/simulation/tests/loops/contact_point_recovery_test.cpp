// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "setae/loops/analysis.hpp"
#include "setae/loops/spring_jumps.hpp"
#include "setae/simulation/loop_simulation.hpp"

/// Estimators of the contact point and of the energy budget on simulated loops with known properties.
namespace setae::simulation::contact_point_recovery_test {
namespace {

using loops::ContactPointMethod;

constexpr double fixed_grips = std::numeric_limits<double>::infinity();
constexpr hysteresis::HystereticSphere specimen{
    .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.040, .work_retraction = 0.060};
/// −3/2 πRW of the approach [N]: noise is a share of it.
constexpr double pull = 1.5 * 3.14159265 * 1.25e-3 * 0.040;

LoadingProtocol protocol_of(double stiffness, std::uint64_t seed) {
    // where within a sample the jumps fall is another chance
    const double step = 30e-9;
    const auto number = [&](std::uint64_t stream) {
        return numerics::uniform_number({.seed = seed, .stream = stream}, 0);
    };
    return {.maximum_force = 5e-4 * (1.0 + 0.05 * number(2)),
            .start_gap = 6e-6 + step * number(1),
            .force_rate = 2.0,
            .camera_rate = 2.0,
            .machine_stiffness = stiffness};
}

SimulatedLoop noisy_loop(double signal_to_noise, double stiffness, std::uint64_t seed) {
    const LoopArtefacts noise{
        .force_noise = pull / signal_to_noise, .displacement_noise = 5e-9, .radius_noise = 2e-7, .key = {.seed = seed}};
    return simulated_loop(specimen, protocol_of(stiffness, seed), noise);
}

loops::LoopAnalysis analysed(const loops::Loop& loop) {
    return loops::analyse(loop, {.radius = specimen.radius, .counter_youngs_modulus = fixed_grips},
                          {.samples_dropped = 1, .sensitivity_dropped = {}});
}

/// Deviations in standard errors.
struct Pulls {
    int n = 0;
    double sum = 0.0, squares = 0.0;

    void add(double pull_value) {
        ++n;
        sum += pull_value;
        squares += pull_value * pull_value;
    }
    [[nodiscard]] double mean() const { return sum / n; }
    [[nodiscard]] double spread() const { return std::sqrt(squares / n - mean() * mean()); }
};

/// The loss of a known loop is covered by the interval stated in 90 to 98 % of the seeds.
TEST(EnergyBudgetRecovery, CoversTheTrueLoss) {
    for (const double signal_to_noise : {5.0, 20.0, 100.0}) {
        constexpr int seeds = 200;
        int covered = 0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const SimulatedLoop made = noisy_loop(signal_to_noise, seed % 2 == 0 ? fixed_grips : 300.0, seed);
            const auto segments = loops::find_segments(made.loop);
            const auto budget = loops::energy_budget(
                made.loop, segments, 0,
                {.smooth_sphere = {specimen.radius, specimen.contact_modulus, specimen.work_approach},
                 .largest_contact_area = made.truth.largest_contact_area(),
                 .machine_stiffness = fixed_grips});
            const auto interval = interval_of(budget.loop.estimate());
            ASSERT_TRUE(interval);
            covered +=
                interval->lower <= made.truth.energy_loss() && made.truth.energy_loss() <= interval->upper ? 1 : 0;
        }
        EXPECT_GE(covered, 0.90 * seeds) << signal_to_noise;
        EXPECT_LE(covered, 0.98 * seeds) << signal_to_noise;
    }
}

/// The closed form at the stiffness of the testing machine against the laboratory's own solution of the same
/// equilibrium.
TEST(EnergyBudgetRecovery, ClosedFormLossMatchesTheSimulationAtAnyStiffness) {
    hysteresis::HystereticSphere smooth = specimen;
    smooth.work_retraction = smooth.work_approach;
    for (const double stiffness : {3.0, 40.0, 300.0, 1e5, fixed_grips}) {
        const hysteresis::SphereLoop truth = true_loop(smooth, {.machine_stiffness = stiffness});
        const auto jumps =
            loops::spring_jumps({smooth.radius, smooth.contact_modulus, smooth.work_approach}, stiffness);
        EXPECT_NEAR(jumps.jump_in_loss / truth.jump_in_loss, 1.0, 1e-10) << stiffness;
        EXPECT_NEAR(jumps.jump_out_loss / truth.jump_out_loss, 1.0, 1e-10) << stiffness;
        EXPECT_NEAR(jumps.before_jump_out.force / truth.separation.force, 1.0, 1e-7) << stiffness;
    }
}

struct Case {
    double signal_to_noise;
    double stiffness;
};

class ContactPointRecovery : public testing::TestWithParam<Case> {};

TEST_P(ContactPointRecovery, HasCalibratedErrorsForEveryMethod) {
    const auto [signal_to_noise, stiffness] = GetParam();
    constexpr int seeds = 100;
    std::map<ContactPointMethod, Pulls> found;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const auto analysis = analysed(noisy_loop(signal_to_noise, stiffness, seed).loop);
        ASSERT_TRUE(analysis.contact_points) << analysis.contact_points.reason;
        for (const auto& estimate : analysis.contact_points->estimates)
            if (estimate.contact_point)
                found[estimate.method].add(estimate.contact_point->value / estimate.contact_point->standard_error);
    }
    int methods = 0;
    for (const auto& [method, pulls] : found) {
        const std::string name = loops::contact_point_name(method);
        if (pulls.n < seeds / 2) continue;  // a jump that hardly ever stands out from the noise
        ++methods;
        // the mean of 100 pulls scatters by 0.1; half a step more or less of a jump is 0.3 more
        EXPECT_NEAR(pulls.mean(), 0.0, 0.5) << name;
        EXPECT_GT(pulls.spread(), 0.7) << name;
        EXPECT_LT(pulls.spread(), 1.4) << name;
    }
    EXPECT_GE(methods, signal_to_noise < 10.0 ? 5 : 6);
}

INSTANTIATE_TEST_SUITE_P(Noise, ContactPointRecovery,
                         testing::Values(Case{5.0, fixed_grips}, Case{5.0, 300.0}, Case{20.0, fixed_grips},
                                         Case{20.0, 300.0}, Case{100.0, fixed_grips}, Case{100.0, 300.0}));

}  // namespace
}  // namespace setae::simulation::contact_point_recovery_test
