// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/patches/survey.hpp"

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::patches {
namespace {

SurveyDesign design(int threads) {
    SurveyDesign survey{.seeds = 3, .threads = {threads}};
    for (const double share : {0.1, 1.0})
        survey.designs.push_back({.points = 32, .points_per_wave = 8.0, .waves_per_side = 2.0, .energy_share = share});
    return survey;
}

TEST(Survey, HasARowPerDesignWithMeansOverItsPatches) {
    auto told = design(2);
    std::size_t calls = 0;
    told.progress = [&](std::size_t done, std::size_t of) {
        EXPECT_EQ(done, ++calls);
        EXPECT_EQ(of, 6U);
    };
    const auto rows = survey(told);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(calls, 6U);
    for (const auto& row : rows) EXPECT_EQ(row.patches, 3);
    EXPECT_NEAR(rows[0].gain_from_far.value, 0.9, 0.01);
    EXPECT_GT(rows[1].gain_from_far.standard_error, 0.0);

    double sum = 0.0;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        auto one = told.designs[1];
        one.seed = seed;
        sum += bring_into_contact(make_patch(one)).from_far.gain;
    }
    EXPECT_NEAR(rows[1].gain_from_far.value, sum / 3.0, 1e-14);
}

TEST(Survey, ClassifiesJumpsBySize) {
    auto told = design(2);
    told.seeds = 2;
    told.protocol.loop = true;
    for (const auto& row : survey(told)) {
        double lost = 0.0;
        for (const auto* classes : {&row.approach_jumps, &row.separation_jumps})
            for (const auto& of : *classes) {
                EXPECT_LT(of.from, of.to);
                EXPECT_GE(of.loss, of.jumps * of.from * (1.0 - 1e-12));
                lost += of.loss;
            }
        EXPECT_GT(lost, 0.5 * row.loss.value);
        EXPECT_LE(lost, row.loss.value + 0.01);
    }
}

TEST(Survey, DoesNotDependOnThreads) {
    const auto one = survey(design(1)), two = survey(design(2));
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].gain_from_far.value, two[i].gain_from_far.value);
        EXPECT_EQ(one[i].area_after_preload.standard_error, two[i].area_after_preload.standard_error);
    }
}

TEST(Survey, RefusesAnEmptyDesign) {
    EXPECT_THROW(survey({}), InvalidArgument);
    auto none = design(1);
    none.seeds = 0;
    EXPECT_THROW(survey(none), InvalidArgument);
}

}  // namespace
}  // namespace setae::patches
