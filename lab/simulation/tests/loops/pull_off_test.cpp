// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "setae/loops/analysis.hpp"
#include "setae/simulation/loop_simulation.hpp"

/// Pull-off in machines of any stiffness.
namespace setae::simulation::pull_off_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr hysteresis::HystereticSphere specimen{
    .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.040, .work_retraction = 0.060};

loops::PullOff pull_off_of(double stiffness, double force_rate = 10.0, double displacement_noise = 0.0) {
    const SimulatedLoop made = simulated_loop(specimen,
                                              {.maximum_force = 5e-4,
                                               .start_gap = 10e-6,
                                               .force_rate = force_rate,
                                               .camera_rate = force_rate,
                                               .machine_stiffness = stiffness},
                                              {.displacement_noise = displacement_noise, .key = {.seed = 5}});
    const loops::LoopAnalysis analysis =
        loops::analyse(made.loop, {.radius = specimen.radius, .counter_youngs_modulus = infinite});
    EXPECT_TRUE(analysis.pull_off) << analysis.pull_off.reason;
    return *analysis.pull_off;
}

TEST(PullOff, SmallestForceGivesTheWorkAtAnyMachineStiffness) {
    for (const double stiffness : {20.0, 100.0, 1e3, 1e5, infinite})
        EXPECT_NEAR(pull_off_of(stiffness).work_of_adhesion.value / specimen.work_retraction, 1.0, 2e-3) << stiffness;
}

TEST(PullOff, LastForceGivesTheWorkOnlyInAStiffMachine) {
    // samples end up to a step before the fold, where F rises as the root of the way left
    for (const double stiffness : {1e5, infinite}) {
        const loops::PullOff pull_off = pull_off_of(stiffness, 100.0);
        ASSERT_TRUE(pull_off.work_of_adhesion_fixed_grips) << pull_off.work_of_adhesion_fixed_grips.reason;
        EXPECT_NEAR(pull_off.work_of_adhesion_fixed_grips->value / specimen.work_retraction, 1.0, 0.06) << stiffness;
    }
    for (const double stiffness : {20.0, 100.0}) {
        const loops::PullOff pull_off = pull_off_of(stiffness);
        EXPECT_FALSE(pull_off.work_of_adhesion_fixed_grips);
        EXPECT_NE(pull_off.work_of_adhesion_fixed_grips.reason.find("not 10 times stiffer"), std::string::npos);
    }
}

TEST(PullOff, MachineStiffnessExcludesTheMotionOfTheMotor) {
    // at 0.2 samples a second the motor moves 300 nm in the step that the jump falls into
    for (const double stiffness : {20.0, 100.0, 500.0})
        for (const double rate : {10.0, 1.0, 0.2})
            EXPECT_NEAR(pull_off_of(stiffness, rate).machine_stiffness / stiffness, 1.0, 0.01) << stiffness << rate;
    // the motor's own step is all there is in a stiff one
    EXPECT_EQ(pull_off_of(infinite, 0.2).machine_stiffness, infinite);
    EXPECT_EQ(pull_off_of(infinite, 1.0, 1e-9).machine_stiffness, infinite);
    EXPECT_NEAR(pull_off_of(100.0, 1.0, 1e-9).machine_stiffness / 100.0, 1.0, 0.01);
}

}  // namespace
}  // namespace setae::simulation::pull_off_test
