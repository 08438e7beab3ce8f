// SPDX-License-Identifier: GPL-3.0-or-later
// Lenses that are pressed on every surface. Numbers of lme4: tests/reference/statistics.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "setae/core/errors.hpp"
#include "setae/statistics/mixed_model.hpp"

namespace setae::statistics::crossed_levels_test {

struct Crossed {
    int surfaces = 2, lenses = 4, repeats = 2;
    double between_lenses = 5.0, on_a_surface = 1.0, between_repeats = 1.0;  ///< standard deviations
    unsigned seed = 1;
};

/// Surfaces at 40, 45, …
ReplicateData simulated(const Crossed& plan) {
    std::mt19937_64 engine(plan.seed);
    std::normal_distribution<double> normal;
    ReplicateData data{.crossed = {"lens"}};
    std::vector<double> lens_values;
    for (int lens = 0; lens < plan.lenses; ++lens) lens_values.push_back(plan.between_lenses * normal(engine));
    for (int surface = 0; surface < plan.surfaces; ++surface)
        for (int lens = 0; lens < plan.lenses; ++lens) {
            const double together =
                lens_values[static_cast<std::size_t>(lens)] + plan.on_a_surface * normal(engine) + 40.0 + 5.0 * surface;
            for (int repeat = 0; repeat < plan.repeats; ++repeat)
                data.rows.push_back({together + plan.between_repeats * normal(engine),
                                     undefined,
                                     {"S" + std::to_string(surface), "L" + std::to_string(lens), ""}});
        }
    return data;
}

TEST(CrossedLevels, OfABalancedDesignMatchAnalysisOfVariance) {
    // mean squares of a two-way layout: E MS_lens = θ_r + nθ_ls + nsθ_l, E MS_ls = θ_r + nθ_ls, E MS_r = θ_r
    const Crossed plan{.surfaces = 3, .lenses = 6, .repeats = 4};
    const auto data = simulated(plan);
    const auto cell = [&](int surface, int lens) {
        double sum = 0.0;
        for (int r = 0; r < plan.repeats; ++r)
            sum += data.rows[static_cast<std::size_t>((surface * plan.lenses + lens) * plan.repeats + r)].value;
        return sum / plan.repeats;
    };
    double all = 0.0;
    for (int s = 0; s < plan.surfaces; ++s)
        for (int l = 0; l < plan.lenses; ++l) all += cell(s, l) / (plan.surfaces * plan.lenses);
    const auto row_mean = [&](int l) {
        double sum = 0.0;
        for (int s = 0; s < plan.surfaces; ++s) sum += cell(s, l) / plan.surfaces;
        return sum;
    };
    const auto column_mean = [&](int s) {
        double sum = 0.0;
        for (int l = 0; l < plan.lenses; ++l) sum += cell(s, l) / plan.lenses;
        return sum;
    };
    double of_lenses = 0.0, together = 0.0, of_repeats = 0.0;
    for (int l = 0; l < plan.lenses; ++l) {
        of_lenses += plan.repeats * plan.surfaces * std::pow(row_mean(l) - all, 2) / (plan.lenses - 1);
        for (int s = 0; s < plan.surfaces; ++s) {
            together += plan.repeats * std::pow(cell(s, l) - row_mean(l) - column_mean(s) + all, 2) /
                        ((plan.lenses - 1) * (plan.surfaces - 1));
            for (int r = 0; r < plan.repeats; ++r)
                of_repeats +=
                    std::pow(data.rows[static_cast<std::size_t>((s * plan.lenses + l) * plan.repeats + r)].value -
                                 cell(s, l),
                             2) /
                    (plan.surfaces * plan.lenses * (plan.repeats - 1));
        }
    }
    const auto model = mixed_model(data, {.influence = false});
    const auto& components = model.fits.at(0).components;
    ASSERT_EQ(components.size(), 3U);
    EXPECT_EQ(components[0].level, "lens");
    EXPECT_EQ(components[0].degrees_of_freedom, plan.lenses - 1);
    EXPECT_EQ(components[1].level, "lens on a surface");
    EXPECT_EQ(components[1].degrees_of_freedom, (plan.lenses - 1) * (plan.surfaces - 1));
    EXPECT_NEAR(components[0].variance, (of_lenses - together) / (plan.repeats * plan.surfaces), 1e-6);
    EXPECT_NEAR(components[1].variance, (together - of_repeats) / plan.repeats, 1e-6);
    EXPECT_NEAR(components[2].variance, of_repeats, 1e-6);
    // a difference has the interaction's mean square and its degrees of freedom, and no more
    const auto& difference = model.differences.front().difference;
    EXPECT_NEAR(difference.standard_error, std::sqrt(2.0 * together / (plan.lenses * plan.repeats)), 1e-6);
    EXPECT_NEAR(*difference.degrees_of_freedom, (plan.lenses - 1) * (plan.surfaces - 1), 1e-4);
}

TEST(CrossedLevels, DoNotChangeDifferencesOfSurfaces) {
    auto data = simulated({.repeats = 1, .on_a_surface = 0.0, .seed = 3});
    const auto crossed = mixed_model(data, {.influence = false}).differences.at(0).difference;
    data.crossed.clear();
    const auto nested = mixed_model(data, {.influence = false}).differences.at(0).difference;
    EXPECT_NEAR(crossed.value, nested.value, 1e-9);
    EXPECT_LT(crossed.standard_error, 0.4 * nested.standard_error);
    EXPECT_NEAR(crossed.value, 5.0, 3.0 * crossed.standard_error);
}

TEST(CrossedLevels, IntervalsCoverMeansAndDifferences) {
    int means = 0, differences = 0;
    constexpr int seeds = 300;
    for (int seed = 0; seed < seeds; ++seed) {
        const auto model = mixed_model(simulated({.seed = 900U + static_cast<unsigned>(seed)}), {.influence = false});
        const auto& mean = *model.surfaces[0].mean.interval;
        means += mean.lower <= 40.0 && 40.0 <= mean.upper ? 1 : 0;
        const auto& difference = *model.differences[0].difference.interval;
        differences += difference.lower <= 5.0 && 5.0 <= difference.upper ? 1 : 0;
    }
    EXPECT_GE(means, 0.91 * seeds);
    EXPECT_LE(means, 0.985 * seeds);
    EXPECT_GE(differences, 0.91 * seeds);
    EXPECT_LE(differences, 0.99 * seeds);
}

TEST(CrossedLevels, OfOneSurfaceAreNested) {
    auto data = simulated({.surfaces = 1, .lenses = 5, .repeats = 3});
    const auto crossed = mixed_model(data);
    data.crossed.clear();
    const auto nested = mixed_model(data);
    ASSERT_EQ(crossed.fits[0].components.size(), nested.fits[0].components.size());
    for (std::size_t k = 0; k < nested.fits[0].components.size(); ++k)
        EXPECT_NEAR(crossed.fits[0].components[k].variance, nested.fits[0].components[k].variance, 1e-7);
    EXPECT_NEAR(crossed.surfaces[0].mean.standard_error, nested.surfaces[0].mean.standard_error, 1e-8);
    EXPECT_NEAR(*crossed.surfaces[0].mean.degrees_of_freedom, *nested.surfaces[0].mean.degrees_of_freedom, 1e-5);
}

TEST(CrossedLevels, IndistinguishableFromRepeatsAreNestedWithANote) {
    // a chain: every row joins another lens or another surface
    ReplicateData data{.levels = {"surface", "lens"}, .crossed = {"lens"}};
    data.rows = {{40.0, undefined, {"A", "1"}}, {42.0, undefined, {"A", "2"}}, {47.0, undefined, {"B", "2"}}};
    const auto model = mixed_model(data);
    ASSERT_EQ(model.fits[0].components.size(), 1U);
    ASSERT_FALSE(model.fits[0].not_estimable.empty());
    EXPECT_NE(model.fits[0].not_estimable.back().find("too few rows"), std::string::npos);
}

TEST(CrossedLevels, AreSuggestedIfLabelsRecur) {
    auto data = simulated({});
    EXPECT_TRUE(mixed_model(data, {.influence = false}).notes.empty());
    data.crossed.clear();
    const auto notes = mixed_model(data, {.influence = false}).notes;
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("lens L0 is on several surfaces"), std::string::npos) << notes[0];
}

