// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/segment_edits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "refusal.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::segment_edits_test {
namespace {

using tests::refusal_of;
using tests::rubber_on_diamond;
using tests::SyntheticLoop;

SegmentEdits edits_of(const std::vector<std::string>& texts) {
    SegmentEdits edits;
    for (const auto& text : texts) add_segment_edit(edits, text);
    return edits;
}

Segments edited(const Loop& loop, const std::vector<std::string>& texts) {
    return find_segments(loop, {.edits = edits_of(texts)});
}

std::string refused(const Loop& loop, const std::vector<std::string>& texts) {
    return refusal_of<InvalidArgument>([&] { (void)edited(loop, texts); });
}

TEST(SegmentEditText, CoversEveryEdit) {
    const std::vector<std::string> texts{"baseline=0s:12.5s",
                                         "baseline_after=1500:1600",
                                         "jump_in=399:401",
                                         "loading=401:900",
                                         "hold=790:820",
                                         "unloading=900:1000",
                                         "pull_off=1000:1004",
                                         "cut=600",
                                         "cut=700",
                                         "loading@3=5s:6.25s",
                                         "ignore=30:35 (door slammed)"};
    const SegmentEdits edits = edits_of(texts);
    ASSERT_EQ(edits.contacts.size(), 3u);
    EXPECT_EQ(std::get<IndexRange>(*edits.contacts[0].pull_off), (IndexRange{1000, 1004}));
    EXPECT_EQ(edits.contacts[0].cuts, (std::vector<Index>{600, 700}));
    EXPECT_EQ(std::get<TimeRange>(*edits.contacts[2].loading), (TimeRange{5.0, 6.25}));
    ASSERT_EQ(edits.ignored.size(), 1u);
    EXPECT_EQ(edits.ignored[0].reason, "door slammed");
    EXPECT_TRUE(SegmentEdits{}.empty());
    EXPECT_FALSE(edits.empty());
}

TEST(SegmentEditText, AcceptsTimesInAnyUnit) {
    const SegmentEdits edits = edits_of({"loading = 120 ms : 0.5 min"});
    EXPECT_EQ(std::get<TimeRange>(*edits.contacts[0].loading), (TimeRange{0.12, 30.0}));
}

TEST(SegmentEditText, NamesInvalidEdits) {
    const auto message = [](const char* text) { return refusal_of<InvalidArgument>([&] { (void)edits_of({text}); }); };
    EXPECT_NE(message("loading").find("no '='"), std::string::npos);
    EXPECT_NE(message("load=1:2").find("'load' is unknown"), std::string::npos);
    EXPECT_NE(message("loading=12").find("FIRST:LAST"), std::string::npos);
    EXPECT_NE(message("loading=1:2s").find("one end is a sample"), std::string::npos);
    EXPECT_NE(message("loading=a:b").find("loading=a:b"), std::string::npos);
    EXPECT_NE(message("loading@0=1:2").find("starts at 1"), std::string::npos);
    EXPECT_NE(message("cut=1:2").find("one sample"), std::string::npos);
    EXPECT_NE(message("ignore=1:2").find("reason"), std::string::npos);
}

TEST(SegmentEdits, ReplaceOnlyTheNamedSegments) {
    const Loop loop = SyntheticLoop{.samples = 400}.make();
    const Segments found = find_segments(loop), changed = edited(loop, {"loading=450:801", "baseline=0:199"});
    EXPECT_EQ(changed.contacts[0].loading, (IndexRange{450, 801}));
    EXPECT_EQ(changed.contacts[0].unloading, found.contacts[0].unloading);
    EXPECT_EQ(changed.contacts[0].jump_in, found.contacts[0].jump_in);
    EXPECT_EQ(changed.before.range, (IndexRange{0, 199}));
    ASSERT_EQ(changed.cycles.size(), 1u);
    EXPECT_EQ(changed.cycles[0].loading.first, 450);
}

TEST(SegmentEdits, ConvertTimesToSamples) {
    const Loop loop = SyntheticLoop{.samples = 400}.make();  // a sample each 0.1 s
    EXPECT_EQ(edited(loop, {"loading=45s:80.15s"}).contacts[0].loading, (IndexRange{450, 801}));
    Loop timeless = loop;
    timeless.time = Array1D();
    EXPECT_NE(refused(timeless, {"loading=45s:80s"}).find("has no time"), std::string::npos);
    EXPECT_NE(refused(loop, {"loading=450s:800s"}).find("contains no sample"), std::string::npos);
}

TEST(SegmentEdits, ShortenNeighbouringSegments) {
    const Loop loop = SyntheticLoop{.samples = 400}.make();
    const Segments segments = edited(loop, {"loading=390:850"});
    EXPECT_EQ(segments.contacts[0].jump_in, std::nullopt);
    EXPECT_EQ(segments.contacts[0].unloading->first, 850);
}

TEST(SegmentEdits, ReportImpossibleRangesWithReason) {
    const Loop loop = SyntheticLoop{.samples = 400}.make();
    const std::string outside = refused(loop, {"loading=450:5000"});
    EXPECT_NE(outside.find("loading"), std::string::npos);
    EXPECT_NE(outside.find("samples 0 to"), std::string::npos);
    EXPECT_NE(refused(loop, {"loading=800:450"}).find("end before they begin"), std::string::npos);
    const std::string overlap = refused(loop, {"loading=450:850", "unloading=800:1000"});
    EXPECT_NE(overlap.find("unloading"), std::string::npos);
    EXPECT_NE(overlap.find("overlap those of loading"), std::string::npos);
    EXPECT_NE(refused(loop, {"unloading=410:440", "loading=450:500"}).find("overlap"), std::string::npos);
    EXPECT_NE(refused(loop, {"hold=10:20"}).find("hold"), std::string::npos);
    EXPECT_NE(refused(loop, {"loading@2=450:800"}).find("segments are given for contact 2, but the record has 1"),
              std::string::npos);
    EXPECT_NE(refused(loop, {"cut=5"}).find("cut"), std::string::npos);
    EXPECT_NE(refused(loop, {"baseline=0:403"}).find("reach into contact"), std::string::npos);
    EXPECT_NE(refused(loop, {"baseline_after=700:1500"}).find("before contact ends"), std::string::npos);
    EXPECT_NE(refused(loop, {"baseline=3:5"}).find("at least 5"), std::string::npos);
    EXPECT_NE(refused(loop, {"loading=1200:1300"}).find("leave no samples for unloading"), std::string::npos);
}

TEST(SegmentEdits, CutCyclesAtGivenSamples) {
    const Loop loop = SyntheticLoop{.samples = 400}.make();
    const Segments segments = edited(loop, {"cut=600", "cut=700"});
    ASSERT_EQ(segments.cycles.size(), 3u);
    EXPECT_EQ(segments.contacts[0].cycles, (std::vector<Index>{0, 1, 2}));
    EXPECT_EQ(segments.cycles[1].loading, (IndexRange{600, 700}));
    EXPECT_EQ(segments.cycles[2].unloading, (IndexRange{801, segments.contacts[0].unloading->last}));
    EXPECT_TRUE(segments.cycles[2].ends_in_pull_off);
    EXPECT_FALSE(segments.cycles[0].ends_in_pull_off);
}

TEST(SegmentEdits, SetABaselineAwayFromTheStart) {
    Loop loop = tests::from(SyntheticLoop{.samples = 400}.make(), 380);
    loop.contact_radius = Array1D();
    EXPECT_THROW((void)find_segments(loop, {.baseline_share = 0.2}), UndefinedDataError);
    EXPECT_EQ(find_segments(loop, {.baseline_share = 0.2, .edits = edits_of({"baseline=0:19"})}).contacts.size(), 1u);
}

TEST(SegmentEdits, AreUsedByTheAnalysis) {
    const Loop clean = SyntheticLoop{.samples = 400}.make();
    Loop loop = clean;
    loop.force.segment(500, 6) += 1e-4;
    const auto options = [](const std::vector<std::string>& texts) {
        AnalysisOptions made;
        made.segments.edits = edits_of(texts);
        return made;
    };
    const double spoilt = analyse(loop, rubber_on_diamond()).loading.radius_force->work_of_adhesion.value;
    const LoopAnalysis mended = analyse(loop, rubber_on_diamond(), options({"ignore=500:505 (door slammed)"}));
    EXPECT_GT(std::abs(spoilt / 0.040 - 1.0), 1e-5);
    EXPECT_NEAR(mended.loading.radius_force->work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_NEAR(mended.loading.force_displacement->work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_EQ(mended.loading.range.n, 398 - 6);
    const LoopAnalysis shorter = analyse(clean, rubber_on_diamond(), options({"loading=401:600"}));
    EXPECT_EQ(shorter.loading.range.last, 600);
    EXPECT_EQ(shorter.loading.range.n, 197);
}

}  // namespace
}  // namespace setae::loops::segment_edits_test
