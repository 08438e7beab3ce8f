// SPDX-License-Identifier: GPL-3.0-or-later
// The posterior of W: closed forms where scatter is absent, coverage where it is drawn, and its limits.
#include "setae/adhesion/work_posterior.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::adhesion::work_posterior_test {
namespace {

Components one(const std::string& name, double size) { return {{name, {Array1D::Constant(1, size)}}}; }

constexpr double W = 0.037, gamma_1 = 0.025;

/// A design like the published one: four surfaces, four elastomers, true values of (7) drawn with everything that is
/// uncertain; three of the pairs at their floor.
class Design {
public:
    explicit Design(std::uint64_t seed) : random_(seed) {}

    std::vector<PairPoint> pairs(double pair, double surface, double elastomer) {
        static constexpr double ratio[] = {1.07, 1.69, 1.48, 1.42}, energy[] = {0.18e-9, 3.0e-9, 6.0e-9, 6.5e-9},
                                ratio_error[] = {0.014, 0.2, 0.085, 0.083}, energy_error[] = {0.4, 0.5, 0.5, 0.5},
                                modulus[] = {0.92e6, 1.37e6, 2.55e6, 13.4e6};
        std::vector<PairPoint> list;
        double r[4], u[4], s[4], e[4];
        for (int i = 0; i < 4; ++i) {
            r[i] = ratio[i] * std::exp(ratio_error[i] / ratio[i] * draw());
            u[i] = energy[i] * std::exp(energy_error[i] * draw());
            s[i] = surface * draw();
            e[i] = elastomer * draw();
        }
        const double gamma = gamma_1 + 0.005 * draw();
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) {
                PairPoint p{.surface = "s" + std::to_string(i), .elastomer = "e" + std::to_string(k)};
                const double truth = W * r[i] - gamma * (r[i] - 1.0) - modulus[k] * u[i];
                const double own = 0.002;
                p.measured = {std::max(0.0, std::max(0.0, truth) + s[i] + e[k] + pair * draw() + own * draw()), own};
                p.slope = ratio[i];
                p.offset = gamma_1 * (ratio[i] - 1.0) + modulus[k] * energy[i];
                p.slope_inputs = one("area of " + p.surface, ratio_error[i]);
                p.offset_inputs =
                    combined({{gamma_1, p.slope_inputs},
                              {1.0, one("gamma", 0.005 * (ratio[i] - 1.0))},
                              {1.0, one("energy of " + p.surface, energy_error[i] * modulus[k] * energy[i])}});
                list.push_back(std::move(p));
            }
        return list;
    }

private:
    double draw() { return normal_(random_); }
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
};

// Pairs that agree to their own noise: least squares weighted by it, W = Σ r y/Σ r², ± σ/√Σ r²
TEST(WorkPosterior, OfExactPairsEqualsLeastSquares) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal(0.0, 1e-5);
    std::vector<PairPoint> list;
    double numerator = 0.0, denominator = 0.0;
    for (int i = 0; i < 12; ++i) {
        PairPoint p{.surface = "s" + std::to_string(i), .elastomer = "e" + std::to_string(i)};
        p.slope = 1.0 + 0.1 * i;
        p.offset = 0.001 * i;
        p.measured = {W * p.slope - p.offset + normal(random), 1e-5};
        numerator += p.slope * (p.measured.value + p.offset);
        denominator += p.slope * p.slope;
        list.push_back(std::move(p));
    }
    const WorkPosterior posterior(list);
    const auto& found = posterior.work_of_adhesion();
    EXPECT_NEAR(found.value, numerator / denominator, 0.3e-5 / std::sqrt(denominator));
    // scatter that may be there widens it a little
    EXPECT_GT(found.standard_error, 0.95e-5 / std::sqrt(denominator));
    EXPECT_LT(found.standard_error, 1.9e-5 / std::sqrt(denominator));
}

// Two pairs of one surface, known far better than the surface: W = (y + o)/r, its ± that of the inputs, which pull on
// both alike. Noise counts as an input that no other pair has, or as the pair's own.
TEST(WorkPosterior, OfOneSurfaceMeasuredExactlyHasTheErrorOfItsSpectrum) {
    const double r = 1.163, r_error = 0.017, energy = 0.526e-9, energy_error = 0.032e-9, gamma_error = 0.001;
    for (const double own : {0.0, 1e-7, 2e-5}) {
        std::vector<PairPoint> list;
        for (const double modulus : {0.93e6, 2.53e6}) {
            PairPoint p{.surface = "s", .elastomer = "e" + std::to_string(list.size())};
            p.slope = r;
            p.offset = gamma_1 * (r - 1.0) + modulus * energy;
            p.measured = {W * r - p.offset + (list.empty() ? 1e-5 : -1e-5), std::hypot(own, 2e-5)};
            p.measured_noise = one("fit of " + p.elastomer, 2e-5);
            p.slope_inputs = one("area", r_error);
            p.offset_inputs = combined({{gamma_1, p.slope_inputs},
                                        {1.0, one("gamma of " + p.elastomer, gamma_error * (r - 1.0))},
                                        {1.0, one("energy", energy_error * modulus)}});
            list.push_back(std::move(p));
        }
        const auto found = WorkPosterior(list).work_of_adhesion();
        // the least that the area alone leaves, and that with all of the stored energy of the stiffer one
        const double by_area = r_error * (W - gamma_1) / r, by_energy = energy_error * 2.53e6 / r;
        EXPECT_NEAR(found.value, W, 3e-5) << own;
        EXPECT_GT(found.standard_error, 0.9 * by_area) << own;
        EXPECT_LT(found.standard_error, 1.1 * std::hypot(by_area, by_energy, gamma_error * 0.163 / r)) << own;
    }
}

