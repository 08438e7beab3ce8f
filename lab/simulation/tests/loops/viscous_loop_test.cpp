// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/loops/loop_drive.hpp"
#include "setae/simulation/loop_simulation.hpp"

/// What the analysis finds in loops of bodies that do something in time.
namespace setae::simulation::viscous_loop_test {
namespace {

constexpr hysteresis::HystereticSphere specimen{
    .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.040, .work_retraction = 0.060};
constexpr LoopArtefacts noise{.force_noise = 1e-7, .displacement_noise = 5e-10, .radius_noise = 1e-7};
const loops::LensAndCounterBody bodies{.radius = 1.25e-3,
                                       .counter_youngs_modulus = std::numeric_limits<double>::infinity()};

TEST(ViscousLoop, FitRecoversTheTrueCrackSpeedLaw) {
    const hysteresis::ViscousBody body{.edge = hysteresis::EdgeSpeed{.reference_speed = 1e-6, .exponent = 0.6},
                                       .relaxation = {}};
    const auto made = simulated_loop(specimen, {.camera_rate = 5.0}, noise, body);
    const auto analysis = loops::analyse(made.loop, bodies);
    const auto fit = loops::fit_crack_speed(loops::retracting_edge(analysis, {}), bodies.radius,
                                            analysis.loading.primary().contact_modulus);
    EXPECT_NEAR(fit.threshold.value, 0.060, 4.0 * fit.threshold.standard_error);
    EXPECT_NEAR(fit.reference_speed.value, 1e-6, 4.0 * fit.reference_speed.standard_error);
    EXPECT_NEAR(fit.exponent.value, 0.6, 4.0 * fit.exponent.standard_error);
    EXPECT_LT(fit.threshold.standard_error, 2e-3);
    EXPECT_NEAR(analysis.loop->energy / made.truth.energy_loss(), 1.0, 2e-3);
    EXPECT_NEAR(analysis.pull_off->force.value / made.truth.smallest_force, 1.0, 1e-3);
    EXPECT_GT(made.truth.speed_loss, 0.3 * made.truth.energy_loss());
}

TEST(ViscousLoop, FitRecoversARelaxingBulkFromStatedRelaxation) {
    const hysteresis::ViscousBody body{.edge = {}, .relaxation = {{0.1, 15.0}, {0.05, 60.0}}};
    const auto made = simulated_loop(specimen, {.hold_time = 30.0, .camera_rate = 2.0}, noise, body);
    const auto stated_value = loops::analyse(made.loop, bodies, {.relaxation = body.relaxation});
    const auto untold = loops::analyse(made.loop, bodies);
    ASSERT_TRUE(stated_value.bulk);
    EXPECT_FALSE(untold.bulk);
    const auto modulus_of = [](const auto& analysis) { return analysis.loading.primary().contact_modulus.value; };
    const auto work_of = [](const auto& analysis) { return analysis.loading.primary().work_of_adhesion.value; };
    EXPECT_NEAR(modulus_of(stated_value) / specimen.contact_modulus, 1.0, 5e-3);
    EXPECT_GT(modulus_of(untold) / specimen.contact_modulus, 1.03);
    EXPECT_NEAR(work_of(stated_value) / specimen.work_approach, 1.0, 5e-3);
    EXPECT_NEAR(stated_value.retraction->work_of_adhesion.value / specimen.work_retraction, 1.0, 1e-2);
    EXPECT_GT(untold.retraction->work_of_adhesion.value / specimen.work_retraction, 1.05);
    EXPECT_NEAR(stated_value.bulk->energy_loss / made.truth.bulk_loss, 1.0, 0.04);
    EXPECT_NEAR(stated_value.loop->energy / untold.loop->energy, 1.0, 1e-3) << "the loop loses what it loses";
}

TEST(ViscousLoop, AnalysisRecoversTheMotionOfTheMachine) {
    for (const double stiffness : {100.0, std::numeric_limits<double>::infinity()}) {
        const auto made = simulated_loop(
            specimen,
            {.approach_speed = 80e-9, .retraction_speed = 50e-9, .hold_time = 12.0, .machine_stiffness = stiffness},
            noise);
        const auto drive = loops::loop_drive(loops::analyse(made.loop, bodies), stiffness);
        ASSERT_TRUE(drive) << stiffness;
        EXPECT_NEAR(drive->approach_speed, 80e-9, 1e-10);
        EXPECT_NEAR(drive->retraction_speed, 50e-9, 1e-10);
        EXPECT_NEAR(drive->hold_time, 12.0, 0.5);
    }
    const auto without = simulated_loop(specimen, {}, noise);
    const auto drive = loops::loop_drive(loops::analyse(without.loop, bodies));
    ASSERT_TRUE(drive);
    EXPECT_EQ(drive->hold_time, 0.0);
}

TEST(ViscousLoop, WithoutTimeCannotBeAnalysedWithRelaxation) {
    const auto made = simulated_loop(specimen, {});
    auto timeless = made.loop;
    timeless.time = Array1D();
    EXPECT_THROW((void)loops::analyse(timeless, bodies, {.relaxation = {{0.1, 10.0}}}), UndefinedDataError);
}

}  // namespace
}  // namespace setae::simulation::viscous_loop_test
