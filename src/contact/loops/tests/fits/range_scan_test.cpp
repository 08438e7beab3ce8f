// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/range_scan.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::range_scan_test {
namespace {

using tests::rubber_on_diamond;
using tests::SyntheticLoop;

LoopAnalysis analysed(const Loop& loop, const AnalysisOptions& options = {}) {
    return analyse(loop, rubber_on_diamond(), options);
}

/// The loop without its contact radius, noisy in force and displacement.
Loop noisy_depth_record(double share) {
    const SyntheticLoop shape;
    Loop loop = shape.make();
    std::mt19937_64 generator(4);
    loop.force = tests::with_noise(loop.force, share * loop.force.maxCoeff(), generator);
    loop.displacement = tests::with_noise(loop.displacement, share * loop.displacement.maxCoeff(), generator);
    loop.contact_radius.resize(0);
    return loop;
}

TEST(RangeScan, OfAnExactLoopGivesTrueValuesForEveryRange) {
    const SyntheticLoop shape;
    const RangeScan scan = scan_ranges(analysed(shape.make()), rubber_on_diamond(), {});
    EXPECT_EQ(scan.by_end.size(), 8u);
    EXPECT_GE(scan.by_start.size(), 10u);
    for (const auto* fits : {&scan.by_start, &scan.by_end})
        for (const RangeFit& range : *fits) {
            ASSERT_TRUE(range.fit) << range.fit.reason;
            EXPECT_NEAR(range.fit->contact_modulus.value / shape.approach.contact_modulus, 1.0, 1e-6);
            EXPECT_NEAR(range.fit->work_of_adhesion.value / shape.approach.work_of_adhesion, 1.0, 1e-6);
        }
}

TEST(RangeScan, WholeRangeEqualsTheAnalysis) {
    const LoopAnalysis analysis = analysed(noisy_depth_record(1e-3));
    const RangeScan scan = scan_ranges(analysis, rubber_on_diamond(), {});
    const JkrFit& whole = *scan.by_end.back().fit;
    EXPECT_EQ(whole.n, analysis.loading.range.n);
    EXPECT_DOUBLE_EQ(whole.contact_modulus.value, analysis.loading.primary().contact_modulus.value);
}

TEST(RangeScan, NoiseChangesModulusAndWorkAlongTheErrorEllipse) {
    const RangeScan scan = scan_ranges(analysed(noisy_depth_record(3e-3)), rubber_on_diamond(), {});
    EXPECT_LT(scan.ellipse_slope, 0.0);
    // the trade's direction, not its size: shorter ranges trade at other rates
    EXPECT_LT(scan.slope, 0.0);
    EXPECT_NEAR(std::log(scan.slope / scan.ellipse_slope), 0.0, std::log(3.0));
}

TEST(BranchSamples, EqualThoseOfTheFits) {
    const SyntheticLoop shape{.retraction_work = 0.060};
    const LoopAnalysis analysis = analysed(shape.make());
    for (const LoopBranch branch : {LoopBranch::loading, LoopBranch::unloading}) {
        const BranchSamples samples = branch_samples(analysis, branch, {});
        const BranchAnalysis& expected = branch == LoopBranch::loading ? analysis.loading : *analysis.unloading;
        EXPECT_EQ(samples.data.force.size(), expected.range.n);
        EXPECT_DOUBLE_EQ(samples.data.force[0], expected.range.force_first);
        ASSERT_EQ(samples.time.size(), samples.data.force.size());
        EXPECT_DOUBLE_EQ(samples.time[0], analysis.corrected.time[expected.range.first]);
        EXPECT_DOUBLE_EQ(samples.time[samples.time.size() - 1], analysis.corrected.time[expected.range.last]);
    }
}

TEST(BranchSamples, ExcludeSamplesIgnoredByTheFits) {
    const SyntheticLoop shape{.retraction_work = 0.060};
    const LoopAnalysis whole = analysed(shape.make());
    AnalysisOptions options;
    for (const BranchAnalysis* branch : {&whole.loading, &*whole.unloading.value}) {
        const Index first = branch->range.first + 20;
        options.segments.edits.ignored.push_back(
            {.range = IndexRange{.first = first, .last = first + 9}, .reason = "a knock"});
    }
    const LoopAnalysis analysis = analysed(shape.make(), options);
    ASSERT_EQ(analysis.loading.range.n, whole.loading.range.n - 10);
    EXPECT_EQ(branch_samples(analysis, LoopBranch::loading, options).data.force.size(), analysis.loading.range.n);
    const BranchSamples unloading = branch_samples(analysis, LoopBranch::unloading, options);
    EXPECT_EQ(unloading.data.force.size(), analysis.unloading->range.n);
    EXPECT_EQ(unloading.time.size(), unloading.data.force.size());
    EXPECT_EQ(scan_ranges(analysis, rubber_on_diamond(), options).by_end.back().fit->n, analysis.loading.range.n);
}

}  // namespace
}  // namespace setae::loops::range_scan_test
