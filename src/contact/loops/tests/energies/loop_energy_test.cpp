// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/loop_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "pulls.hpp"
#include "setae/core/errors.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::loop_energy_test {
namespace {

using tests::SyntheticLoop;
using tests::with_noise;

LoopEnergy energy_of(const Loop& loop) { return loop_energy(loop, find_segments(loop)); }

double error_of(SyntheticLoop shape, int samples) {
    shape.samples = samples;
    return energy_of(shape.make()).energy - shape.loss();
}

TEST(LoopEnergy, OfARectangleIsItsArea) {
    // 200 samples a side, corners sampled: force 2 on the way in, −1 on the way out
    Loop loop;
    const Index side = 200;
    loop.force.resize(4 * side);
    loop.force << Array1D::Zero(side), Array1D::Constant(side, 2.0), Array1D::Constant(side, -1.0), Array1D::Zero(side);
    loop.displacement.resize(4 * side);
    const Array1D rise = Array1D::LinSpaced(side, 0.0, 1.0);
    loop.displacement << rise - 1.0, rise, rise.reverse(), -rise;
    Segments segments{.contacts = {{.extent = {0, 4 * side - 1},
                                    .unloading = IndexRange{2 * side, 3 * side - 1},
                                    .pull_off = IndexRange{3 * side - 1, 3 * side}}}};
    EXPECT_NEAR(loop_energy(loop, segments).energy, 3.0, 1e-12);
}

TEST(LoopEnergy, ConvergesWithSecondOrderForEqualStepsInRadius) {
    const double coarse = error_of({.retraction_work = 0.07}, 200);
    const double fine = error_of({.retraction_work = 0.07}, 400);
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.02);
}

TEST(LoopEnergy, ConvergesWithOrderThreeHalvesInDisplacement) {
    const double coarse = error_of({.even_in_displacement = true}, 6400);
    const double fine = error_of({.even_in_displacement = true}, 12800);
    EXPECT_NEAR(std::log2(coarse / fine), 1.5, 0.05);
}

TEST(LoopEnergy, StatesItsDiscretisationError) {
    const SyntheticLoop shape{.retraction_work = 0.07, .samples = 200};
    const LoopEnergy energy = energy_of(shape.make());
    EXPECT_NEAR(energy.standard_error.discretisation / std::abs(energy.energy - shape.loss()), 1.0, 0.1);
}

TEST(LoopEnergy, IsIndependentOfBaselineAndLinearDrift) {
    const SyntheticLoop shape{.retraction_work = 0.07, .samples = 800};
    const Loop loop = shape.make();
    Loop drifting = loop;
    drifting.force += 5e-4 + 1e-8 * loop.time;
    const LoopEnergy energy = energy_of(drifting);
    EXPECT_NEAR(energy.energy / energy_of(loop).energy, 1.0, 1e-6);
    EXPECT_GT(std::abs(energy.without_drift / energy.energy - 1.0), 1e-4);
}

TEST(LoopEnergy, CoversTheTrueEnergyWithItsErrorBudget) {
    const SyntheticLoop shape{.retraction_work = 0.07, .samples = 800};
    const Loop clean = shape.make();
    int covered = 0;
    setae::tests::Pulls pulls;
    constexpr int seeds = 200;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        Loop loop = clean;
        loop.force = with_noise(clean.force, 1e-6, generator);
        loop.displacement = with_noise(clean.displacement, 2e-9, generator);
        const LoopEnergy energy = energy_of(loop);
        covered += std::abs(energy.energy - shape.loss()) < 1.96 * energy.standard_error.total;
        const auto& budget = energy.standard_error;
        pulls.add(energy.energy, shape.loss(), std::hypot(budget.noise, budget.drift, budget.discretisation));
    }
    EXPECT_GE(covered, 0.95 * seeds);
    expect_honest(pulls);  // without `sampling`: these jumps are sampled at both ends
}

TEST(LoopEnergy, OfAReversiblePartialReleaseIsZero) {
    // slow release and press along the same equilibrium curve
    SyntheticLoop shape{.samples = 400};
    const Loop whole = shape.make();
    tests::detail::Series series;
    const auto keep = [&](Index i) { series.add(whole.force[i], whole.displacement[i], whole.contact_radius[i]); };
    for (Index i = 0; i < 802; ++i) keep(i);
    tests::detail::add_branch(series, shape.approach, shape.largest_radius, 0.8 * shape.largest_radius, 100, false);
    tests::detail::add_branch(series, shape.approach, 0.8 * shape.largest_radius, 1.1 * shape.largest_radius, 150,
                              false);
    for (Index i = 802; i < whole.force.size(); ++i) keep(i);
    const Loop loop{.force = tests::detail::Series::array(series.force),
                    .displacement = tests::detail::Series::array(series.displacement)};
    const Segments segments = find_segments(loop);
    ASSERT_EQ(segments.cycles.size(), 2u);
    const auto energy = partial_loop_energy(loop, segments, 0);
    ASSERT_TRUE(energy.has_value());
    EXPECT_NEAR(energy->value, 0.0, 1e-6 * shape.loss());
    EXPECT_FALSE(partial_loop_energy(loop, segments, 1).has_value());
}

TEST(LoopEnergy, RequiresAClosedLoopAndADisplacement) {
    Loop loop = SyntheticLoop{.samples = 400}.make();
    const Loop loading{.force = loop.force.head(802), .displacement = loop.displacement.head(802)};
    EXPECT_THROW((void)energy_of(loading), UndefinedDataError);
    EXPECT_THROW((void)loop_energy(loop, find_segments(loop), 1), InvalidArgument);
    loop.displacement = Array1D();
    EXPECT_THROW((void)energy_of(loop), UndefinedDataError);
}

}  // namespace
}  // namespace setae::loops::loop_energy_test
