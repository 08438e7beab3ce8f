// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setae/contact/jkr.hpp"
#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::hold_test {
namespace {

/// A lens pressed with W = 40 mJ/m², held at its largest force while W grows to 55, and pulled off at that.
struct Held {
    static constexpr Index samples = 400;
    Loop loop;
    double radius_before = 0.0, radius_after = 0.0;
};

Held held_loop(double noise) {
    tests::SyntheticLoop smooth;
    smooth.even_in_displacement = true;
    const auto at = [&](double work, double force) {
        contact::jkr::Contact lens = smooth.approach;
        lens.work_of_adhesion = work;
        return contact::jkr::contact_radius_at_force(force, lens);
    };
    Held held;
    const Loop press = tests::piece(smooth.make(), 0, 802);
    tests::SyntheticLoop grown = smooth;
    grown.approach.work_of_adhesion = grown.retraction_work = 0.055;
    const double force = press.force[801];
    grown.largest_radius = at(0.055, force);
    const Loop release = tests::from(grown.make(), 802);
    held.radius_before = at(0.040, force);
    held.radius_after = grown.largest_radius;
    const Index n = press.force.size() + Held::samples + release.force.size();
    held.loop = {.time = 0.1 * Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)),
                 .force = Array1D(n),
                 .displacement = Array1D(n),
                 .contact_radius = Array1D(n)};
    Array1D pause_radius(Held::samples), pause_depth(Held::samples);
    for (Index i = 0; i < Held::samples; ++i) {
        const double share = static_cast<double>(i) / (Held::samples - 1);
        contact::jkr::Contact lens = smooth.approach;
        lens.work_of_adhesion = 0.040 + 0.015 * share;
        pause_radius[i] = at(lens.work_of_adhesion, force);
        pause_depth[i] = contact::jkr::displacement(pause_radius[i], lens);
    }
    held.loop.force << press.force, Array1D::Constant(Held::samples, force), release.force;
    held.loop.displacement << press.displacement, pause_depth, release.displacement;
    held.loop.contact_radius << press.contact_radius, pause_radius, release.contact_radius;
    if (noise > 0.0) {
        std::mt19937_64 generator(8);
        held.loop.force = tests::with_noise(held.loop.force, noise * force, generator);
    }
    return held;
}

TEST(Hold, EndsTheLoadingAndMeasuresContactGrowth) {
    // with noise the largest force lies anywhere in the hold: it does not end the loading there
    for (const double noise : {0.0, 1e-3}) {
        const Held held = held_loop(noise);
        const LoopAnalysis analysis = analyse(held.loop, tests::rubber_on_diamond());
        EXPECT_LE(analysis.loading.range.last, 802) << noise;
        if (noise > 0.0) {
            EXPECT_NE(analysis.loading.range.name.find("to the hold"), std::string::npos)
                << analysis.loading.range.name;
        }
        EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / 0.040, 1.0, noise > 0.0 ? 0.02 : 1e-6);
        EXPECT_NEAR(analysis.loading.primary().contact_modulus.value / 0.92e6, 1.0, noise > 0.0 ? 0.01 : 1e-6);
        EXPECT_NEAR(analysis.context.largest_contact_radius / held.radius_after, 1.0, 2e-3);
        EXPECT_GT(analysis.context.largest_contact_radius, 1.002 * held.radius_before);
        ASSERT_TRUE(analysis.hold);
        EXPECT_NEAR(analysis.hold->duration, 40.0, 8.0);
        ASSERT_TRUE(analysis.hold->work_of_adhesion);
        // means of the first and the last tenth
        EXPECT_NEAR(analysis.hold->work_of_adhesion->first.value, 0.041, 0.002);
        EXPECT_NEAR(analysis.hold->work_of_adhesion->last.value, 0.054, 0.002);
        EXPECT_GT(analysis.hold->contact_radius->last.value, analysis.hold->contact_radius->first.value);
        EXPECT_LT(analysis.hold->displacement->first.value, analysis.hold->displacement->last.value);
    }
}

TEST(Hold, IsEmptyWithoutPauseAtTheTurningPoint) {
    const LoopAnalysis analysis = analyse(tests::SyntheticLoop{}.make(), tests::rubber_on_diamond());
    EXPECT_FALSE(analysis.hold);
    EXPECT_NE(analysis.loading.range.name.find("to the largest force"), std::string::npos);
}

}  // namespace
}  // namespace setae::loops::hold_test
