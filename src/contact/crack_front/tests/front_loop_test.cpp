// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/crack_front/front_loop.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace front_loop_test {

using namespace setae;
using namespace setae::crack_front;

constexpr double W = 1.0 / pi;  // Maugis' units
constexpr contact::SphereOnFlat sphere{1.0, 0.75};
constexpr contact::AdhesiveContact jkr_contact{1.0, 0.75, W};

CircularFront smooth() {
    return {sphere, work_of([](double, double) { return W; }, 8, {401, 0.0, 0.01}, W)};
}

/// Rings and rays: pins both ways.
WorkField patterned() {
    return work_of(
        [](double r, double angle) { return W * (1.0 + 0.3 * std::sin(2.0 * pi * r / 0.1) * std::cos(12.0 * angle)); },
        64, {321, 0.0, 0.00625}, W);
}

TEST(FrontLoop, OfASmoothSphereLosesTheTwoJumps) {
    auto front = smooth();
    const auto loop = front_loop(front, {.furthest = 1.0, .steps = 200, .jump_share = 1e-5});
    const auto exact = contact::jkr::ideal_loop_loss(jkr_contact);
    EXPECT_TRUE(loop.complete);
    EXPECT_EQ(loop.jumps, 2);
    EXPECT_NEAR(loop.energy_loss, 1.2749410291, 1e-4);
    EXPECT_NEAR(loop.approach_dissipation, exact.jump_in, 1e-4);
    EXPECT_NEAR(loop.retraction_dissipation, exact.jump_out, 1e-4);
    const auto works = branch_works(loop, sphere);
    EXPECT_NEAR(works.approach.work_of_adhesion.value, W, 1e-8);
    EXPECT_NEAR(works.approach.contact_modulus.value, 0.75, 1e-8);
    EXPECT_NEAR(works.retraction.work_of_adhesion.value, W, 1e-8);
    EXPECT_NEAR(works.pull_off_force, -1.5, 1e-3);
    EXPECT_NEAR(works.pull_off_work, W, 1e-3);
}

// jump in at z = 0: F = −k δ on JKR's curve, and what is lost is all but the energy of contact and spring
TEST(FrontLoop, OnAStageJumpsAlongTheStageStiffness) {
    auto front = smooth();
    const double k = 1.0;
    const auto loop = front_loop(front, {.drive = Drive::stage, .stiffness = k, .furthest = 1.0, .steps = 200});
    const auto& first = loop.steps[1].state;
    EXPECT_NEAR(first.force, -k * first.displacement, 1e-9);
    EXPECT_NEAR(first.force, contact::jkr::force(first.mean_radius, jkr_contact), 1e-8);
    EXPECT_NEAR(loop.steps[1].dissipation,
                -contact::jkr::total_energy(first.mean_radius, first.displacement, jkr_contact) -
                    first.force * first.force / (2.0 * k),
                1e-8);
    EXPECT_TRUE(loop.complete);
}

TEST(FrontLoop, UnderADeadLoadPullsOffAtTheJkrForce) {
    auto front = smooth();
    const auto loop = front_loop(front, {.drive = Drive::load, .furthest = 1.0, .steps = 1000});
    EXPECT_TRUE(loop.complete);
    EXPECT_NEAR(branch_works(loop, sphere).pull_off_force, -1.5, 2e-3);
}

TEST(FrontLoop, EnergyBudgetIsClosed) {
    CircularFront front(sphere, patterned());
    const auto loop = front_loop(front, {.furthest = 0.3, .steps = 60});
    ASSERT_TRUE(loop.complete);
    EXPECT_NEAR(loop.approach_dissipation + loop.retraction_dissipation, loop.energy_loss, 1e-12);
    EXPECT_GT(loop.energy_loss, contact::jkr::ideal_loop_loss(jkr_contact).total);
    EXPECT_GT(loop.smallest_dissipation, -1e-4);
    EXPECT_EQ(loop.steps.back().state.energy(), 0.0);
    const auto table = loop_table(loop, Drive::displacement);
    EXPECT_EQ(table.rows(), static_cast<Index>(loop.steps.size()));
    EXPECT_NEAR(table.at("total_dissipation")[table.rows() - 1], loop.energy_loss, 1e-12);
    const auto works = branch_works(loop, sphere);
    EXPECT_GT(works.retraction.work_of_adhesion.value, works.approach.work_of_adhesion.value);
}

TEST(FrontLoop, EndsOnRequest) {
    auto front = smooth();
    int calls = 0;
    const auto loop =
        front_loop(front, {.furthest = 1.0, .steps = 100, .progress = [&](const FrontStep&) { return ++calls < 5; }});
    EXPECT_EQ(calls, 5);
    EXPECT_FALSE(loop.complete);
    EXPECT_THROW((void)branch_works(loop, sphere), UndefinedDataError);
    EXPECT_THROW((void)front_loop(front, {.furthest = -1.0}), InvalidArgument);
}

// Bodies meet at one spacing, thousands of times below where the edge comes to rest: residuals are measured there
TEST(FrontLoop, FirstContactConvergesOnAFineField) {
    const auto fine = work_of([](double, double angle) { return W * (1.0 + 0.2 * std::cos(900.0 * angle)); }, 4096,
                              {9001, 0.0, 2e-4}, W);
    CircularFront front(sphere, fine, {.max_iterations = 20000});
    const auto state = front.solve(HeldDisplacement{0.0});
    EXPECT_TRUE(state.converged) << state.residual;
    EXPECT_NEAR(state.mean_radius, contact::jkr::jump_in_at_fixed_grips(jkr_contact).contact_radius, 1e-2);
}

}  // namespace front_loop_test