TEST(WorkPosterior, IntervalAndStandardErrorAreConsistent) {
    const WorkPosterior posterior(Design(4).pairs(0.005, 0.005, 0.005));
    const auto& found = posterior.work_of_adhesion();
    ASSERT_TRUE(found.interval);
    const double half = 0.5 * (found.interval->upper - found.interval->lower) / found.standard_error;
    EXPECT_GT(half, 1.7);
    EXPECT_LT(half, 2.4);
    const double total = (0.5 *
                          (posterior.density().head(posterior.grid().size() - 1) +
                           posterior.density().tail(posterior.grid().size() - 1)) *
                          (posterior.grid()[1] - posterior.grid()[0]))
                             .sum();
    EXPECT_NEAR(total, 1.0, 1e-9);
}

TEST(WorkPosterior, DrawsMatchTheStatedPosterior) {
    const auto list = Design(5).pairs(0.005, 0.005, 0.005);
    const WorkPosterior posterior(list);
    const auto draws = posterior.draw(list, 4000, 7);
    const auto& work = posterior.work_of_adhesion();
    EXPECT_NEAR(draws.work_of_adhesion->standard_error / work.standard_error, 1.0, 0.06);
    EXPECT_NEAR(draws.work_of_adhesion->interval.lower, work.interval->lower, 0.15 * work.standard_error);
    EXPECT_NEAR(draws.work_of_adhesion->interval.upper, work.interval->upper, 0.15 * work.standard_error);
    const auto again = posterior.draw(list, 100, 7), other = posterior.draw(list, 100, 8);
    EXPECT_EQ(posterior.draw(list, 100, 7).predictions[3].standard_error, again.predictions[3].standard_error);
    EXPECT_NE(other.predictions[3].standard_error, again.predictions[3].standard_error);
}

TEST(WorkPosterior, StandardErrorIsTracedToItsInputs) {
    const auto list = Design(6).pairs(0.005, 0.0, 0.0);
    const WorkPosterior posterior(list);
    const auto traced = traced_work(posterior, list);
    EXPECT_DOUBLE_EQ(traced.value, posterior.work_of_adhesion().value);
    EXPECT_NEAR(traced.standard_error() / posterior.work_of_adhesion().standard_error, 1.0, 1e-12);
    EXPECT_TRUE(traced.components.contains("gamma"));
}

// The suite's share of docs/validation/estimators.md: 95 of 100 within binomial limits
TEST(WorkPosterior, IntervalsHaveTheStatedCoverage) {
    constexpr int sets = 60;
    int held = 0;
    for (int set = 0; set < sets; ++set) {
        const auto found = WorkPosterior(Design(100 + set).pairs(0.005, 0.005, 0.005)).work_of_adhesion();
        held += found.interval->lower <= W && W <= found.interval->upper ? 1 : 0;
    }
    EXPECT_GE(held, 52);  // 0.2 % of the time by chance at 95 %
}

// Own noise, errors of areas and of energies of any size, few pairs or many: the true value is within four standard
// errors, which are neither nothing nor more than all errors together
TEST(WorkPosterior, CoversTheTrueWorkForErrorsOfAnySize) {
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const auto size = [&](double low, double high) { return low * std::pow(high / low, uniform(random)); };
    for (int set = 0; set < 40; ++set) {
        const double own = size(1e-9, 3e-3), r_error = size(1e-6, 0.05), energy_error = size(1e-6, 0.3);
        const int surfaces = 1 + set % 4, elastomers = 2 + set % 3;
        std::vector<PairPoint> list;
        for (int i = 0; i < surfaces; ++i) {
            const double r = 1.05 + 0.15 * i, energy = 0.4e-9 * (1 + i),
                         true_r = r * std::exp(r_error * normal(random)),
                         true_energy = energy * std::exp(energy_error * normal(random));
            for (int k = 0; k < elastomers; ++k) {
                const double modulus = 0.9e6 * (1 + k);
                PairPoint p{.surface = "s" + std::to_string(i), .elastomer = "e" + std::to_string(k)};
                p.slope = r;
                p.offset = gamma_1 * (r - 1.0) + modulus * energy;
                const double truth = W * true_r - gamma_1 * (true_r - 1.0) - modulus * true_energy;
                p.measured = {std::max(0.0, truth) + own * normal(random), own};
                p.slope_inputs = one("area of " + p.surface, r_error * r);
                p.offset_inputs = combined(
                    {{gamma_1, p.slope_inputs}, {1.0, one("energy of " + p.surface, energy_error * modulus * energy)}});
                list.push_back(std::move(p));
            }
        }
        const auto found = WorkPosterior(list).work_of_adhesion();
        const double all = own + r_error * W + energy_error * 2.7e6 * 1.6e-9;
        EXPECT_LT(std::abs(found.value - W), 4.0 * found.standard_error) << set << " " << found.value;
        if (list.size() > 4) EXPECT_LT(found.standard_error, 3.0 * all) << set;  // for fewer, scatter dominates
        EXPECT_GT(found.standard_error, 0.02 * std::max(own, std::min(r_error * (W - gamma_1), 1e-3))) << set;
    }
}

TEST(WorkPosterior, RefusesASinglePair) {
    EXPECT_THROW(WorkPosterior({PairPoint{.surface = "s", .elastomer = "e", .slope = 1.0}}), InvalidArgument);
}

}  // namespace
}  // namespace setae::adhesion::work_posterior_test
