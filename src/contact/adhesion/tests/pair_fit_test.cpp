// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/pair_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setae/core/errors.hpp"

namespace setae::adhesion::pair_fit_test {
namespace {

/// Four surfaces and four elastomers with known balance lines.
std::vector<PairPoint> pairs(double work, double error = 0.0) {
    std::vector<PairPoint> result;
    for (int s = 0; s < 4; ++s)
        for (int e = 0; e < 4; ++e) {
            PairPoint p;
            p.surface = "s" + std::to_string(s);
            p.elastomer = "e" + std::to_string(e);
            p.slope = 1.0 + 0.2 * s;
            p.offset = 0.025 * 0.2 * s + 0.001 * s * (1 << e);
            p.measured.standard_error = error;
            p.measured.value = p.prediction(work);
            result.push_back(p);
        }
    return result;
}

TEST(WorkFit, RecoversAnExactWorkWithFlooredPairs) {
    const auto points = pairs(0.02);
    ASSERT_EQ(points[15].measured.value, 0.0) << "the case must hold a floored pair";
    const auto fit = fit_work_of_adhesion(points);
    EXPECT_NEAR(fit.work_of_adhesion.value, 0.02, 1e-15);
    EXPECT_NEAR(fit.r_squared, 1.0, 1e-12);
    EXPECT_EQ(fit.degrees_of_freedom, 15);
}

TEST(WorkFit, FindsTheGlobalMinimumOfABruteForceSearch) {
    auto points = pairs(0.03);
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 0.01);
    for (auto& p : points) p.measured.value = std::max(0.0, p.measured.value + noise(random));
    const auto cost = [&](double work) {
        double sum = 0.0;
        for (const auto& p : points) sum += std::pow(p.measured.value - p.prediction(work), 2);
        return sum;
    };
    double best = 0.0;
    for (int i = 0; i <= 100000; ++i)
        if (cost(1e-6 * i) < cost(best)) best = 1e-6 * i;
    EXPECT_NEAR(fit_work_of_adhesion(points).work_of_adhesion.value, best, 1e-6);
}

TEST(WorkFit, IntervalsHaveTheStatedCoverage) {
    // 95 % of intervals W ± 2.13 SE (t, 15 degrees of freedom) cover the true value: 400 draws, 3σ = 3.3 %
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0.0, 0.003);
    int plain = 0, weighted = 0, refused = 0;
    const int draws = 400;
    for (int i = 0; i < draws; ++i) {
        auto points = pairs(0.08, 0.003);
        for (auto& p : points) p.measured.value += noise(random);
        const auto fit = fit_work_of_adhesion(points);
        plain += std::abs(fit.work_of_adhesion.value - 0.08) < 2.131 * fit.work_of_adhesion.standard_error ? 1 : 0;
        refused += fit.weighted->work_of_adhesion.uncertain() ? 0 : 1;
        weighted += std::abs(fit.weighted->work_of_adhesion.value - 0.08) <
                            1.960 * fit.weighted->work_of_adhesion.standard_error
                        ? 1
                        : 0;
    }
    EXPECT_NEAR(plain / double(draws), 0.95, 0.033);
    // χ² refuses one in twenty, which then state no error; of the others
    EXPECT_NEAR(refused / double(draws), 0.05, 0.033);
    EXPECT_NEAR(weighted / double(draws - refused), 0.95, 0.033);
}

TEST(WorkFit, ExtraScatterBringsChiSquaredToTheDegreesOfFreedom) {
    auto points = pairs(0.08, 0.001);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].measured.value += (i % 2 == 0 ? 0.005 : -0.005);
    const auto fit = fit_work_of_adhesion(points);
    EXPECT_GT(fit.weighted->chi_squared, 100.0);
    EXPECT_NEAR(fit.with_extra_scatter->chi_squared, 15.0, 1e-6);
    EXPECT_NEAR(fit.with_extra_scatter->extra_scatter, 0.005, 3e-4);
    EXPECT_LT(fit.likelihood->interval->lower, fit.work_of_adhesion.value);
    EXPECT_GT(fit.likelihood->interval->upper, fit.work_of_adhesion.value);
}

TEST(WorkFit, ClusteredErrorsGrowWhenSurfacesShareTheirDeviation) {
    auto shared = pairs(0.08, 0.001), alternating = shared;
    for (std::size_t i = 0; i < shared.size(); ++i) {
        shared[i].measured.value += (i / 4 % 2 == 0 ? 0.005 : -0.005);
        alternating[i].measured.value += (i % 2 == (i / 4) % 2 ? 0.005 : -0.005);
    }
    const auto a = fit_work_of_adhesion(shared), b = fit_work_of_adhesion(alternating);
    EXPECT_GT(a.clustered.standard_error, 1.5 * a.work_of_adhesion.standard_error);
    EXPECT_LT(b.clustered.standard_error, a.clustered.standard_error);
}

