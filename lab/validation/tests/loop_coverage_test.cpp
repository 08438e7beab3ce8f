// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/loop_coverage.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/validation/summary.hpp"

namespace setae::validation::loop_coverage_test {
namespace {

constexpr int runs = 40;

LoopCoverageOptions options() { return {.runs = runs, .signal_to_noise = {30.0}, .samples = 200}; }

/// Whether a row is of a route that claims honest intervals.
bool is_honest(const SummaryRow& row) {
    return row.method == "a(F) both" || row.method == "F-delta" || row.method == "joint";
}

TEST(LoopCoverage, OfRoutesWithBothErrorsIsNinetyFivePerCent) {
    // 40 draws at 95 %: fewer than 32 hits has a probability of 2e-4
    for (const SummaryRow& row : summary(branch_coverage(options()))) {
        EXPECT_EQ(row.count, runs) << row.quantity << ' ' << row.method;
        EXPECT_GE(row.coverage, is_honest(row) ? 0.80 : 0.0) << row.quantity << ' ' << row.method;
        // a standard deviation of 40 draws scatters by 11 %
        if (is_honest(row)) {
            EXPECT_GT(row.scatter, 0.6 * row.stated) << row.quantity << ' ' << row.method;
        }
    }
}

TEST(LoopCoverage, ShowsTheBiasOfLeastSquaresInTheRadiusOnly) {
    int seen = 0;
    for (const SummaryRow& row : summary(branch_coverage(options()))) {
        if (row.quantity != "W loading at SNR 30" || row.method != "a(F)") continue;
        EXPECT_GT(row.bias, 5.0 * row.bias_error);
        ++seen;
    }
    EXPECT_EQ(seen, 1);
}

TEST(LoopCoverage, OfWholeRecordsIsAtLeastEightyPerCent) {
    for (const SummaryRow& row : summary(record_coverage(options()))) EXPECT_GE(row.coverage, 0.80) << row.quantity;
}

TEST(LoopCoverage, RequiresRunsAndSamples) {
    auto none = options();
    none.runs = 0;
    EXPECT_THROW((void)branch_coverage(none), InvalidArgument);
    auto few = options();
    few.samples = 19;
    EXPECT_THROW((void)record_coverage(few), InvalidArgument);
}

}  // namespace
}  // namespace setae::validation::loop_coverage_test
