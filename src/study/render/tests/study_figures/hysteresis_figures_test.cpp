// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/hysteresis_figures.hpp"

#include <gtest/gtest.h>

#include "setae/study/study_result.hpp"

namespace setae::study_figures::hysteresis_figures_test {
namespace {

TEST(HysteresisFigures, ShowPairsAndBars) {
    const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    const auto pairs = study_figure(result, "hysteresis");
    ASSERT_TRUE(pairs.drawable()) << pairs.reason;
    int drawn = 0, hollow = 0;
    for (const auto& series : pairs.figure.panels[0].series) {
        if (series.legend_only || series.mark != figures::Mark::points) continue;
        ++drawn;
        hollow += series.hollow ? 1 : 0;
        EXPECT_LE(series.left[0], series.x[0]);
    }
    EXPECT_EQ(drawn, 16);
    EXPECT_EQ(hollow, 6);
    const auto bars = study_figure(result, "losses");
    ASSERT_TRUE(bars.drawable()) << bars.reason;
    EXPECT_EQ(bars.figure.panels[0].y.tick_labels.size(), 16U);
    EXPECT_EQ(bars.figure.panels[0].y.tick_labels.back(), "PUNCD E0.7");
}

TEST(HysteresisFigures, WithoutMeasurementsGiveTheReason) {
    const study::Hysteresis none;
    EXPECT_EQ(hysteresis_figure(none, FigureWidth::single_column).reason, "no pair has a measured W_ret at pull-off");
    EXPECT_FALSE(loss_shares_figure(none, FigureWidth::single_column).drawable());
}

TEST(HysteresisFigures, OfAStudyWithoutHysteresisGiveTheReason) {
    study::StudyResult result;
    result.hysteresis = study::Outcome<study::Hysteresis>::missing("too many pairs");
    EXPECT_EQ(study_figure(result, "hysteresis").reason, "too many pairs");
}

}  // namespace
}  // namespace setae::study_figures::hysteresis_figures_test
