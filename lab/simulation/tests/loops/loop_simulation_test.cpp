// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/simulation/loop_simulation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::simulation::loop_simulation_test {
namespace {

constexpr hysteresis::HystereticSphere smooth{
    .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.040, .work_retraction = 0.040};
constexpr hysteresis::HystereticSphere rough{
    .radius = 1.25e-3, .contact_modulus = 0.92e6, .work_approach = 0.040, .work_retraction = 0.075};

contact::jkr::Contact contact_of(const hysteresis::HystereticSphere& specimen, double work) {
    return {specimen.radius, specimen.contact_modulus, work};
}

/// ∮ F dδ by the trapezoid rule over a record without noise.
double loop_area(const loops::Loop& loop) {
    double sum = 0.0;
    for (Index i = 1; i < loop.force.size(); ++i)
        sum += 0.5 * (loop.force[i] + loop.force[i - 1]) * (loop.displacement[i] - loop.displacement[i - 1]);
    return sum;
}

Index index_of_largest_force(const loops::Loop& loop) {
    Index at = 0;
    loop.force.maxCoeff(&at);
    return at;
}

TEST(TrueLoop, HasMaugisIdealLossForEqualWorksUnderFixedGrips) {
    const hysteresis::SphereLoop truth = true_loop(smooth, {});
    const double unit = contact::jkr::maugis_units(contact_of(smooth, 0.040)).energy;
    EXPECT_NEAR(truth.energy_loss() / unit, 1.2749410291, 1e-10);
    EXPECT_NEAR(truth.jump_in_loss / unit, 1.1537996562, 1e-10);
    EXPECT_NEAR(truth.jump_out_loss / unit, 0.1211413729, 1e-10);
    EXPECT_EQ(truth.edge_loss, 0.0);
}

TEST(TrueLoop, PullsOffAtFiveSixthsUnderFixedGripsThreeHalvesUnderLoad) {
    const double force = pi * rough.radius * rough.work_retraction;
    const hysteresis::SphereLoop stiff = true_loop(rough, {});
    EXPECT_NEAR(stiff.separation.force / force, -5.0 / 6.0, 1e-12);
    EXPECT_NEAR(stiff.smallest_force / force, -1.5, 1e-12);
    // the spring's instability lies within O(√k_m) of the fold, where the force is stationary
    const hysteresis::SphereLoop soft = true_loop(rough, {.machine_stiffness = 1e-3});
    EXPECT_NEAR(soft.separation.force / force, -1.5, 1e-8);
    EXPECT_NEAR(soft.smallest_force / force, -1.5, 1e-12);
}

TEST(TrueLoop, PullsOffWhereContactStiffnessEqualsMachineStiffness) {
    constexpr double stiffness = 40.0;
    const hysteresis::SphereLoop truth = true_loop(rough, {.machine_stiffness = stiffness});
    const contact::jkr::Contact retraction = contact_of(rough, rough.work_retraction);
    const double a = truth.separation.contact_radius, step = 1e-5 * a;
    const double dF = contact::jkr::force(a + step, retraction) - contact::jkr::force(a - step, retraction);
    const double dd =
        contact::jkr::displacement(a + step, retraction) - contact::jkr::displacement(a - step, retraction);
    EXPECT_NEAR(dF / dd / stiffness, -1.0, 1e-7);
}

TEST(TrueLoop, JumpsInAlongTheLineOfMachineStiffness) {
    constexpr double stiffness = 40.0;
    const contact::jkr::State state = true_loop(rough, {.machine_stiffness = stiffness}).after_jump_in;
    EXPECT_NEAR(state.force / (-stiffness * state.displacement), 1.0, 1e-12);
    EXPECT_NEAR(
        contact::jkr::force_at_displacement(state.displacement, contact_of(rough, rough.work_approach)) / state.force,
        1.0, 1e-10);
}

TEST(TrueLoop, SmallStickyContactPullsOffFromThePinnedState) {
    hysteresis::HystereticSphere sticky = rough;
    sticky.work_retraction = 20.0;
    const hysteresis::SphereLoop truth = true_loop(sticky, {.maximum_force = 1e-5});
    EXPECT_EQ(truth.separation.contact_radius, truth.turning_point.contact_radius);
    EXPECT_EQ(truth.smallest_force, truth.unpinned.force);
    const SimulatedLoop simulated =
        simulated_loop(sticky, {.maximum_force = 1e-5, .force_rate = 500.0, .camera_rate = 500.0});
    EXPECT_NEAR(loop_area(simulated.loop) / truth.energy_loss(), 1.0, 1e-3);
}

TEST(SimulatedLoop, EnclosesTheTrueEnergyLoss) {
    for (const double stiffness : {30.0, 300.0, std::numeric_limits<double>::infinity()}) {
        const LoadingProtocol protocol{.force_rate = 100.0, .camera_rate = 1.0, .machine_stiffness = stiffness};
        const SimulatedLoop simulated = simulated_loop(rough, protocol);
        // what the two steps in which the jumps fall leave open: a force of order πRW times the step, 0.6 nm
        const double jumps =
            4.0 * pi * rough.radius * rough.work_retraction * protocol.approach_speed / protocol.force_rate;
        EXPECT_NEAR(loop_area(simulated.loop), simulated.truth.energy_loss(), jumps) << stiffness;
        EXPECT_LT(jumps, 5e-4 * simulated.truth.energy_loss());
    }
}

TEST(SimulatedLoop, UnloadsAsAFlatPunchWhileTheEdgeIsPinned) {
    const SimulatedLoop simulated = simulated_loop(rough, {.camera_rate = 10.0});
    const loops::Loop& loop = simulated.loop;
    const Index peak = index_of_largest_force(loop);
    const double a = simulated.truth.turning_point.contact_radius;
    Index last = peak + 1;
    while (loop.force[last + 1] > simulated.truth.unpinned.force) ++last;
    ASSERT_GT(last - peak, 20);
    const double slope =
        (loop.force[last] - loop.force[peak + 1]) / (loop.displacement[last] - loop.displacement[peak + 1]);
    EXPECT_NEAR(slope / (2.0 * rough.contact_modulus * a), 1.0, 1e-9);
    for (Index i = peak + 1; i <= last; ++i) EXPECT_EQ(loop.contact_radius[i], a) << i;
    const contact::SphereOnFlat bodies{rough.radius, rough.contact_modulus};
    EXPECT_NEAR(contact::jkr::energy_release_rate_at_force(a, simulated.truth.unpinned.force, bodies),
                rough.work_retraction, 1e-9 * rough.work_retraction);
}

TEST(SimulatedLoop, FollowsJkrOnBothBranches) {
    const SimulatedLoop simulated = simulated_loop(rough, {.camera_rate = 10.0, .machine_stiffness = 100.0});
    const loops::Loop& loop = simulated.loop;
    const Index peak = index_of_largest_force(loop);
    const contact::SphereOnFlat bodies{rough.radius, rough.contact_modulus};
    int approach = 0, retraction = 0;
    for (Index i = 0; i < loop.force.size(); ++i) {
        const double a = loop.contact_radius[i];
        if (!(a > 0.0)) continue;
        const double release_rate = contact::jkr::energy_release_rate_at_force(a, loop.force[i], bodies);
        if (i < peak) {
            ++approach;
            EXPECT_NEAR(release_rate / rough.work_approach, 1.0, 1e-9) << i;
        } else if (a < simulated.truth.turning_point.contact_radius) {
            ++retraction;
            EXPECT_NEAR(release_rate / rough.work_retraction, 1.0, 1e-9) << i;
        }
    }
    EXPECT_GT(approach, 100);
    EXPECT_GT(retraction, 100);
}

TEST(SimulatedLoop, RestsAtTheTurningPointForTheHoldTime) {
    const SimulatedLoop held = simulated_loop(smooth, {.hold_time = 5.0});
    const auto at_rest = (held.loop.force > held.truth.turning_point.force * (1.0 - 1e-12)).count();
    EXPECT_GE(at_rest, 50);
    EXPECT_LE(at_rest, 51);
    EXPECT_EQ(held.loop.force.size() - simulated_loop(smooth, {}).loop.force.size(), 50);
}

TEST(SimulatedLoop, HasTheRadiusInCameraFramesOnly) {
    const loops::Loop loop = simulated_loop(smooth, {.force_rate = 10.0, .camera_rate = 2.5}).loop;
    for (Index i = 0; i < loop.force.size(); ++i) EXPECT_EQ(std::isnan(loop.contact_radius[i]), i % 4 != 0) << i;
}

TEST(SimulatedLoop, AddsTheRequestedArtefacts) {
    const LoadingProtocol protocol{.camera_rate = 10.0};
    const loops::Loop plain = simulated_loop(smooth, protocol).loop;
    const LoopArtefacts artefacts{
        .compliance = 2e-3, .force_drift_rate = 1e-8, .displacement_drift_rate = 2e-10, .baseline_offset = 3e-5};
    const loops::Loop bent = simulated_loop(smooth, protocol, artefacts).loop;
    const Array1D displacement = plain.displacement + 2e-3 * plain.force + 2e-10 * plain.time;
    EXPECT_LT((bent.displacement - displacement).abs().maxCoeff(), 1e-18);
    EXPECT_LT((bent.force - (plain.force + 3e-5 + 1e-8 * plain.time)).abs().maxCoeff(), 1e-18);
    EXPECT_TRUE((bent.contact_radius == plain.contact_radius).all());
    // in a stiff machine the motor stands at the displacement
    const loops::Loop sloped = simulated_loop(smooth, protocol, {.baseline_slope = 0.5}).loop;
    EXPECT_LT((sloped.force - plain.force - 0.5 * plain.displacement).abs().maxCoeff(), 1e-18);
}

TEST(SimulatedLoop, HasNoiseOfTheRequestedStandardDeviation) {
    const LoadingProtocol protocol{.camera_rate = 10.0};
    const loops::Loop plain = simulated_loop(smooth, protocol).loop;
    const LoopArtefacts artefacts{
        .force_noise = 1e-7, .displacement_noise = 2e-10, .radius_noise = 3e-8, .key = {.seed = 7}};
    const loops::Loop noisy = simulated_loop(smooth, protocol, artefacts).loop;
    const auto spread = [](const Array1D& difference) { return std::sqrt(difference.square().mean()); };
    const auto five_errors = [](Index n) { return 5.0 / std::sqrt(2.0 * static_cast<double>(n)); };
    const Index n = plain.force.size();
    EXPECT_NEAR(spread(noisy.force - plain.force) / 1e-7, 1.0, five_errors(n));
    EXPECT_NEAR(spread(noisy.displacement - plain.displacement) / 2e-10, 1.0, five_errors(n));
    const Array1D contact = (plain.contact_radius > 0.0).cast<double>();
    const Index frames = static_cast<Index>(contact.sum());
    const Array1D radius =
        (noisy.contact_radius - plain.contact_radius) * std::sqrt(static_cast<double>(n) / contact.sum());
    EXPECT_NEAR(spread(radius) / 3e-8, 1.0, five_errors(frames));
    EXPECT_TRUE((noisy.contact_radius > 0.0).cwiseEqual(plain.contact_radius > 0.0).all());
    const double product = ((noisy.force - plain.force) * (noisy.displacement - plain.displacement)).mean();
    EXPECT_LT(std::abs(product) / (1e-7 * 2e-10), 5.0 / std::sqrt(static_cast<double>(n)));
}

TEST(SimulatedLoop, DependsOnTheKeyOnly) {
    const LoopArtefacts artefacts{.force_noise = 1e-7, .key = {.seed = 7}};
    const loops::Loop first = simulated_loop(smooth, {}, artefacts).loop,
                      again = simulated_loop(smooth, {}, artefacts).loop;
    EXPECT_TRUE((first.force == again.force).all());
    EXPECT_FALSE(
        (first.force == simulated_loop(smooth, {}, {.force_noise = 1e-7, .key = {.seed = 8}}).loop.force).all());
}

TEST(SimulatedLoop, RefusesImpossibleOptions) {
    const auto message = [](const hysteresis::HystereticSphere& specimen, const LoadingProtocol& protocol,
                            const LoopArtefacts& artefacts = {}) {
        try {
            (void)simulated_loop(specimen, protocol, artefacts);
        } catch (const InvalidArgument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    hysteresis::HystereticSphere repelled = smooth;
    repelled.work_retraction = 0.03;
    EXPECT_NE(message(repelled, {}).find("work of adhesion on retraction"), std::string::npos);
    EXPECT_NE(message(smooth, {.maximum_force = 0.0}).find("maximum force"), std::string::npos);
    EXPECT_NE(message(smooth, {.force_rate = 1.0, .camera_rate = 2.0}).find("camera rate"), std::string::npos);
    EXPECT_NE(message(smooth, {.machine_stiffness = -1.0}).find("machine stiffness"), std::string::npos);
    EXPECT_NE(message(smooth, {.force_rate = 1e9}).find("samples"), std::string::npos);
    EXPECT_NE(message(smooth, {}, {.force_noise = -1.0}).find("force noise"), std::string::npos);
}

}  // namespace
}  // namespace setae::simulation::loop_simulation_test
