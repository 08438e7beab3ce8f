// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/energy_budget.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::energy_budget_test {
namespace {

using tests::SyntheticLoop;

const SyntheticLoop rough{.retraction_work = 0.07, .samples = 800};

EnergyBudgetInputs inputs_of(const SyntheticLoop& shape) {
    return {.smooth_sphere = shape.approach,
            .largest_contact_area = pi * shape.largest_radius * shape.largest_radius,
            .machine_stiffness = std::numeric_limits<double>::infinity()};
}

EnergyBudget budget_of(const Loop& loop, const EnergyBudgetInputs& inputs = inputs_of(rough)) {
    return energy_budget(loop, find_segments(loop), 0, inputs);
}

/// U_E − πWa² of JKR's equilibrium.
double stored(double a, const contact::jkr::Contact& contact) {
    return contact::jkr::total_energy(a, contact::jkr::displacement(a, contact), contact);
}

TEST(EnergyBudget, HasPartsThatAddUp) {
    std::mt19937_64 generator(3);
    Loop loop = rough.make();
    loop.force = tests::with_noise(loop.force, 1e-7, generator) + 1e-9 * loop.time;
    const EnergyBudget budget = budget_of(loop);
    const double sum = budget.before_contact.energy + budget.jump_in->energy + budget.approach.energy +
                       budget.retraction.energy + budget.jump_out->energy + budget.after_contact.energy;
    EXPECT_NEAR(sum / budget.loop.energy, 1.0, 1e-12);
    EXPECT_EQ(budget.before_contact.range.last, budget.jump_in->range.first);
    EXPECT_EQ(budget.jump_in->range.last, budget.approach.range.first);
    EXPECT_EQ(budget.approach.range.last, budget.retraction.range.first);
    EXPECT_EQ(budget.retraction.range.last, budget.jump_out->range.first);
    EXPECT_EQ(budget.jump_out->range.last, budget.after_contact.range.first);
}

TEST(EnergyBudget, OfTheApproachEqualsTheStoredEnergy) {
    // from the jump on, work goes into elastic and surface energy; 800 steps of second order
    const EnergyBudget budget = budget_of(rough.make());
    const double a_in = contact::jkr::jump_in_at_fixed_grips(rough.approach).contact_radius;
    const double gain = stored(rough.largest_radius, rough.approach) - stored(a_in, rough.approach);
    EXPECT_NEAR(budget.approach.energy / gain, 1.0, 1e-5);
    EXPECT_NEAR(budget.jump_in->energy, 0.0, 1e-12 * gain);
    EXPECT_NEAR(budget.recovered_share, -budget.retraction.energy / budget.approach.energy, 0.0);
}

TEST(EnergyBudget, GivesTheLossPerArea) {
    EnergyBudgetInputs inputs = inputs_of(rough);
    inputs.true_area_ratio = 1.5;
    const EnergyBudget budget = budget_of(rough.make(), inputs);
    EXPECT_DOUBLE_EQ(budget.loss_per_apparent_area, budget.loop.energy / inputs.largest_contact_area);
    EXPECT_DOUBLE_EQ(budget.loss_per_true_area, budget.loss_per_apparent_area / 1.5);
    EXPECT_DOUBLE_EQ(budget.largest_true_area(), 1.5 * inputs.largest_contact_area);
    EXPECT_NEAR(budget.ideal_fixed_grips / contact::jkr::ideal_loop_loss(rough.approach).total, 1.0, 1e-12);
    EXPECT_NEAR(budget.ideal_this_machine / budget.ideal_fixed_grips, 1.0, 1e-12);
    inputs.true_area_ratio = 0.5;
    EXPECT_THROW((void)budget_of(rough.make(), inputs), InvalidArgument);
}

TEST(EnergyBudget, MachineEnergyVanishesOverTheClosedLoop) {
    EnergyBudgetInputs inputs = inputs_of(rough);
    constexpr double stiffness = 300.0, error = 15.0;
    inputs.displacement_stiffness = Estimate{.value = stiffness, .standard_error = error};
    const Loop loop = rough.make();
    const EnergyBudget budget = budget_of(loop, inputs);
    // of the approach: what the energy changes where δ is corrected with k + σ instead
    Loop stiffer = loop;
    stiffer.displacement += loop.force * (1.0 / stiffness - 1.0 / (stiffness + error));
    const EnergyBudget moved = budget_of(stiffer, inputs);
    EXPECT_NEAR(budget.approach.standard_error.compliance / std::abs(moved.approach.energy - budget.approach.energy),
                1.0, error / stiffness * 1.1);
    EXPECT_GT(budget.approach.standard_error.compliance, 1e-3 * budget.approach.energy);
    EXPECT_NEAR(moved.loop.energy / budget.loop.energy, 1.0, 1e-12);
    EXPECT_EQ(budget.loop.standard_error.compliance, 0.0);
}

TEST(EnergyBudget, ChangesByLessThanItsSamplingErrorAtDoubleSampling) {
    for (const bool even_in_displacement : {false, true}) {
        SyntheticLoop coarse = rough, fine = rough;
        coarse.samples = 100;
        fine.samples = 200;
        coarse.even_in_displacement = fine.even_in_displacement = even_in_displacement;
        const EnergyBudget once = budget_of(coarse.make()), twice = budget_of(fine.make());
        const LoopErrorBudget& errors = once.loop.standard_error;
        EXPECT_LT(std::abs(twice.loop.energy - once.loop.energy), std::hypot(errors.sampling, errors.discretisation))
            << even_in_displacement;
    }
}

CourseInputs course_inputs(const SyntheticLoop& shape) { return {.contact = shape.approach, .contact_point = 0.0}; }

EnergyCourse course_of(const Loop& loop, const SyntheticLoop& shape = rough) {
    return energy_course(loop, find_segments(loop).contacts[0], course_inputs(shape));
}

TEST(EnergyCourse, EnergyBudgetIsClosed) {
    for (const bool radius_measured : {true, false}) {
        Loop loop = rough.make();
        if (!radius_measured) loop.contact_radius = Array1D();
        const EnergyCourse course = course_of(loop);
        EXPECT_EQ(course.radius_measured, radius_measured);
        EXPECT_LT((course.work - course.elastic - course.surface - course.dissipated).abs().maxCoeff(),
                  1e-15 * rough.loss());
        // work = stored − released between the jumps, within the trapezoid rule of 800 steps
        EXPECT_LT(std::abs(course.residual), 1e-4 * rough.loss()) << radius_measured;
        EXPECT_NEAR(course.dissipated[course.dissipated.size() - 1] / rough.loss(), 1.0, 1e-4);
        EXPECT_EQ(course.elastic[course.elastic.size() - 1], 0.0);
    }
}

TEST(EnergyCourse, DissipatesInTheJumpAndWithTheRecedingEdge) {
    const EnergyCourse course = course_of(rough.make());
    const double jump_in = contact::jkr::ideal_loop_loss(rough.approach).jump_in;
    // nothing before the jump, its loss after it, the same at the largest load
    EXPECT_EQ(course.dissipated[800], 0.0);
    EXPECT_NEAR(course.dissipated[801] / jump_in, 1.0, 1e-9);
    EXPECT_NEAR(course.dissipated[1601] / jump_in, 1.0, 1e-4);
    // the pinned edge dissipates nothing: 800 samples on
    EXPECT_NEAR(course.dissipated[2400] / jump_in, 1.0, 1e-3);
    // when the edge has receded to a, (W_r − W_a) (A_max − A) more is lost
    const double a = course.contact_radius[2900], a_max = rough.largest_radius;
    EXPECT_NEAR(course.dissipated[2900] / (jump_in + 0.03 * pi * (a_max * a_max - a * a)), 1.0, 1e-3);
}

TEST(EnergyCourse, InterpolatesMissingFrames) {
    Loop loop = rough.make();
    for (Index i = 0; i < loop.contact_radius.size(); ++i)
        if (i % 10 != 1) loop.contact_radius[i] = loop.contact_radius[i] > 0.0 ? undefined : loop.contact_radius[i];
    const EnergyCourse course = course_of(loop);
    EXPECT_TRUE(course.elastic.allFinite());
    EXPECT_LT(std::abs(course.residual), 1e-2 * rough.loss());
}

TEST(EnergyCourse, ResidualRevealsAWrongModulus) {
    const Loop loop = rough.make();
    CourseInputs inputs = course_inputs(rough);
    inputs.contact.contact_modulus *= 1.1;
    EXPECT_GT(std::abs(energy_course(loop, find_segments(loop).contacts[0], inputs).residual), 0.05 * rough.loss());
}

TEST(EnergyCourse, RequiresADisplacement) {
    Loop loop = rough.make();
    const Segments segments = find_segments(loop);
    loop.displacement = Array1D();
    EXPECT_THROW((void)energy_course(loop, segments.contacts[0], course_inputs(rough)), UndefinedDataError);
}

}  // namespace
}  // namespace setae::loops::energy_budget_test