TEST(CrossedLevels, MustBeLevelsBelowTheSurface) {
    auto data = simulated({});
    data.crossed = {"surface"};
    EXPECT_THROW((void)mixed_model(data), InvalidArgument);
    data.crossed = {"batch"};
    EXPECT_THROW((void)mixed_model(data), InvalidArgument);
}

// A mean is linear in its rows at given variances; lenses pressed on both surfaces tell each of them of the other's
// rows.
TEST(CrossedLevels, WeightsOfRowsReproduceTheMean) {
    auto data = simulated({});
    for (auto& row : data.rows) row.standard_error = 0.3 + 0.1 * std::fmod(std::abs(row.value), 3.0);
    data.rows.pop_back();
    data.rows.erase(data.rows.begin() + 3);
    data.exclusions = {{1, "dust"}};
    const auto model = mixed_model(data, {.influence = false});
    for (const auto& surface : model.surfaces) {
        ASSERT_EQ(surface.weights.size(), static_cast<Index>(data.rows.size()));
        double mean = 0.0, own = 0.0, others = 0.0;
        for (std::size_t i = 0; i < data.rows.size(); ++i) {
            const double weight = surface.weights[static_cast<Index>(i)];
            mean += weight * data.rows[i].value;
            (data.rows[i].groups[0] == surface.surface ? own : others) += weight;
        }
        EXPECT_NEAR(mean, surface.mean.value, 1e-10 * surface.mean.value);
        EXPECT_NEAR(own, 1.0, 1e-10);
        EXPECT_NEAR(others, 0.0, 1e-10);
        EXPECT_EQ(surface.weights[1], 0.0);
        EXPECT_GT(surface.weights.abs().sum(), 1.001);
    }
}

}  // namespace setae::statistics::crossed_levels_test
