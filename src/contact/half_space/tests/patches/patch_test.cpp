// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/patches/patch_contact.hpp"

namespace setae::patches {
namespace {

TEST(Patch, HasTheRequestedEnergy) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Patch patch = make_patch({.points = 64, .points_per_wave = 8.0, .energy_share = 0.3, .seed = seed});
        const half_space::AdhesiveCell cell(patch.heights, patch.grid, patch.body, patch.interaction);
        EXPECT_NEAR(cell.conformal_energy(), 0.3, 1e-12);
        EXPECT_NEAR(std::sqrt(patch.heights.square().mean()), patch.rms_height, 1e-12 * patch.rms_height);
        EXPECT_NEAR(half_space::resolution_of(patch.interaction, patch.body, patch.grid).squared_ratio, 0.5, 1e-12);
    }
}

// h_rms² = 2 e λ/(π …): a longer wave at the same energy is higher, and its range smaller beside it
TEST(Patch, RangeFallsWithFinerGrids) {
    const auto ratio = [](Index points, double points_per_wave) {
        return make_patch({.points = points, .points_per_wave = points_per_wave}).range_over_height();
    };
    EXPECT_NEAR(ratio(128, 16.0) / ratio(64, 8.0), std::sqrt(0.5), 0.02);
}

TEST(Patch, RefusesInvalidDesigns) {
    EXPECT_THROW(make_patch({.points = 32, .points_per_wave = 16.0}), InvalidArgument);
    EXPECT_THROW(make_patch({.points = 1000000}), InvalidArgument);
    EXPECT_THROW(make_patch({.energy_share = 0.0}), InvalidArgument);
    EXPECT_THROW(make_patch({.squared_ratio = 1.5}), InvalidArgument);
    EXPECT_THROW(make_patch({.points_per_wave = 2.0}), InvalidArgument);
    EXPECT_THROW(make_patch({.points = 64, .points_per_wave = 8.0, .spectrum = [](double) { return 0.0; }}),
                 InvalidArgument);
}

}  // namespace
}  // namespace setae::patches
