// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/machine_stiffness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "refusal.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::machine_stiffness_test {
namespace {

using tests::SyntheticLoop;

constexpr double stiffness = 250.0;

/// A rigid contact: the stage pushes the testing machine's spring from 0 on and back, adhesion holds it a little on the
/// way out.
Loop rigid_loop(double extra_slope_out = 0.0) {
    constexpr Index n = 300;
    const Array1D in = Array1D::LinSpaced(n, 0.0, 4e-6), out = in.reverse();
    const Array1D free = Array1D::LinSpaced(n, -4e-6, -1e-8);
    Loop loop;
    loop.displacement.resize(4 * n);
    loop.displacement << free, in, out, free.reverse();
    loop.force.resize(4 * n);
    loop.force << Array1D::Zero(n), stiffness * in, (stiffness + extra_slope_out) * (out - 4e-6) + stiffness * 4e-6,
        Array1D::Zero(n);
    loop.force.segment(3 * n - 1, 4) = Array1D::Constant(4, -1e-4);  // pull-off
    return loop;
}

TEST(MachineStiffness, OfARigidContactEqualsItsSlope) {
    const MachineStiffness found = machine_stiffness_from_rigid_contact(rigid_loop());
    EXPECT_NEAR(found.stiffness.value / stiffness, 1.0, 1e-9);
    EXPECT_NEAR(found.nonlinearity, 0.0, 1e-9);
    EXPECT_NEAR(found.hysteresis, 0.0, 1e-9);
}

TEST(MachineStiffness, WorksWithoutAdhesion) {
    Loop loop = rigid_loop();
    loop.force = loop.force.max(0.0);
    std::mt19937_64 generator(4);
    loop.force = tests::with_noise(loop.force, 1e-6, generator);
    const MachineStiffness found = machine_stiffness_from_rigid_contact(loop);
    EXPECT_NEAR(found.stiffness.value / stiffness, 1.0, 2e-3);
    EXPECT_TRUE(std::isfinite(found.unloading.value));
    loop.force = -loop.force;
    EXPECT_THROW((void)machine_stiffness_from_rigid_contact(loop), UndefinedDataError);
}

TEST(MachineStiffness, CoversTheTrueStiffnessWithNoise) {
    double pulls = 0.0;
    constexpr int seeds = 100;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        Loop loop = rigid_loop();
        loop.force = tests::with_noise(loop.force, 5e-6, generator);
        const Estimate found = machine_stiffness_from_rigid_contact(loop).stiffness;
        pulls += std::pow((found.value - stiffness) / found.standard_error, 2) / seeds;
    }
    // the mean square of 100 pulls is 1 ± 0.14; Huber's weights and half the branches' difference make the error larger
    EXPECT_GT(std::sqrt(pulls), 0.5);
    EXPECT_LT(std::sqrt(pulls), 1.3);
}

TEST(MachineStiffness, IsRobustAgainstOutliers) {
    std::mt19937_64 generator(7);
    Loop loop = rigid_loop();
    loop.force = tests::with_noise(loop.force, 1e-6, generator);
    for (Index i = 420; i < 590; i += 17) loop.force[i] += 2e-4;
    EXPECT_NEAR(machine_stiffness_from_rigid_contact(loop).stiffness.value / stiffness, 1.0, 2e-3);
}

TEST(MachineStiffness, ReportsTheBranchesAndTheirHysteresis) {
    const MachineStiffness found = machine_stiffness_from_rigid_contact(rigid_loop(25.0));
    EXPECT_NEAR(found.loading.value, stiffness, 1e-6);
    EXPECT_NEAR(found.unloading.value, stiffness + 25.0, 1e-6);
    EXPECT_GT(found.stiffness.standard_error, 12.0);
    EXPECT_GT(found.hysteresis, 0.05);
}

TEST(MachineStiffness, RefusesASoftContact) {
    Loop loop = SyntheticLoop{.samples = 400}.make();
    loop.displacement += loop.force / 5000.0;
    const std::string message =
        tests::refusal_of<UndefinedDataError>([&] { (void)machine_stiffness_from_rigid_contact(loop); });
    EXPECT_NE(message.find("the contact is soft"), std::string::npos) << message;
    loop.displacement = Array1D();
    EXPECT_THROW((void)machine_stiffness_from_rigid_contact(loop), UndefinedDataError);
}

TEST(MachineStiffness, PropagatesItsErrorToModulusAndWork) {
    const SyntheticLoop shape{.samples = 400};
    Loop loop = shape.make();
    loop.displacement += loop.force / stiffness;
    AnalysisOptions options{.machine_stiffness = stiffness, .machine_stiffness_standard_error = 10.0};
    const LoopAnalysis analysis = analyse(loop, tests::rubber_on_diamond(), options);
    ASSERT_TRUE(analysis.compliance);
    const JkrFit& fit = *analysis.loading.force_displacement;
    EXPECT_NEAR(fit.contact_modulus.value / 0.92e6, 1.0, 1e-8);
    // noise-free: the whole error is the stiffness's
    EXPECT_NEAR(fit.contact_modulus.standard_error / std::abs(analysis.compliance->modulus_change), 1.0, 1e-3);
    const LoopAnalysis other = analyse(loop, tests::rubber_on_diamond(), {.machine_stiffness = stiffness + 10.0});
    EXPECT_NEAR((other.loading.force_displacement->contact_modulus.value - fit.contact_modulus.value) /
                    analysis.compliance->modulus_change,
                1.0, 1e-3);
    EXPECT_NEAR((other.loading.force_displacement->work_of_adhesion.value - fit.work_of_adhesion.value) /
                    analysis.compliance->work_change,
                1.0, 1e-3);
    EXPECT_GT(analysis.compliance->energy_change, 0.0);
}

}  // namespace
}  // namespace setae::loops::machine_stiffness_test
