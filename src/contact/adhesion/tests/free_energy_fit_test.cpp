// SPDX-License-Identifier: GPL-3.0-or-later
// What surfaces store, free of their spectra: closed forms, drawn truths, the floor.
#include "setae/adhesion/free_energy_fit.hpp"

#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "setae/core/statistics.hpp"

namespace setae::adhesion::free_energy_fit_test {
namespace {

constexpr double W = 0.037, gamma_1 = 0.025, gamma_error = 0.005;
constexpr std::array moduli{0.3e6, 0.9e6, 1.4e6, 2.5e6};

Components one(const std::string& name, double size) { return {{name, {Array1D::Constant(1, size)}}}; }

double stored(int surface) { return 1e-9 * surface; }

/// Three surfaces that store 0, 1 and 2 nm × E*, four elastomers, measured exactly.
std::vector<FreeEnergyPoint> points(double noise) {
    std::vector<FreeEnergyPoint> list;
    for (int s = 0; s < 3; ++s)
        for (const double modulus : moduli) {
            FreeEnergyPoint point{{.surface = "s" + std::to_string(s), .elastomer = std::to_string(modulus)}, modulus};
            point.pair.slope = 1.1 + 0.2 * s;
            point.pair.offset = gamma_1 * (point.pair.slope - 1.0);
            point.pair.measured = {point.storing(stored(s)).prediction(W), noise};
            list.push_back(std::move(point));
        }
    return list;
}

GeneralisedFreeEnergies generalised(const std::vector<FreeEnergyPoint>& list) {
    return fit_free_energies_generalised(list, fit_with_free_energies(list)).value();
}

TEST(FreeEnergies, RecoverTheStoredEnergyOfEachSurface) {
    const auto fit = fit_with_free_energies(points(0.0));
    EXPECT_NEAR(fit.work_of_adhesion, W, 1e-6);
    EXPECT_NEAR(fit.r_squared, 1.0, 1e-6);
    for (int s = 0; s < 3; ++s)
        EXPECT_NEAR(fit.energy_per_modulus[static_cast<std::size_t>(s)].second, stored(s), 1e-12);
}

// Without shared inputs V = σ² 1 and the covariance of θ is σ² (XᵀX)⁻¹; that of u_0, at its floor, takes no part.
TEST(FreeEnergies, HaveTheErrorsOfLinearLeastSquares) {
    constexpr double sigma = 1e-4;
    auto list = points(sigma);
    list[0].pair.measured.value += 3.0 * sigma;  // the softest pair of s0 high: u_0 would be > 0
    list[3].pair.measured.value -= 3.0 * sigma;
    const auto fit = generalised(list);
    Eigen::MatrixXd X = Eigen::MatrixXd::Zero(12, 4);
    for (Index i = 0; i < 12; ++i) {
        X(i, 0) = list[static_cast<std::size_t>(i)].pair.slope;
        X(i, 1 + i / 4) = -moduli[static_cast<std::size_t>(i % 4)];
    }
    const Eigen::MatrixXd covariance = (X.transpose() * X).inverse();
    ASSERT_GT(fit.energies[0].energy_per_modulus.value, 0.0);
    const double size = std::sqrt(sigma * sigma + fit.scatter.pair * fit.scatter.pair);
    EXPECT_NEAR(fit.work_of_adhesion.standard_error / (size * std::sqrt(covariance(0, 0))), 1.0, 1e-6);
    for (Index s = 0; s < 3; ++s)
        EXPECT_NEAR(fit.energies[static_cast<std::size_t>(s)].energy_per_modulus.standard_error /
                        (size * std::sqrt(covariance(1 + s, 1 + s))),
                    1.0, 1e-6);
}

TEST(FreeEnergies, AtTheFloorHaveAOneSidedInterval) {
    constexpr double sigma = 1e-4;
    auto list = points(sigma);
    list[0].pair.measured.value -= 2.0 * sigma;  // the softest pair of s0 low: u_0 would be < 0
    list[3].pair.measured.value += 2.0 * sigma;
    const auto fit = generalised(list);
    const auto& none = fit.energies[0].energy_per_modulus;
    EXPECT_EQ(none.value, 0.0);
    EXPECT_TRUE(std::isnan(none.standard_error));
    EXPECT_NE(none.method.find("one-sided"), std::string::npos) << none.method;
    ASSERT_TRUE(none.interval);
    EXPECT_EQ(none.interval->lower, 0.0);
    EXPECT_GT(none.interval->upper, 0.0);
    EXPECT_LT(none.interval->upper, stored(1)) << "what s1 stores is far more than s0 may";
    EXPECT_TRUE(fit.energies[1].energy_per_modulus.uncertain());
}

TEST(FreeEnergies, RequireMorePairsThanParametersAndSeveralModuli) {
    const auto all = points(1e-4);
    std::vector<FreeEnergyPoint> of_one_elastomer;
    for (const auto& point : all)
        if (point.pair.elastomer == all.front().pair.elastomer) of_one_elastomer.push_back(point);
    EXPECT_FALSE(fit_free_energies_generalised(of_one_elastomer, fit_with_free_energies(of_one_elastomer)));
    auto alike = all;
    for (auto& point : alike) point.contact_modulus = moduli[0];
    EXPECT_FALSE(fit_free_energies_generalised(alike, fit_with_free_energies(alike)));
}

// W ± with γ1 shared is larger than without, and rests on it by name: the derivative by refits of pairs that are off as
// γ1 would make them, every surface storing something.
TEST(FreeEnergies, PropagateSharedInputs) {
    auto list = points(1e-4);
    for (auto& point : list) {
        point.pair.measured.value -= 1e-9 * point.contact_modulus.value;
        point.pair.offset_inputs = one("gamma", gamma_error * (point.pair.slope - 1.0));
        point.contact_modulus.components = one("E of " + point.pair.elastomer, 0.01 * point.contact_modulus.value);
    }
    const auto moved = [&](double by) {
        auto there = list;
        for (auto& point : there) point.pair.measured.value += by * gamma_error * (point.pair.slope - 1.0);
        return generalised(there).work_of_adhesion.value;
    };
    const auto fit = generalised(list);
    const double step = 0.01, found = (moved(step) - moved(-step)) / (2.0 * step);
    EXPECT_NEAR(fit.traced_work_of_adhesion.components.at("gamma").directions[0] / found, 1.0, 1e-3);
    EXPECT_GT(fit.work_of_adhesion.standard_error, generalised(points(1e-4)).work_of_adhesion.standard_error);
    EXPECT_TRUE(fit.traced_work_of_adhesion.components.contains("E of " + list.front().pair.elastomer));
}

// Truths drawn with lens, γ1 and moduli as uncertain as told, one surface storing nothing.
TEST(FreeEnergies, IntervalsCoverTrueValues) {
    constexpr int draws = 100;
    constexpr double noise = 8e-4;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    int held = 0, stored_held = 0, nothing_held = 0;
    for (int d = 0; d < draws; ++d) {
        auto list = points(noise);
        const double gamma = gamma_error * normal(random), gain = 0.02 * normal(random);
        std::array<double, 4> stiffer{};
        for (auto& s : stiffer) s = 0.02 * normal(random);
        for (std::size_t i = 0; i < list.size(); ++i) {
            auto& point = list[i];
            const double modulus = moduli[i % 4] * (1.0 + stiffer[i % 4]);
            const double truth = W * point.pair.slope - (gamma_1 + gamma) * (point.pair.slope - 1.0) -
                                 modulus * stored(static_cast<int>(i / 4));
            point.pair.measured.value = truth * (1.0 + gain) + noise * normal(random);
            point.pair.in_unitputs = one("lens", 0.02 * point.pair.measured.value);
            point.pair.offset_inputs = one("gamma", gamma_error * (point.pair.slope - 1.0));
            point.contact_modulus.components = one("E of " + point.pair.elastomer, 0.02 * point.contact_modulus.value);
        }
        const auto fit = generalised(list);
        const auto holds = [](const Estimate& estimate, double value) {
            const auto interval = interval_of(estimate);
            return interval && interval->lower <= value && value <= interval->upper ? 1 : 0;
        };
        held += holds(fit.work_of_adhesion, W);
        stored_held += holds(fit.energies[2].energy_per_modulus, stored(2));
        nothing_held += holds(fit.energies[0].energy_per_modulus, 0.0);
    }
    EXPECT_GE(held, 90);
    EXPECT_GE(stored_held, 90);
    EXPECT_GE(nothing_held, 95);
    EXPECT_LT(held + stored_held, 2 * draws) << "intervals that hold everything are too wide";
}

}  // namespace
}  // namespace setae::adhesion::free_energy_fit_test
