// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/balance_comparison.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/numerics/random_numbers.hpp"

namespace setae::adhesion::balance_comparison_test {
namespace {

constexpr double work = 0.045, gamma1 = 0.025;

struct TrueValues {
    double change = 0.0;   ///< χ [J/m²]
    double scatter = 0.0;  ///< of what is measured [J/m²]
};

/// Four surfaces × four elastomers, as [D19] has them.
std::vector<PairPoint> pairs(const TrueValues& known, std::uint64_t seed = 1) {
    std::vector<PairPoint> all;
    std::uint64_t counter = 0;
    const double ratios[] = {1.08, 1.25, 1.45, 1.7}, energies[] = {1e-9, 2e-9, 3e-9, 5e-9};
    const double moduli[] = {0.7e6, 1.0e6, 1.9e6, 2.6e6};
    for (int s = 0; s < 4; ++s)
        for (const double modulus : moduli) {
            PairPoint pair;
            const double r = ratios[s];
            pair.surface = std::string(1, static_cast<char>('A' + s));
            pair.elastomer = std::to_string(modulus);
            pair.slope = r;
            pair.offset = gamma1 * (r - 1.0) + modulus * energies[s];
            pair.measured.value = std::max(0.0, work * r - pair.offset - known.change * r * (r - 1.0) +
                                                    known.scatter * numerics::normal_number({seed, 0}, counter++));
            all.push_back(pair);
        }
    return all;
}

TEST(StrainedInterfaceFit, RecoversTrueParameters) {
    for (const double change : {-0.02, 0.0, 0.015}) {
        const auto fit = fit_strained_interface(pairs({.change = change}));
        EXPECT_NEAR(fit.interface_change.value, change, 1e-7);
        EXPECT_NEAR(fit.work_of_adhesion.value, work, 1e-7);
        EXPECT_NEAR(fit.r_squared, 1.0, 1e-9);
    }
}

// Standard errors are the scatter of 400 repetitions to 4 of its standard errors, 3.5 % each.
TEST(StrainedInterfaceFit, StandardErrorsMatchTheScatterOfRepetitions) {
    constexpr int repetitions = 400;
    double sum = 0.0, squares = 0.0, products = 0.0, work_squares = 0.0, stated = 0.0, stated_work = 0.0, rho = 0.0;
    for (int i = 0; i < repetitions; ++i) {
        const auto fit =
            fit_strained_interface(pairs({.change = 0.005, .scatter = 0.001}, static_cast<std::uint64_t>(i)));
        const double x = fit.interface_change.value - 0.005, w = fit.work_of_adhesion.value - work;
        sum += x / repetitions;
        squares += x * x / repetitions;
        work_squares += w * w / repetitions;
        products += x * w / repetitions;
        stated += fit.interface_change.variance() / repetitions;
        stated_work += fit.work_of_adhesion.variance() / repetitions;
        rho += fit.correlation / repetitions;
    }
    EXPECT_LT(std::abs(sum), 4.0 * std::sqrt(squares / repetitions));
    EXPECT_NEAR(std::sqrt(squares / stated), 1.0, 0.14);
    EXPECT_NEAR(std::sqrt(work_squares / stated_work), 1.0, 0.14);
    EXPECT_NEAR(products / std::sqrt(squares * work_squares), rho, 0.05);
}

TEST(StrainedInterfaceFit, RefusesOneAreaRatio) {
    auto same = pairs({});
    for (auto& pair : same) pair.slope = 1.3;
    EXPECT_THROW((void)fit_strained_interface(same), InvalidArgument);
    same.resize(2);
    EXPECT_THROW((void)fit_strained_interface(same), InvalidArgument);
}

TEST(BalanceScore, PrefersTheTrueBalance) {
    const auto simulated = pairs({.change = 0.02, .scatter = 0.0005});
    const auto modified = score_balance(simulated), strained = score_strained_interface(simulated);
    EXPECT_GT(strained.log_likelihood - modified.log_likelihood, 10.0);
    EXPECT_LT(strained.left_out_deviation, 0.5 * modified.left_out_deviation);
    EXPECT_EQ(strained.parameters, 2);
    // without a true change the second parameter gains half a χ² of one degree of freedom
    double gained = 0.0;
    constexpr int repetitions = 200;
    for (std::uint64_t seed = 0; seed < repetitions; ++seed) {
        const auto plain = pairs({.scatter = 0.0005}, seed);
        gained += (score_strained_interface(plain).log_likelihood - score_balance(plain).log_likelihood) / repetitions;
    }
    EXPECT_NEAR(gained, 0.57, 0.2);  // n/2 E ln(1 + F/(n − 2)) for n = 16
}

// By hand: three pairs of slope 1 and offset 0 measured 1, 2 and 6 on surfaces a, a, b.
TEST(BalanceScore, HasLeaveOneSurfaceOutErrors) {
    std::vector<PairPoint> points(3);
    const double measured[] = {1.0, 2.0, 6.0};
    for (int i = 0; i < 3; ++i) {
        points[static_cast<std::size_t>(i)].surface = i < 2 ? "a" : "b";
        points[static_cast<std::size_t>(i)].slope = 1.0;
        points[static_cast<std::size_t>(i)].measured.value = measured[i];
    }
    const auto score = score_balance(points);
    EXPECT_DOUBLE_EQ(score.work_of_adhesion, 3.0);
    EXPECT_DOUBLE_EQ(score.residual_squares, 14.0);
    EXPECT_NEAR(score.log_likelihood, -1.5 * std::log(14.0 / 3.0), 1e-12);
    // a from b: 6, b from a: 1.5
    EXPECT_NEAR(score.left_out_deviation, std::sqrt((25.0 + 16.0 + 4.5 * 4.5) / 3.0), 1e-12);
}

TEST(BalanceScore, OfFreeEnergiesHasNoLeaveOneSurfaceOutError) {
    std::vector<FreeEnergyPoint> points;
    for (const auto& pair : pairs({.scatter = 0.0005}))
        points.push_back({.pair = {.surface = pair.surface,
                                   .measured = pair.measured,
                                   .slope = pair.slope,
                                   .offset = gamma1 * (pair.slope - 1.0)},
                          .contact_modulus = std::stod(pair.elastomer)});
    const auto score = score_free_energies(points);
    EXPECT_EQ(score.parameters, 5);
    EXPECT_GE(score.log_likelihood, score_balance(pairs({.scatter = 0.0005})).log_likelihood - 1e-6);
    EXPECT_TRUE(std::isnan(score.left_out_deviation));
}

}  // namespace
}  // namespace setae::adhesion::balance_comparison_test
