// SPDX-License-Identifier: GPL-3.0-or-later
// The surveys of docs/validation/estimators.md and docs/validation/ranking.md, shortened.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "estimator_survey.hpp"
#include "published_pairs.hpp"
#include "ranking_survey.hpp"
#include "setae/adhesion/pair_fit.hpp"

namespace setae::reference::ranking_survey_test {
namespace {

using hysteresis::Law;
using hysteresis::RetractionModel;
using hysteresis::Tip;

const PublishedPairs& published() {
    static const PublishedPairs pairs;
    return pairs;
}

const EstimatorSurvey& of(const std::vector<EstimatorSurvey>& surveys, const std::string& estimator) {
    return *std::ranges::find(surveys, estimator, &EstimatorSurvey::estimator);
}

// exact inputs, no scatter, no noise: every W_app is the full-contact balance at the true W_int
TEST(EstimatorSurvey, DataSetsFollowTheTrueWork) {
    EstimatorDesign design{"exact", published().points(), {}, -1};
    for (auto& pair : design.pairs) {
        pair.slope_inputs = pair.offset_inputs = pair.measured_inputs = {};
        pair.measured.standard_error = 1e-9;
    }
    const auto drawn = drawn_pairs(design, 1);
    ASSERT_EQ(drawn.size(), 16U);
    EXPECT_NEAR(adhesion::fit_work_of_adhesion(drawn).work_of_adhesion.value, true_work, 1e-8);
    EXPECT_GE(std::ranges::count_if(drawn, [](const auto& pair) { return pair.measured.value < 1e-8; }), 1);
}

TEST(EstimatorSurvey, PosteriorCoversTrueValuesBetterThanLeastSquares) {
    constexpr double part = 0.005;
    const auto surveys = survey_estimators({"16 pairs", published().points(), {part, part, part}, 3}, 20, 1);
    const auto &posterior = of(surveys, "posterior"), &least_squares = of(surveys, "least squares, pairs independent");
    EXPECT_EQ(posterior.sets, 20);
    EXPECT_GE(posterior.covered_95, 0.8);  // 0.3 % of the time by chance at 95 %
    EXPECT_LT(least_squares.covered_95, posterior.covered_95);
    EXPECT_LT(std::abs(posterior.bias), 4.0 * posterior.deviation / std::sqrt(20.0));
    EXPECT_GT(posterior.width / posterior.stated, 2 * 1.7);
    EXPECT_LT(posterior.width / posterior.stated, 2 * 2.4);
}

hysteresis::ModelScore truth_of(const RetractionModel& model, double scatter) {
    const auto ranking = hysteresis::rank_models({model}, published().ranked(), {}, {1});
    return true_models(ranking, scatter).front();
}

constexpr RetractionModel opening{Law::opening_work, Tip::none}, reversible{Law::reversible, Tip::none};

TEST(RankingSurvey, OpeningWorkExcludesReversible) {
    const auto found = calibrate({opening, reversible}, published().ranked(), truth_of(opening, 0.008), 4, 1);
    EXPECT_EQ(found.sets, 4);
    EXPECT_EQ(found.best + found.not_distinguished + found.beaten_better + found.beaten_clearly + found.refused, 4);
    EXPECT_EQ(found.beaten_clearly, 0);
    EXPECT_EQ(found.reversible_excluded, 4);
    EXPECT_GT(found.odds_lower, std::log(hysteresis::clearly_better_odds));
}

TEST(RankingSurvey, RejectsAConstantBias) {
    const auto biased = calibrate_bias(published().ranked(), truth_of(opening, 0.008), 0.06, 5, 1);
    EXPECT_EQ(biased.sets, 5);
    EXPECT_GE(biased.refused, 4);
}

TEST(RankingSurvey, OneMillijouleOfNoiseKeepsTheClassification) {
    const auto odds = jitter({opening, reversible}, published().ranked(), 0.001, 3, 1);
    ASSERT_EQ(odds.size(), 2U);
    EXPECT_EQ(odds[0].model, "opening_work");
    EXPECT_EQ(odds[0].likeliest, 3);
    EXPECT_EQ(odds[1].clearly_better, 3);
}

}  // namespace
}  // namespace setae::reference::ranking_survey_test
