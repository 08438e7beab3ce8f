// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/statistics/mixed_model.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "simulated_replicates.hpp"

namespace mixed_model_test {

using namespace setae;
using namespace setae::statistics;

/// Mean squares of a balanced nested table in the order of its rows.
struct NestedMeanSquares {
    double lens = 0.0, spot = 0.0, repeat = 0.0;
};

NestedMeanSquares mean_squares(const ReplicateData& data, int lenses, int spots, int repeats) {
    NestedMeanSquares result;
    double all = 0.0;
    for (const auto& row : data.rows) all += row.value / static_cast<double>(data.rows.size());
    std::size_t i = 0;
    for (int l = 0; l < lenses; ++l) {
        std::vector<double> spot_means;
        double lens_mean = 0.0;
        for (int s = 0; s < spots; ++s) {
            double mean = 0.0;
            for (int r = 0; r < repeats; ++r) mean += data.rows[i + static_cast<std::size_t>(r)].value / repeats;
            for (int r = 0; r < repeats; ++r)
                result.repeat += std::pow(data.rows[i++].value - mean, 2) / (lenses * spots * (repeats - 1));
            spot_means.push_back(mean);
            lens_mean += mean / spots;
        }
        for (const double mean : spot_means)
            result.spot += repeats * std::pow(mean - lens_mean, 2) / (lenses * (spots - 1));
        result.lens += spots * repeats * std::pow(lens_mean - all, 2) / (lenses - 1);
    }
    return result;
}

TEST(MixedModel, OfABalancedDesignMatchesAnalysisOfVariance) {
    const auto data = simulated({.surfaces = 1, .lenses = 5, .spots = 4, .repeats = 3, .seed = 4});
    const auto ms = mean_squares(data, 5, 4, 3);
    const auto model = mixed_model(data);
    const auto& components = model.fits[0].components;
    ASSERT_EQ(components.size(), 3U);
    ASSERT_GT(ms.lens, ms.spot);
    ASSERT_GT(ms.spot, ms.repeat);
    // a maximum is known to the root of rounding at best
    EXPECT_NEAR(components[2].variance / ms.repeat, 1.0, 1e-7);
    EXPECT_NEAR(components[1].variance / ((ms.spot - ms.repeat) / 3.0), 1.0, 1e-7);
    EXPECT_NEAR(components[0].variance / ((ms.lens - ms.spot) / 12.0), 1.0, 1e-7);
    EXPECT_EQ(components[0].degrees_of_freedom, 4);
    EXPECT_EQ(components[1].degrees_of_freedom, 15);
    EXPECT_EQ(components[2].degrees_of_freedom, 40);
    // var of a mean square is 2 MS²/df
    EXPECT_NEAR(components[2].standard_error / (ms.repeat * std::sqrt(2.0 / 40.0)), 1.0, 1e-6);
    EXPECT_NEAR(components[0].standard_error /
                    (std::sqrt(2.0 * ms.lens * ms.lens / 4.0 + 2.0 * ms.spot * ms.spot / 15.0) / 12.0),
                1.0, 1e-6);
    EXPECT_NEAR(model.surfaces[0].mean.standard_error / std::sqrt(ms.lens / 60.0), 1.0, 1e-7);
    EXPECT_NEAR(*model.surfaces[0].mean.degrees_of_freedom, 4.0, 1e-5);
}

TEST(MixedModel, KnownVarianceIsSubtractedFromThatOfRepeats) {
    auto data = simulated({.surfaces = 1, .lenses = 4, .spots = 3, .repeats = 2, .seed = 5});
    const auto without = mixed_model(data);
    const double known = 0.5 * std::sqrt(without.fits[0].components[2].variance);
    for (auto& row : data.rows) row.standard_error = known;
    const auto with = mixed_model(data);
    EXPECT_NEAR(with.fits[0].components[2].variance + known * known, without.fits[0].components[2].variance, 1e-6);
    EXPECT_NEAR(with.fits[0].components[0].variance, without.fits[0].components[0].variance, 1e-6);
    EXPECT_NEAR(with.surfaces[0].mean.standard_error, without.surfaces[0].mean.standard_error, 1e-7);
    EXPECT_NEAR(with.fits[0].known_variance, known * known, 1e-12);
    EXPECT_TRUE(std::isnan(without.fits[0].known_variance));
}

TEST(MixedModel, DoesNotDependOnUnitsOrTheOrderOfRows) {
    const auto data = simulated({.surfaces = 2, .lenses = 3, .spots = 3, .repeats = 2, .fit_error = 1.0, .seed = 7});
    auto other = data;
    for (auto& row : other.rows) {
        row.value *= 1e-9;
        row.standard_error *= 1e-9;
    }
    std::shuffle(other.rows.begin(), other.rows.end(), std::mt19937_64(1));
    const auto a = mixed_model(data), b = mixed_model(other);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(b.fits[0].components[k].variance * 1e18, a.fits[0].components[k].variance,
                    1e-5 * (1e-3 + a.fits[0].components[k].variance));
    const auto& surface = a.surfaces[0];
    const auto& same = b.surfaces[b.surfaces[0].surface == surface.surface ? 0 : 1];
    EXPECT_NEAR(same.mean.value * 1e9, surface.mean.value, 1e-6);
    EXPECT_NEAR(same.mean.standard_error * 1e9, surface.mean.standard_error, 1e-6);
}

TEST(MixedModel, TrueNestedVariancesAreRecoveredWithinTenPercent) {
    // means over seeds; an estimate over 6 lenses and 3 surfaces scatters by about √(2/15) = 37 % and more, 150 seeds
    // leave 3 %
    double lens = 0.0, spot = 0.0, repeat = 0.0;
    constexpr int seeds = 150;
    for (int seed = 0; seed < seeds; ++seed) {
        const auto model = mixed_model(simulated({.surfaces = 3,
                                                  .lenses = 6,
                                                  .spots = 4,
                                                  .repeats = 2,
                                                  .fit_error = 1.0,
                                                  .seed = 100U + static_cast<unsigned>(seed)}),
                                       {.influence = false});
        lens += model.fits[0].components[0].variance / seeds;
        spot += model.fits[0].components[1].variance / seeds;
        repeat += model.fits[0].components[2].variance / seeds;
    }
    EXPECT_NEAR(lens / 9.0, 1.0, 0.10);
    EXPECT_NEAR(spot / 4.0, 1.0, 0.10);
    EXPECT_NEAR(repeat / 2.25, 1.0, 0.10);
}

/// Coverage of the 95 % interval of the mean over 200 seeds.
double coverage(SimulatedReplicates plan) {
    int hits = 0;
    constexpr int seeds = 200;
    for (int seed = 0; seed < seeds; ++seed) {
        plan.seed = 5000U + static_cast<unsigned>(seed);
        const auto model = mixed_model(simulated(plan), {.influence = false});
        const auto interval = *model.surfaces[0].mean.interval;
        hits += interval.lower <= plan.mean && plan.mean <= interval.upper ? 1 : 0;
    }
    return static_cast<double>(hits) / seeds;
}

// 90 … 98 %: what is promised of intervals; 200 seeds of a true 95 % scatter by 1.5 %
TEST(MixedModel, IntervalsOfThreeLensesCoverTheTrueMean) {
    const double share = coverage({.surfaces = 1, .lenses = 3, .spots = 4, .repeats = 2, .fit_error = 1.0});
    EXPECT_GE(share, 0.90);
    EXPECT_LE(share, 0.98);
}

TEST(MixedModel, IntervalsOfTwoLensesCoverTheTrueMean) {
    const double share = coverage({.surfaces = 1, .lenses = 2, .spots = 3, .repeats = 1, .fit_error = 1.0});
    EXPECT_GE(share, 0.90);
    EXPECT_LE(share, 0.98);
}

TEST(MixedModel, IntervalsOfUnbalancedPooledSurfacesCoverTheTrueMean) {
    const double share =
        coverage({.surfaces = 3, .lenses = 3, .spots = 4, .repeats = 2, .fit_error = 1.0, .dropped = 0.3});
    EXPECT_GE(share, 0.90);
    EXPECT_LE(share, 0.98);
}

TEST(MixedModel, OfOneMeasurementUsesItsErrorAndReportsMissingReplicates) {
    const ReplicateData data{.rows = {{40.0, 3.0, {"A", "1", "1"}}}};
    const auto model = mixed_model(data);
    EXPECT_EQ(model.surfaces[0].mean.value, 40.0);
    EXPECT_EQ(model.surfaces[0].mean.standard_error, 3.0);
    EXPECT_NEAR(model.surfaces[0].mean.interval->upper, 40.0 + 3.0 * normal_quantile(0.975), 1e-12);
    ASSERT_EQ(model.surfaces[0].notes.size(), 1U);
    EXPECT_NE(model.surfaces[0].notes[0].find("replicates are missing"), std::string::npos);
    EXPECT_TRUE(model.fits[0].components.empty());
    EXPECT_FALSE(model.surfaces[0].prediction);
    EXPECT_TRUE(model.surfaces[0].influence.empty());
}

TEST(MixedModel, OfOneMeasurementUsesVariancesOfOtherSurfaces) {
    auto data = simulated({.surfaces = 1, .lenses = 4, .spots = 3, .repeats = 2, .seed = 9});
    data.rows.push_back({70.0, undefined, {"alone", "x", "x"}});
    const auto model = mixed_model(data);
    double sum = 0.0;
    for (const auto& component : model.fits[0].components) sum += component.variance;
    EXPECT_EQ(model.surfaces[1].mean.value, 70.0);
    EXPECT_NEAR(model.surfaces[1].mean.standard_error / std::sqrt(sum), 1.0, 1e-9);
    EXPECT_NE(model.surfaces[1].notes.at(0).find("those of the other surfaces"), std::string::npos);

    const auto own = mixed_model(data, {.pooling = Pooling::none});
    EXPECT_EQ(own.fits.size(), 2U);
    EXPECT_TRUE(std::isnan(own.surfaces[1].mean.standard_error));
    EXPECT_NE(own.surfaces[1].notes.at(0).find("nothing is known"), std::string::npos);
    EXPECT_TRUE(std::isnan(own.differences.at(0).difference.standard_error));
}

TEST(MixedModel, OfOneLensReportsThatScatterBetweenLensesIsMissing) {
    const auto data = simulated({.surfaces = 1, .lenses = 1, .spots = 5, .repeats = 2, .seed = 11});
    const auto model = mixed_model(data);
    ASSERT_EQ(model.fits[0].components.size(), 2U);
    EXPECT_EQ(model.fits[0].components[0].level, "spot");
    ASSERT_EQ(model.fits[0].not_estimable.size(), 1U);
    EXPECT_NE(model.fits[0].not_estimable[0].find("one lens per surface"), std::string::npos);
    EXPECT_EQ(model.surfaces[0].influence.at(0).level, "spot");
}

TEST(MixedModel, LevelsWithEqualGroupsAreMerged) {
    const auto data = simulated({.surfaces = 1, .lenses = 4, .spots = 3, .repeats = 1, .seed = 13});
    const auto model = mixed_model(data);
    ASSERT_EQ(model.fits[0].components.size(), 2U);
    EXPECT_EQ(model.fits[0].components[1].includes, (std::vector<std::string>{"spot", "repeat"}));
}

TEST(MixedModel, LevelsWithoutLabelsAreReported) {
    auto data = simulated({.surfaces = 1, .lenses = 4, .spots = 3, .repeats = 2, .seed = 13});
    for (auto& row : data.rows) row.groups[2].clear();
    const auto model = mixed_model(data);
    ASSERT_EQ(model.fits[0].components.size(), 2U);
    EXPECT_EQ(model.fits[0].not_estimable.at(0), "no row names a spot");
    EXPECT_EQ(model.surfaces[0].groups, (std::vector<int>{4, 0}));
}

TEST(MixedModel, ExcludesRowsAndReportsTheMeanWithThem) {
    auto data = simulated({.surfaces = 1, .lenses = 4, .spots = 3, .repeats = 2, .seed = 15});
    const auto all = mixed_model(data);
    data.rows.push_back({90.0, 1.0, {"S0", "L0", "P0"}, "slipped.csv"});
    const auto with = mixed_model(data);
    data.exclusions = {{data.rows.size() - 1, "lens slipped"}};
    const auto model = mixed_model(data);
    EXPECT_NEAR(model.surfaces[0].mean.value, all.surfaces[0].mean.value, 1e-12);
    ASSERT_TRUE(model.surfaces[0].with_excluded);
    EXPECT_NEAR(model.surfaces[0].with_excluded->value, with.surfaces[0].mean.value, 1e-12);
    EXPECT_EQ(model.surfaces[0].excluded, 1);
    EXPECT_EQ(model.surfaces[0].n, 24);
}

TEST(MixedModel, OfASurfaceWithoutRemainingRowsReportsIt) {
    auto data = simulated({.surfaces = 2, .lenses = 2, .spots = 2, .repeats = 1, .seed = 15});
    for (std::size_t i = 0; i < data.rows.size(); ++i)
        if (data.rows[i].groups[0] == "S1") data.exclusions.push_back({i, "dust"});
    const auto model = mixed_model(data);
    ASSERT_EQ(model.surfaces.size(), 1U);
    EXPECT_EQ(model.notes.at(0), "S1: every measurement is excluded");
    for (std::size_t i = 0; i < data.rows.size(); ++i)
        if (data.rows[i].groups[0] == "S0") data.exclusions.push_back({i, "dust"});
    EXPECT_THROW((void)mixed_model(data), UndefinedDataError);
}

TEST(MixedModel, ReportsTheInfluenceOfEachLens) {
    auto data = simulated({.surfaces = 2, .lenses = 3, .spots = 4, .repeats = 2, .seed = 17});
    for (auto& row : data.rows)
        if (row.groups[0] == "S0" && row.groups[1] == "L2") row.value += 30.0;
    const auto model = mixed_model(data);
    const auto& influence = model.surfaces[0].influence;
    ASSERT_EQ(influence.size(), 3U);
    EXPECT_EQ(influence[2].group, "L2");
    // a third of the weight lies on it; the other lenses' own values scatter the shift by 1.4
    EXPECT_NEAR(influence[2].shift, -10.0, 5.0);
    EXPECT_GT(influence[0].shift, 0.0);
    auto without = data;
    std::erase_if(without.rows, [](const Replicate& row) { return row.groups[0] == "S0" && row.groups[1] == "L2"; });
    EXPECT_NEAR(influence[2].mean->value, mixed_model(without).surfaces[0].mean.value, 1e-12);
}

TEST(MixedModel, DifferencesOfSurfacesIncludeBothErrors) {
    const auto model = mixed_model(simulated({.surfaces = 2, .lenses = 4, .spots = 4, .repeats = 2, .seed = 19}));
    ASSERT_EQ(model.differences.size(), 1U);
    const auto& d = model.differences[0];
    EXPECT_EQ(d.later, "S1");
    EXPECT_NEAR(d.difference.value, model.surfaces[1].mean.value - model.surfaces[0].mean.value, 1e-12);
    EXPECT_NEAR(d.difference.standard_error,
                std::hypot(model.surfaces[0].mean.standard_error, model.surfaces[1].mean.standard_error), 1e-12);
    EXPECT_NEAR(*d.difference.degrees_of_freedom, 6.0, 1e-5);  // eight lenses on two surfaces
    const double t = std::abs(d.difference.value) / d.difference.standard_error;
    EXPECT_NEAR(student_t_quantile(1.0 - 0.5 * d.probability, 6.0), t, 1e-4);
}

TEST(MixedModel, HeterogeneityIsScatterBeyondStandardErrors) {
    ReplicateData data{.levels = {"surface"}, .rows = {{1.0, 1.0, {"A"}}, {3.0, 1.0, {"A"}}, {5.0, 1.0, {"A"}}}};
    auto found = *mixed_model(data).surfaces[0].heterogeneity;
    EXPECT_NEAR(found.Q, 8.0, 1e-12);
    EXPECT_EQ(found.degrees_of_freedom, 2);
    EXPECT_NEAR(found.I2, 0.75, 1e-12);
    EXPECT_NEAR(found.probability, std::exp(-4.0), 1e-12);
    for (auto& row : data.rows) row.standard_error = 10.0;
    EXPECT_EQ(mixed_model(data).surfaces[0].heterogeneity->I2, 0.0);
    data.rows[1].standard_error = undefined;
    EXPECT_FALSE(mixed_model(data).surfaces[0].heterogeneity);
}

TEST(MixedModel, EqualValuesWithoutErrorsHaveAnUnknownError) {
    const ReplicateData data{.levels = {"surface"}, .rows = {{2.0, undefined, {"A"}}, {2.0, undefined, {"A"}}}};
    const auto model = mixed_model(data);
    EXPECT_EQ(model.surfaces[0].mean.value, 2.0);
    EXPECT_TRUE(std::isnan(model.surfaces[0].mean.standard_error));
    EXPECT_NE(model.surfaces[0].notes.at(0).find("unknown"), std::string::npos);
}

TEST(MixedModel, PredictionIntervalIncludesScatterOfANewLens) {
    const auto model = mixed_model(simulated({.surfaces = 1, .lenses = 5, .spots = 4, .repeats = 3, .seed = 3}));
    const auto& surface = model.surfaces[0];
    double sum = surface.mean.variance();
    for (const auto& component : model.fits[0].components) sum += component.variance;
    const double reach = surface.prediction->upper - surface.mean.value;
    // t of more than 4 degrees of freedom, that of the mean, and fewer than infinitely many
    EXPECT_GT(reach, normal_quantile(0.975) * std::sqrt(sum));
    EXPECT_LT(reach, student_t_quantile(0.975, 4.0) * std::sqrt(sum));
}

TEST(MixedModel, RefusesInvalidData) {
    const auto expect_message = [](const ReplicateData& data, const std::string& part) {
        try {
            (void)mixed_model(data);
            ADD_FAILURE() << "accepted: " << part;
        } catch (const InvalidArgument& error) {
            EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
        }
    };
    const ReplicateData good{.levels = {"surface", "lens"}, .rows = {{1.0, 1.0, {"A", "1"}}, {2.0, 1.0, {"A", "2"}}}};
    expect_message({}, "no replicates");
    auto data = good;
    data.rows[1].value = undefined;
    expect_message(data, "row 1: value nan");
    data = good;
    data.rows[0].standard_error = -1.0;
    expect_message(data, "standard error -1");
    data = good;
    data.rows[0].groups.pop_back();
    expect_message(data, "1 labels; expected 2");
    data = good;
    data.rows[0].groups[1].clear();
    data.rows[0].name = "loop.csv";
    expect_message(data, "row 0 (loop.csv): no lens");
    data = good;
    data.exclusions = {{0, ""}};
    expect_message(data, "without a reason");
    data.exclusions = {{7, "dust"}};
    expect_message(data, "there are 2");
    data.exclusions = {{0, "dust"}, {0, "dust"}};
    expect_message(data, "twice");
}

}  // namespace mixed_model_test
