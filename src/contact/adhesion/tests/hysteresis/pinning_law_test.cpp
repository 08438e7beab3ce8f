// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/pinning_law.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::hysteresis {
namespace {

/// Rows of docs/validation/crack-front.md: k of fronts at rest, mean and standard error over seeds.
struct SimulatedFronts {
    double energy_share, larkin_lengths, k, standard_error;
};
constexpr SimulatedFronts simulated[] = {
    {0.3, 1.45, 0.289, 0.01},   {0.3, 2.90, 0.567, 0.01},   {0.3, 5.81, 0.859, 0.015},  {0.3, 11.6, 1.103, 0.02},
    {0.3, 23.1, 1.285, 0.02},   {0.3, 46.3, 1.425, 0.02},   {0.1, 0.48, 0.128, 0.03},   {0.1, 0.97, 0.416, 0.025},
    {0.1, 1.93, 0.799, 0.025},  {0.1, 3.86, 1.201, 0.02},   {0.1, 7.73, 1.547, 0.02},   {0.1, 15.4, 1.828, 0.03},
    {0.1, 61.9, 2.143, 0.03},   {0.03, 0.58, 0.449, 0.03},  {0.03, 1.16, 0.904, 0.03},  {0.03, 2.32, 1.401, 0.03},
    {0.03, 18.5, 2.506, 0.04},  {0.01, 0.39, 0.369, 0.04},  {0.01, 0.77, 0.875, 0.06},  {0.01, 1.54, 1.449, 0.06},
    {0.01, 12.4, 2.719, 0.06},  {0.003, 0.46, 0.614, 0.06}, {0.003, 0.93, 1.145, 0.07}, {0.003, 3.71, 2.287, 0.10},
    {0.001, 0.31, 0.405, 0.09}, {0.001, 0.62, 0.932, 0.10}};

TEST(PinningCoefficient, MatchesSimulatedFronts) {
    for (const auto& fronts : simulated) {
        const auto k = pinning_constants(fronts.energy_share, fronts.larkin_lengths);
        // 5 %: fronts only two to four times as long as their springs let them bend have so much more
        EXPECT_NEAR(k.approach.value, fronts.k, 2.0 * fronts.standard_error + 0.05 * fronts.k)
            << fronts.energy_share << ' ' << fronts.larkin_lengths;
        EXPECT_EQ(k.approach.value, k.retraction.value);
    }
}

// edges of circular contacts of three surfaces, k from W_appr and W_ret at a given radius,
// docs/validation/crack-front.md
TEST(PinningCoefficient, MatchesEdgesOfCircularContacts) {
    constexpr SimulatedFronts round[] = {{0.1, 5.33, 1.40, 0.03},  {0.1, 5.86, 1.48, 0.04},  {0.1, 6.57, 1.50, 0.05},
                                         {0.1, 7.66, 1.52, 0.03},  {0.1, 9.42, 1.61, 0.06},  {0.1, 13.4, 1.77, 0.04},
                                         {0.03, 4.01, 1.80, 0.03}, {0.03, 4.40, 1.86, 0.04}, {0.03, 4.90, 1.91, 0.04},
                                         {0.03, 5.78, 2.03, 0.08}, {0.03, 7.17, 2.12, 0.04}, {0.03, 10.1, 2.28, 0.06}};
    for (const auto& contact : round)
        EXPECT_NEAR(pinning_constants(contact.energy_share, contact.larkin_lengths).retraction.value, contact.k,
                    2.0 * contact.standard_error);
}

TEST(PinningCoefficient, IncreasesWithFrontLengthAndFallsWithEnergyShare) {
    for (double share = 0.001; share < 0.3; share *= 1.5)
        for (double length = 0.5; length < 500.0; length *= 1.5) {
            const double k = pinning_constants(share, length).approach.value;
            EXPECT_GT(pinning_constants(share, 1.5 * length).approach.value, k);
            EXPECT_LT(pinning_constants(1.2 * share, length).approach.value, k);
        }
    EXPECT_EQ(pinning_constants(0.1, 0.0).approach.value, 0.0);
}

TEST(PinningCoefficient, HasALargerErrorOutsideTheSimulatedRange) {
    EXPECT_TRUE(pinning_constants(0.0625, 30.0).measured);
    const auto far = pinning_constants(0.01, 200.0), inside = pinning_constants(0.01, 12.0);
    EXPECT_FALSE(far.measured);
    EXPECT_GT(far.approach.standard_error, far.approach.value - inside.approach.value);
    EXPECT_FALSE(pinning_constants(0.6, 30.0).measured);
    EXPECT_GT(pinning_constants(0.6, 30.0).approach.standard_error, 0.3 * pinning_constants(0.6, 30.0).approach.value);
    EXPECT_FALSE(pinning_constants(0.1, 0.1).measured);
    EXPECT_FALSE(pinning_constants(1e-4, 1.0).measured);
    EXPECT_THROW((void)pinning_constants(-0.1, 1.0), InvalidArgument);
    EXPECT_THROW((void)pinning_constants(0.1, -1.0), InvalidArgument);
}

// waves of a roll-off 16 and 32 times the shortest wave, H = 0.5 to 0.95
TEST(PinningCoefficient, ErrorIncludesTheWidthOfTheBand) {
    constexpr SimulatedFronts wide[] = {{0.1, 2.44, 1.16, 0.07},  {0.1, 3.50, 1.33, 0.06},  {0.1, 2.20, 1.05, 0.06},
                                        {0.03, 2.90, 1.80, 0.03}, {0.03, 2.55, 1.72, 0.03}, {0.1, 7.28, 1.52, 0.02},
                                        {0.1, 8.80, 1.58, 0.02},  {0.1, 12.56, 1.69, 0.02}};
    for (const auto& fronts : wide) {
        const auto k = pinning_constants(fronts.energy_share, fronts.larkin_lengths).approach;
        EXPECT_NEAR(k.value, fronts.k, 1.5 * k.standard_error) << fronts.energy_share << ' ' << fronts.larkin_lengths;
    }
}

// Dalvi et al. 2019, polished nanodiamond on 0.7 to 10 MPa, from 1 mN to pull-off: N by crack_front::larkin_lengths()
TEST(PinningCoefficient, MatchesThePublishedPolishedSurface) {
    EXPECT_NEAR(pinning_constants(0.0043, 4.4).approach.value, 2.27, 0.02);
    EXPECT_NEAR(pinning_constants(0.0043, 8.8).retraction.value, 2.63, 0.02);
    EXPECT_NEAR(pinning_constants(0.0625, 25.9).approach.value, 2.19, 0.02);
    EXPECT_NEAR(pinning_constants(0.0625, 52.3).retraction.value, 2.33, 0.02);
}

constexpr double endless = std::numeric_limits<double>::infinity();

TEST(PinningCoefficient, OfOneBandEqualsThatOfAllWaves) {
    EXPECT_DOUBLE_EQ(pinning_by_bands(2e-3, {{1.0, 1e-6}}, 40e-3, endless),
                     pinning_constants(0.05, endless).retraction.value * 2e-3);
    // ℓ = 20 µm on waves of 1 µm, L_c = 1 µm/(4 · 0.05) = 5 µm
    EXPECT_DOUBLE_EQ(pinning_by_bands(2e-3, {{1.0, 1e-6}}, 40e-3, 20e-6), pinning_constant(0.05, 4.0) * 2e-3);
}

TEST(PinningCoefficient, IsLargerForSeparateBandsThanForAllWavesTogether) {
    const double at_once = pinning_by_bands(4e-3, {{1.0, 1e-6}}, 40e-3, endless);
    const double by_two = pinning_by_bands(4e-3, {{0.5, 1e-6}, {0.5, 4e-6}}, 40e-3, endless);
    EXPECT_GT(by_two, at_once);
    EXPECT_DOUBLE_EQ(by_two, pinning_constants(0.05, endless).retraction.value * 4e-3);
}

TEST(PinningCoefficient, EqualsThatOfTheRetraction) {
    for (const double share : {0.0, 0.004, 0.1, 0.7})
        for (const double length : {0.0, 0.3, 12.0, endless})
            EXPECT_EQ(pinning_constant(share, length), pinning_constants(share, length).retraction.value);
    EXPECT_THROW((void)pinning_constant(-0.1, 1.0), InvalidArgument);
}

TEST(EdgeLarkinLengths, AreZeroWithoutStoredEnergyAndInfiniteWithoutASphere) {
    EXPECT_EQ(edge_larkin_lengths(1e-4, 1e-6, 0.0), 0.0);
    EXPECT_EQ(edge_larkin_lengths(endless, 0.0, 0.0), 0.0);
    EXPECT_EQ(edge_larkin_lengths(endless, 0.0, 0.1), endless);
    EXPECT_DOUBLE_EQ(edge_larkin_lengths(1e-4, 1e-6, 0.05), 20.0);
    EXPECT_THROW((void)edge_larkin_lengths(1e-4, 0.0, 0.1), InvalidArgument);
}

// closed forms of JKR: pull-off under a dead load at a = (9πWR²/8E*)^⅓, where ℓ = 2πa/4; without load ℓ = 2πa/10
TEST(EdgeLengths, MatchTheJkrContact) {
    const contact::AdhesiveContact sphere{1.25e-3, 0.92e6, 0.039};
    const double pull_off = std::cbrt(9.0 * pi * 0.039 * 1.25e-3 * 1.25e-3 / (8.0 * 0.92e6));
    const double unloaded = std::cbrt(4.0) * pull_off;
    const auto lengths = edge_lengths(unloaded, sphere);
    EXPECT_NEAR(lengths.retraction / (0.5 * pi * pull_off), 1.0, 1e-9);
    EXPECT_NEAR(lengths.approach / (0.2 * pi * unloaded), 1.0, 1e-9);
    EXPECT_THROW((void)edge_lengths(0.0, sphere), InvalidArgument);
}

}  // namespace
}  // namespace setae::hysteresis
