// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/summary.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/validation/report.hpp"

namespace setae::validation::summary_test {
namespace {

Comparison comparison(int run, double found, double standard_error, const char* method = "average") {
    return {run,          "A",
            "rms_height", method,
            "m",          Deviation::relative,
            2e-9,         {.value = found, .standard_error = standard_error}};
}

TEST(Comparison, MeasuresDeviationAndCoverageOfTheTrueValue) {
    const auto relative = comparison(0, 2.2e-9, 0.1e-9);
    EXPECT_NEAR(relative.deviation(), 0.1, 1e-12);
    EXPECT_NEAR(relative.stated_deviation(), 0.05, 1e-12);
    EXPECT_FALSE(relative.covered());  // 1.96 standard errors below 2.2 are 2.004
    EXPECT_TRUE(comparison(0, 2.19e-9, 0.1e-9).covered());
    auto absolute = relative;
    absolute.measure = Deviation::absolute;
    EXPECT_NEAR(absolute.deviation(), 0.2e-9, 1e-21);
    absolute.found.interval = Interval{1.9e-9, 2.0e-9};
    EXPECT_TRUE(absolute.covered());
    EXPECT_FALSE(comparison(0, 2e-9, std::nan("")).covered());
}

// Newcombe, Stat. Med. 17 (1998) 857, table I: 81 of 263 and 0 of 20 by the score method.
TEST(ShareInterval, IsWilsonsScoreInterval) {
    EXPECT_NEAR(share_interval(81, 263).lower, 0.2553, 5e-5);
    EXPECT_NEAR(share_interval(81, 263).upper, 0.3662, 5e-5);
    EXPECT_EQ(share_interval(0, 20).lower, 0.0);
    EXPECT_NEAR(share_interval(0, 20).upper, 0.1611, 5e-5);
    EXPECT_THROW((void)share_interval(3, 2), InvalidArgument);
    EXPECT_THROW((void)share_interval(0, 0), InvalidArgument);
}

TEST(Summary, GivesBiasScatterWorstAndCoveragePerQuantityAndMethod) {
    const auto rows = summary({comparison(0, 2.0e-9, 1e-10), comparison(1, 2.4e-9, 1e-10),
                               comparison(0, 1.0e-9, 1e-10, "paper"), comparison(2, 2.2e-9, 2e-10)});
    ASSERT_EQ(rows.size(), 2u);
    const auto& row = rows[0];
    EXPECT_EQ(row.method, "average");
    EXPECT_EQ(row.count, 3);
    EXPECT_NEAR(row.bias, 0.1, 1e-12);
    EXPECT_NEAR(row.scatter, 0.1, 1e-12);
    EXPECT_NEAR(row.bias_error, 0.1 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(row.worst, 0.2, 1e-12);
    EXPECT_NEAR(row.stated, (0.05 + 0.05 + 0.1) / 3.0, 1e-12);
    EXPECT_NEAR(row.coverage, 2.0 / 3.0, 1e-12);
    EXPECT_EQ(rows[1].method, "paper");
    EXPECT_TRUE(std::isnan(rows[1].bias_error));
}

// Four members of one run that err alike are worth one: the error of the mean is that of two runs.
TEST(Summary, CountsCorrelatedMembersOfOneRunOnce) {
    std::vector<Comparison> rows;
    for (int i = 0; i < 4; ++i) rows.push_back(comparison(0, 2.2e-9, 1e-10));
    for (int i = 0; i < 4; ++i) rows.push_back(comparison(1, 1.8e-9, 1e-10));
    EXPECT_NEAR(summary(rows)[0].bias_error, 0.1 * std::sqrt(2.0) / std::sqrt(2.0), 1e-12);
}

// A run whose members all hit beside one whose members all miss: as little is known of the share as of one coin.
TEST(Summary, CoverageIntervalAccountsForCorrelationWithinRuns) {
    std::vector<Comparison> alike, mixed;
    for (int i = 0; i < 4; ++i) {
        alike.push_back(comparison(0, 2.0e-9, 1e-10));
        alike.push_back(comparison(1, 3.0e-9, 1e-10));
        for (int run = 0; run < 2; ++run) mixed.push_back(comparison(run, i < 2 ? 2.0e-9 : 3.0e-9, 1e-10));
    }
    const auto of_runs = summary(alike)[0].coverage_interval, of_members = summary(mixed)[0].coverage_interval;
    EXPECT_NEAR(of_runs.lower, share_interval(0.5, 1.0).lower, 1e-12);
    EXPECT_NEAR(of_members.lower, share_interval(4, 8).lower, 1e-12);
    EXPECT_NEAR(of_members.upper, share_interval(4, 8).upper, 1e-12);
}

TEST(SummaryTable, PrintsPerCentAndMillijoules) {
    auto work = comparison(0, 0.0371, 1e-4);
    work.quantity = "work_of_adhesion";
    work.unit = "J/m2";
    work.true_value = 0.037;
    work.measure = Deviation::absolute;
    const auto text = summary_table(summary({comparison(0, 2.2e-9, 1e-10), work}));
    EXPECT_NE(text.find("+10.000"), std::string::npos) << text;
    EXPECT_NE(text.find("mJ/m2    +0.100"), std::string::npos) << text;
}

TEST(ComparisonsCsv, LeavesUndefinedValuesEmpty) {
    EXPECT_EQ(comparisons_csv({comparison(3, 2.2e-9, std::nan(""))}),
              "run,item,quantity,unit,method,planted,found,standard_error,interval_lower,interval_upper,covered\n"
              "3,A,rms_height,m,average,2e-09,2.2e-09,,,,0\n");
}

TEST(ValidationFigure, HasOneLinePerQuantityAndOneSeriesPerMethod) {
    const auto figure = validation_figure(
        summary({comparison(0, 2.0e-9, 1e-10), comparison(1, 2.4e-9, 1e-10), comparison(0, 1.0e-9, 1e-10, "paper")}));
    ASSERT_EQ(figure.panels.size(), 2u);
    EXPECT_EQ(figure.panels[0].y.tick_labels, std::vector<std::string>{"rms height"});
    ASSERT_EQ(figure.panels[0].series.size(), 2u);
    EXPECT_NEAR(figure.panels[0].series[0].x[0], 10.0, 1e-9);
    EXPECT_GT(figure.panels[0].series[0].y[0], figure.panels[0].series[1].y[0]);
}

}  // namespace
}  // namespace setae::validation::summary_test
