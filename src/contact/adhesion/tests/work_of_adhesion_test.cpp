// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/work_of_adhesion.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::adhesion::work_of_adhesion_test {
namespace {

TEST(ModifiedBalance, OfAFlatSurfaceEqualsTheIntrinsicWork) {
    EXPECT_EQ(modified_balance(0.037, 0.025, {1.0, 0.0}).raw, 0.037);
}

TEST(ModifiedBalance, WithoutStiffnessMatchesTableS1) {
    // THEORY §11: W_app(E → 0) with W_int 37, γ1 25 mJ/m² for the slopes of Table S1
    for (const auto& [slope, expected] : {std::pair{0.39, 37.85}, {1.46, 45.26}, {1.15, 42.70}, {1.07, 42.08}})
        EXPECT_NEAR(1e3 * modified_balance(0.037, 0.025, {roughness::gaussian_area_ratio(slope), 0.0}).raw, expected,
                    0.005)
            << slope;
}

TEST(ModifiedBalance, IsFlooredAtZeroAndFlagged) {
    const auto work = modified_balance(0.037, 0.025, {1.2, 0.1});
    EXPECT_LT(work.raw, 0.0);
    EXPECT_EQ(work.floored, 0.0);
    EXPECT_FALSE(work.conforms);
}

TEST(ModifiedBalance, RefusesInvalidInput) {
    EXPECT_THROW((void)modified_balance(-0.01, 0.025, {1.0, 0.0}), InvalidArgument);
    EXPECT_THROW((void)modified_balance(0.037, 0.025, {0.9, 0.0}), InvalidArgument);
    EXPECT_THROW((void)modified_balance(0.037, 0.025, {1.1, -1.0}), InvalidArgument);
}

TEST(Balances, DifferByTheStretchingOfTheElastomer) {
    const ConformalState state{1.5, 0.01};
    EXPECT_NEAR(balance_without_area_change(0.037, state).raw - modified_balance(0.037, 0.025, state).raw, 0.0125,
                1e-15);
    EXPECT_NEAR(persson_tosatti_balance(0.037, 1.0, 0.01).raw, balance_without_area_change(0.037, state).raw, 1e-15);
}

TEST(PrintedBalance, EqualsTheModifiedBalanceForConstantSurfaceEnergy) {
    const ConformalState state{1.688, 0.004};
    EXPECT_NEAR(printed_balance(0.037, {Array1D::Ones(1), Array1D::Constant(1, 0.025)}, state).raw,
                modified_balance(0.037, 0.025, state).raw, 1e-16);
}

TEST(PrintedBalance, OfALinearSurfaceEnergyMatchesTheClosedForm) {
    // γ = γ1 + χ (x − 1): W*_int = W + χ (r − 1), integral γ1 (r − 1) + χ (r − 1)²/2
    const double r = 1.5, chi = 0.02, w = 0.037, gamma = 0.025;
    const double expected = (w + chi * (r - 1.0)) * r - gamma * (r - 1.0) - 0.5 * chi * (r - 1.0) * (r - 1.0) - 0.003;
    const SurfaceEnergyLaw law{Array1D{{1.0, 3.0}}, Array1D{{gamma, gamma + chi * 2.0}}};
    EXPECT_NEAR(printed_balance(w, law, {r, 0.003}).raw, expected, 1e-16);
}

// Along the way: stretching costs ∫ Υ dA with Υ = d(γ1s A)/dA, covering then gains γ1s + γ2 − γ1s2 on the stretched
// area.
TEST(EndStateBalance, EqualsTheIntegralForAnySurfaceEnergy) {
    const double r = 1.5, gamma1 = 0.025, gamma2 = 0.040, gamma12 = 0.028, gamma1s2 = 0.031, stored = 0.003;
    const auto law = [&](double x) { return gamma1 + 0.025 * (x - 1.0) + 0.01 * std::sin(7.0 * (x - 1.0)); };
    constexpr int steps = 2000;
    double stretching = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double x = 1.0 + (r - 1.0) * i / steps, next = 1.0 + (r - 1.0) * (i + 1) / steps;
        const double stress = (law(next) * next - law(x) * x) / (next - x);
        stretching += stress * (next - x);
    }
    const double along = (law(r) + gamma2 - gamma1s2) * r - stretching - stored;
    const double work = gamma1 + gamma2 - gamma12;
    EXPECT_NEAR(end_state_balance(work, gamma1, gamma1s2 - gamma12, {r, stored}).raw, along, 1e-15);
    EXPECT_NEAR(end_state_balance(work, gamma1, 0.0, {r, stored}).raw, modified_balance(work, gamma1, {r, stored}).raw,
                1e-16);
}

// The audit's case: 16 mJ/m² that are not there.
TEST(PrintedBalance, CountsTheChangeOfSurfaceEnergyTwice) {
    const double r = 1.5, chi = 0.025, gamma = 0.025;
    const SurfaceEnergyLaw law{Array1D{{1.0, 2.0}}, Array1D{{gamma, gamma + chi}}};
    EXPECT_NEAR(printed_balance(0.037, law, {r, 0.0}).raw - end_state_balance(0.037, gamma, 0.0, {r, 0.0}).raw,
                0.5 * chi * (r * r - 1.0), 1e-15);
    EXPECT_NEAR(0.5 * chi * (r * r - 1.0), 0.0156, 1e-4);
}

TEST(SurfaceEnergyLaw, IsLinearBetweenNodesAndConstantOutside) {
    SurfaceEnergyLaw law{Array1D(3), Array1D(3)};
    law.area_ratio << 1.0, 1.2, 1.4;
    law.surface_energy << 0.02, 0.03, 0.025;
    EXPECT_NEAR(law.at(1.1), 0.025, 1e-16);
    EXPECT_EQ(law.at(9.0), 0.025);
    EXPECT_NEAR(law.integral(1.4), 0.2 * 0.025 + 0.2 * 0.0275, 1e-16);
    EXPECT_NEAR(law.integral(2.4), law.integral(1.4) + 0.025, 1e-16);
    law.area_ratio << 1.0, 1.2, 1.1;
    EXPECT_THROW((void)printed_balance(0.037, law, {1.1, 0.0}), InvalidArgument);
}

}  // namespace
}  // namespace setae::adhesion::work_of_adhesion_test
