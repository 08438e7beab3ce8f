// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

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

TEST(ForceDrift, IsTheSlopeOfFreeFlightWithItsError) {
    double pulls = 0.0;
    constexpr int seeds = 100;
    for (int seed = 0; seed < seeds; ++seed) {
        std::mt19937_64 generator(static_cast<std::uint64_t>(seed));
        Loop loop = drifting();
        loop.force = tests::with_noise(loop.force, 1e-7, generator);
        const Baseline before = find_segments(loop).before;
        pulls += std::pow((before.force_slope - rate) / before.force_slope_standard_error, 2) / seeds;
    }
    // the mean square of 100 pulls is 1 ± 0.14
    EXPECT_NEAR(std::sqrt(pulls), 1.0, 0.25);
}

TEST(ForceDrift, GoesOnWithTheSlopeOfTheFirstBaselineOnRequest) {
    // the sensor drifts until the last press and stands still from there on: the line between the baselines is wrong
    Loop loop = smooth.make();
    const Index peak = 2 * smooth.samples + 1;
    loop.force += rate * loop.time.min(loop.time[peak]);
    const auto error_of = [&](const AnalysisOptions& options) {
        return std::abs(
            analyse(loop, rubber_on_diamond(), options).loading.radius_force->work_of_adhesion.value / 0.040 - 1.0);
    };
    EXPECT_LT(error_of({.extrapolate_force_drift = true}), 1e-8);
    EXPECT_GT(error_of({}), 1e-4);
    EXPECT_GT(error_of({.force_drift = false}), 1e-4);
}

TEST(ForceDrift, OfTheWholeRecordIsTakenOffByEitherModel) {
    const Loop loop = drifting();
    for (const bool extrapolated : {false, true}) {
        const LoopAnalysis analysis = analyse(loop, rubber_on_diamond(), {.extrapolate_force_drift = extrapolated});
        EXPECT_NEAR(analysis.loading.radius_force->work_of_adhesion.value / 0.040, 1.0, 1e-8);
        EXPECT_NEAR(analysis.loop->energy / analyse(smooth.make(), rubber_on_diamond()).loop->energy, 1.0, 1e-6);
        EXPECT_GT(std::abs(analysis.loop->without_drift / analysis.loop->energy - 1.0), 1e-4);
    }
}

TEST(ForceDrift, HasTheErrorOfItsBaselinesInTheEnergy) {
    // the energy moves with either baseline as its budget says
    std::mt19937_64 generator(2);
    Loop loop = smooth.make();
    loop.force = tests::with_noise(loop.force, 1e-6, generator);
    Segments segments = find_segments(loop);
    const LoopEnergy energy = loop_energy(loop, segments);
    Segments higher = segments;
    higher.before.force += segments.before.force_standard_error;
    const double by_before = loop_energy(loop, higher).energy - energy.energy;
    higher = segments;
    higher.after->force += segments.after->force_standard_error;
    const double by_after = loop_energy(loop, higher).energy - energy.energy;
    EXPECT_NEAR(energy.standard_error.drift / std::hypot(by_before, by_after), 1.0, 1e-9);
    const LoopEnergy extrapolated = loop_energy(loop, segments, 0, DriftModel::extrapolated);
    Segments steeper = segments;
    steeper.before.force_slope += segments.before.force_slope_standard_error;
    const double by_slope = loop_energy(loop, steeper, 0, DriftModel::extrapolated).energy - extrapolated.energy;
    EXPECT_NEAR(extrapolated.standard_error.drift / std::abs(by_slope), 1.0,
                0.05);  // the opening times the zero's error is the rest
}

TEST(DisplacementDrift, IsTakenOffAtAKnownRate) {
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
