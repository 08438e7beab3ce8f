// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/patches/patch_contact.hpp"

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::patches {
namespace {

PatchDesign small(double energy_share, std::uint64_t seed = 1) {
    return {.points = 64,
            .points_per_wave = 8.0,
            .waves_per_side = 2.0,
            .energy_share = energy_share,
            .squared_ratio = 1.0,
            .seed = seed};
}

// full contact gains that of the full-contact balance (Eq. 7): 1 − e of w
TEST(PatchContact, GainsTheFullContactBalanceInFullContact) {
    const auto contact = bring_into_contact(make_patch(small(0.08)));
    EXPECT_EQ(contact.from_far.area_fraction, 1.0);
    EXPECT_NEAR(contact.from_far.gain, 0.92, 1e-6);
    EXPECT_EQ(contact.closing_pressure, 0.0);
    EXPECT_TRUE(contact.from_far.converged);
}

// where full contact would store all that it gains, part of the patch still touches, and gains by it
TEST(PatchContact, GainsMoreThanTheBalanceInPartialContact) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const auto contact = bring_into_contact(make_patch(small(1.0, seed)));
        EXPECT_GT(contact.from_far.gain, 0.15);
        EXPECT_LT(contact.from_far.gain, 0.45);
        EXPECT_LT(contact.from_far.area_fraction, 0.75);
        EXPECT_GE(contact.after_preload.area_fraction, contact.from_far.area_fraction);
        ASSERT_TRUE(contact.closing_pressure);
        EXPECT_GT(*contact.closing_pressure, 0.1);
    }
}

TEST(PatchContact, ClosingPressureIsTheThresholdOfFullContact) {
    const Patch patch = make_patch(small(0.7));
    const auto contact = bring_into_contact(patch);
    ASSERT_TRUE(contact.closing_pressure);
    const auto area_at = [&](double pressure) {
        half_space::AdhesiveCell cell(patch.heights, patch.grid, patch.body, patch.interaction);
        return half_space::from_far(cell, half_space::DeadLoad{-pressure * patch.rms_slope}).area_fraction;
    };
    EXPECT_GE(area_at(1.1 * *contact.closing_pressure), closed_area);
    EXPECT_LT(area_at(0.85 * *contact.closing_pressure), closed_area);
    EXPECT_FALSE(bring_into_contact(patch, {.max_pressure = 0.5 * *contact.closing_pressure}).closing_pressure);
}

// p = σ + K h >= T everywhere: the first point opens where that fails, whatever came before
TEST(PatchContact, FullContactIsStableUpToTheOpeningTension) {
    const Patch patch = make_patch(small(0.1));
    const double opening = bring_into_contact(patch).opening_tension * patch.interaction.greatest_tension();
    ASSERT_GT(opening, 0.0);
    const auto area_at = [&](double tension) {
        half_space::AdhesiveCell cell(patch.heights, patch.grid, patch.body, patch.interaction);
        cell.begin_with(Array2D::Zero(64, 64));
        return cell.solve(half_space::DeadLoad{tension}).area_fraction;
    };
    EXPECT_EQ(area_at(0.99 * opening), 1.0);
    EXPECT_LT(area_at(1.05 * opening), 1.0);
}

// W_appr = 1 − e − D, W_sep = 1 − e + D; jumps lose no more than all
TEST(PatchContact, EnergyBudgetOfALoopIsClosed) {
    const Patch patch = make_patch(small(0.4));
    const auto loop = loop_of(patch);
    EXPECT_TRUE(loop.complete);
    EXPECT_LT(loop.leftover, 0.01);
    EXPECT_NEAR(loop.loss(), loop.approach_dissipation + loop.separation_dissipation, 0.02);
    EXPECT_GT(loop.greatest_tension, 0.0);
    double jumps = 0.0;
    for (const auto& of : loop.approach_jumps) jumps += of.loss;
    EXPECT_GT(jumps, 0.0);
    EXPECT_LE(jumps, loop.approach_dissipation + 0.02);
}

TEST(PatchContact, RefusesInvalidPressures) {
    const Patch patch = make_patch(small(0.4));
    EXPECT_THROW(bring_into_contact(patch, {.preload = 0.0}), InvalidArgument);
    EXPECT_THROW(bring_into_contact(patch, {.max_pressure = 0.0}), InvalidArgument);
}

}  // namespace
}  // namespace setae::patches
