// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/loops/record_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "refusal.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::record_checks_test {
namespace {

using tests::rubber_on_diamond;
using tests::SyntheticLoop;

const SyntheticLoop smooth{.samples = 400};

Loop noisy() {
    std::mt19937_64 generator(1);
    Loop loop = smooth.make();
    loop.force = tests::with_noise(loop.force, 1e-7, generator);
    return loop;
}

/// The message of an alert, empty where there is none.
std::string alert_of(const LoopAnalysis& analysis, const std::string& code) {
    const auto found =
        std::find_if(analysis.alerts.begin(), analysis.alerts.end(), [&](const Alert& a) { return a.code == code; });
    return found == analysis.alerts.end() ? "" : found->message;
}

std::string alert_of(const Loop& loop, const std::string& code,
                     const LensAndCounterBody& bodies = rubber_on_diamond()) {
    return alert_of(analyse(loop, bodies), code);
}

void expect_says(const std::string& message, const std::string& words) {
    EXPECT_NE(message.find(words), std::string::npos) << "'" << message << "'";
}

TEST(RecordFaults, AreEmptyForAnIdealRecord) {
    for (const Loop& loop : {smooth.make(), noisy()}) {
        const RecordFaults faults = record_faults(loop);
        EXPECT_TRUE(faults.saturated_high.empty());
        EXPECT_TRUE(faults.saturated_low.empty());
        EXPECT_EQ(faults.frames_missing, 0);
        EXPECT_FALSE(faults.longest_gap);
        EXPECT_FALSE(faults.time_backwards);
        for (const char* code :
             {"FORCE_SATURATED", "FRAME_MISSING", "TIME_BACKWARDS", "UNITS_IMPLAUSIBLE", "TWO_CONTACTS"})
            EXPECT_EQ(alert_of(loop, code), "") << code;
    }
}

TEST(SaturatedForce, IsReportedAndExcludedFromTheFits) {
    Loop loop = noisy();
    const double limit = 0.8 * loop.force.maxCoeff();
    loop.force = loop.force.min(limit);
    const RecordFaults faults = record_faults(loop);
    ASSERT_EQ(faults.saturated_high.size(), 1u);
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
    const std::string message = alert_of(analysis, "FORCE_SATURATED");
    expect_says(message, "largest");
    expect_says(message, std::to_string(faults.saturated_high[0].first) + " to " +
                             std::to_string(faults.saturated_high[0].last));
    EXPECT_LT(analysis.loading.range.last, faults.saturated_high[0].first);
    EXPECT_NEAR(analysis.loading.force_displacement->work_of_adhesion.value / 0.040, 1.0, 0.01);
    // the pull-off, too
    Loop low = noisy();
    low.force = low.force.max(0.7 * low.force.minCoeff());
    expect_says(alert_of(low, "FORCE_SATURATED"), "smallest");
}

TEST(SaturatedForce, IsDistinguishedFromCoarseConvertersAndHolds) {
    Loop coarse = smooth.make();
    const double step = coarse.force.maxCoeff() / 20.0;
    coarse.force = (coarse.force / step).round() * step;
    EXPECT_TRUE(record_faults(coarse).saturated_high.empty());
}

TEST(MissingFrames, AreCountedWithTheLongestGap) {
    Loop loop = smooth.make();
    loop.contact_radius.segment(500, 60) = Array1D::Constant(60, undefined);
    loop.contact_radius[700] = undefined;
    const RecordFaults faults = record_faults(loop);
    EXPECT_EQ(faults.frames_missing, 61);
    EXPECT_EQ(*faults.longest_gap, (IndexRange{500, 559}));
    expect_says(alert_of(loop, "FRAME_MISSING"), "samples 500 to 559");
}

TEST(MissingFrames, DoNotIncludeThoseBetweenFramesOfASlowCamera) {
    Loop loop = smooth.make();
    for (Index i = 0; i < loop.contact_radius.size(); ++i)
        if (i % 10 != 0) loop.contact_radius[i] = undefined;
    EXPECT_EQ(record_faults(loop).frames_missing, 0);
    loop.contact_radius.segment(500, 100) = Array1D::Constant(100, undefined);
    EXPECT_EQ(record_faults(loop).frames_missing, 10);
}

TEST(TimeBackwards, IsReportedAndTheRestIsAnalysed) {
    Loop loop = smooth.make();
    loop.time[700] = 3.0;
    const LoopAnalysis analysis = analyse(loop, rubber_on_diamond());
    expect_says(alert_of(analysis, "TIME_BACKWARDS"), "sample 700");
    EXPECT_NEAR(analysis.loading.primary().work_of_adhesion.value / 0.040, 1.0, 1e-8);
    EXPECT_NEAR(analysis.loop->energy / smooth.loss(), 1.0, 1e-3);
}

TEST(ImplausibleUnits, AreReportedWithColumnAndLikelyFactor) {
    // contact radii in µm read as m: larger than the sphere
    Loop loop = smooth.make();
    loop.contact_radius *= 1e6;
    expect_says(
        alert_of(loop, "UNITS_IMPLAUSIBLE"),
        "more than the sphere radius 1.250 mm: one of them is wrong, and the likely factor of the contact radius is 10^-6");
    // forces in mN read as N
    loop = smooth.make();
    loop.force *= 1e3;
    expect_says(alert_of(loop, "UNITS_IMPLAUSIBLE"), "W = 40.0 J/m²");
    expect_says(alert_of(loop, "UNITS_IMPLAUSIBLE"), "the likely factor is 10^-3");
    // forces in N read as µN
    loop = smooth.make();
    loop.force *= 1e-6;
    expect_says(alert_of(loop, "UNITS_IMPLAUSIBLE"), "the likely factor of the force is 10^6");
    // displacements in µm read as mm, no contact radius
    loop = smooth.make();
    loop.displacement *= 1e3;
    loop.contact_radius = Array1D();
    expect_says(alert_of(loop, "UNITS_IMPLAUSIBLE"), "or that of the displacement 10^-3");
}

TEST(ImplausibleUnits, OfTheSphereAreReported) {
    EXPECT_NE(alert_of(smooth.make(), "UNITS_IMPLAUSIBLE", rubber_on_diamond(1.25e-6)), "");
    EXPECT_EQ(alert_of(smooth.make(), "UNITS_IMPLAUSIBLE", rubber_on_diamond(2.5e-3)), "");
}

TEST(ChannelsOfDifferentLength, AreRefusedByName) {
    Loop loop = smooth.make();
    loop.time.conservativeResize(10);
    expect_says(tests::refusal_of<InvalidArgument>([&] { (void)analyse(loop, rubber_on_diamond()); }),
                "time has 10 samples, force has");
}

}  // namespace
}  // namespace setae::loops::record_checks_test
