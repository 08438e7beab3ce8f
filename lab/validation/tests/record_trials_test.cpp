// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/record_trials.hpp"

#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"

namespace setae::validation::record_trials_test {
namespace {

/// What a record may lack: everything else is analysed, with honest intervals.
bool is_refused(const std::string& kind) {
    static const std::set<std::string> refused{"no_baseline",   "force_reversed", "displacement_reversed",
                                               "both_reversed", "swapped",        "no_contact"};
    return refused.contains(kind);
}

TEST(RecordTrials, AreAnalysedWithoutSilentErrorsOrRefusedWithTheCause) {
    constexpr int runs = 6;
    for (const RecordSummary& row : summary(record_trials({.runs = runs, .first_seed = 11}))) {
        EXPECT_EQ(row.count, runs);
        // a deflection that is not given cannot be seen in the record: E* is that of both in series
        EXPECT_EQ(row.silent, row.kinds == "stage_stiffness_not_given" ? runs : 0) << row.kinds;
        EXPECT_EQ(row.refused, is_refused(row.kinds) ? runs : 0) << row.kinds;
        if (is_refused(row.kinds)) {
            EXPECT_EQ(row.named, runs) << row.kinds;
        }
    }
}

TEST(RecordTrials, CoverTrueValuesByEachRoute) {
    // 40 records at 95 %: fewer than 33 hits has a probability of 1e-3; 6 kinds of 6 routes
    for (const RecordSummary& row : summary(record_trials(
             {.kinds = {"clean", "drift_100", "force_noise_3", "force_correlated_0.8", "rounding_2", "hold"},
            .runs = 40})))
        for (const RouteSummary& route : row.routes) {
            EXPECT_GE(route.count, 39) << row.kinds << ' ' << route.name;
            EXPECT_GE(route.coverage, 0.80) << row.kinds << ' ' << route.name;
            EXPECT_TRUE(std::abs(route.bias_in_errors) < 0.6 || std::abs(route.bias) < 0.005)
                << row.kinds << ' ' << route.name << ' ' << route.bias << ' ' << route.bias_in_errors;
        }
}

TEST(RecordTrials, CombineKindsOfDifferentGroups) {
    const RecordTrialOptions options{.kinds = {"drift_10", "drift_30", "hold", "no_time"}, .pairs = true, .runs = 2};
    EXPECT_EQ(number_of_trials(options), 10);  // all but the two drifts together
    const auto trials = record_trials(options);
    ASSERT_EQ(trials.size(), 10u);
    for (const auto& trial : trials) EXPECT_EQ(trial.kinds.size(), 2u);
    EXPECT_EQ(summary(trials).size(), 5u);
    EXPECT_EQ(summary(trials, "all").count, 10);
}

TEST(RecordTrials, OfTwoKindsAreAnalysedWithoutSilentErrors) {
    // the testing machine deflects under the force, not under the drift of its zero; a camera does not hide exchanged
    // columns
    for (const auto& kinds : {std::vector<std::string>{"drift_-100", "stage_stiffness_given"},
                              {"drift_100", "camera"},
                              {"camera", "swapped"}})
        for (const RecordSummary& row : summary(record_trials({.kinds = kinds, .pairs = true, .runs = 8}))) {
            EXPECT_EQ(row.silent, 0) << row.kinds;
            EXPECT_EQ(row.refused, is_refused(kinds.back()) ? 8 : 0) << row.kinds;
        }
}

TEST(RecordTrials, DoNotCombineMissingFreeFlightWithMissingContact) {
    EXPECT_EQ(number_of_trials({.kinds = {"no_baseline", "no_contact", "hold"}, .pairs = true, .runs = 1}), 2);
}

TEST(RecordTrials, ListValidKindsInTheError) {
    try {
        (void)record_trials({.kinds = {"drift_11"}});
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("drift_10"), std::string::npos);
    }
}

}  // namespace
}  // namespace setae::validation::record_trials_test