/// Slopes 1, no offsets: W is the mean.
std::vector<PairPoint> table(const std::vector<std::vector<double>>& measured) {
    std::vector<PairPoint> points;
    for (std::size_t s = 0; s < measured.size(); ++s)
        for (std::size_t e = 0; e < measured[s].size(); ++e) {
            PairPoint p;
            p.surface = "s" + std::to_string(s);
            p.elastomer = "e" + std::to_string(e);
            p.slope = 1.0;
            p.measured.value = measured[s][e];
            points.push_back(p);
        }
    return points;
}

// Residuals {4 2 0; 2 0 −2; 0 −2 −4} mJ/m². Sums over surfaces 6, 0, −6: 72 · 3/2; over elastomers the same; over pairs
// 48 · 9/8. (108 + 108 − 54)/9² = 2 (mJ/m²)²
TEST(WorkFit, ClusteredErrorsAddGroupingsMinusTheirIntersection) {
    const auto fit = fit_work_of_adhesion(table({{84e-3, 82e-3, 80e-3}, {82e-3, 80e-3, 78e-3}, {80e-3, 78e-3, 76e-3}}));
    EXPECT_NEAR(fit.work_of_adhesion.value, 80e-3, 1e-15);
    EXPECT_NEAR(fit.clustered.standard_error, std::sqrt(2.0) * 1e-3, 1e-12);
    EXPECT_EQ(*fit.clustered.degrees_of_freedom, 2.0);
    // {3 1 2; −1 −3 −2}: 144 by surfaces is more than 144 + 12 − 33.6
    const auto one_way = fit_work_of_adhesion(table({{83e-3, 81e-3, 82e-3}, {79e-3, 77e-3, 78e-3}}));
    EXPECT_NEAR(one_way.clustered.standard_error, std::sqrt(144.0) / 6.0 * 1e-3, 1e-12);
}

// Four surfaces and five elastomers that each shift all their pairs by 3 mJ/m²: independent errors cover the true value
// in about half of all cases.
TEST(WorkFit, ClusteredIntervalsCoverTheTrueWorkWithGroupShifts) {
    constexpr int draws = 400;
    constexpr double shift = 3e-3, noise = 1e-3;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    int clustered = 0, independent = 0;
    for (int d = 0; d < draws; ++d) {
        std::vector<double> elastomers(5);
        for (auto& e : elastomers) e = shift * normal(random);
        std::vector<std::vector<double>> measured(4);
        for (auto& row : measured) {
            const double surface = shift * normal(random);
            for (const double e : elastomers) row.push_back(80e-3 + surface + e + noise * normal(random));
        }
        const auto fit = fit_work_of_adhesion(table(measured));
        const double off = std::abs(fit.work_of_adhesion.value - 80e-3);
        clustered += off < 3.182 * fit.clustered.standard_error ? 1 : 0;  // t, 3 degrees of freedom
        independent += off < 2.093 * fit.work_of_adhesion.standard_error ? 1 : 0;
    }
    EXPECT_NEAR(clustered / double(draws), 0.95, 0.04);
    EXPECT_LT(independent / double(draws), 0.75);
}

TEST(WorkFit, RefusesASinglePair) { EXPECT_THROW((void)fit_work_of_adhesion({pairs(0.03).front()}), InvalidArgument); }

TEST(LineFit, HasTheTextbookStandardErrors) {
    // Anscombe's first set, Am. Stat. 27 (1973) 17: slope 0.5001 ± 0.1179, intercept 3.0001 ± 1.1247, R² 0.6665
    const auto fit = fit_line({10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5},
                              {8.04, 6.95, 7.58, 8.81, 8.33, 9.96, 7.24, 4.26, 10.84, 4.82, 5.68});
    EXPECT_NEAR(fit.slope.value, 0.5001, 5e-5);
    EXPECT_NEAR(fit.slope.standard_error, 0.1179, 5e-5);
    EXPECT_NEAR(fit.intercept.value, 3.0001, 5e-5);
    EXPECT_NEAR(fit.intercept.standard_error, 1.1247, 5e-5);
    EXPECT_NEAR(fit.r_squared, 0.6665, 5e-5);
    EXPECT_THROW((void)fit_line({1, 1, 1}, {1, 2, 3}), InvalidArgument);
}

}  // namespace
}  // namespace setae::adhesion::pair_fit_test
