// SPDX-License-Identifier: GPL-3.0-or-later
// Alerts of loops: each where it belongs and not on the loop it was made from.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "setae/loops/analysis.hpp"
#include "synthetic_loop.hpp"

namespace setae::loops::alerts_test {
namespace {

const tests::SyntheticLoop shape{.retraction_work = 0.07, .samples = 800};

bool has(const Loop& loop, const std::string& code) {
    const auto alerts = analyse(loop, tests::rubber_on_diamond()).alerts;
    return std::any_of(alerts.begin(), alerts.end(), [&](const Alert& alert) { return alert.code == code; });
}

Index last_in_contact(const Loop& loop) {
    Index last = loop.contact_radius.size() - 1;
    while (!(loop.contact_radius[last] > 0.0)) --last;
    return last;
}

TEST(LoopWarnings, ReportMissingFreeFlight) {
    const Loop whole = shape.make();
    const Index contact = shape.samples + 1;
    EXPECT_FALSE(has(whole, "NO_BASELINE"));
    EXPECT_FALSE(has(whole, "DRIFT_UNKNOWN"));
    EXPECT_FALSE(has(whole, "ONE_BASELINE"));
    EXPECT_TRUE(has(tests::from(whole, contact), "ONE_BASELINE"));
    EXPECT_TRUE(has(tests::piece(whole, 0, 2 * contact), "ONE_BASELINE"));
    EXPECT_TRUE(has(tests::piece(whole, contact, contact), "NO_BASELINE"));
    const auto alerts =
        analyse(whole, tests::rubber_on_diamond(), {.segments = {.drift = DriftModel::constant}}).alerts;
    EXPECT_TRUE(std::any_of(alerts.begin(), alerts.end(), [](const Alert& a) { return a.code == "DRIFT_UNKNOWN"; }));
}

// At pull-off the testing machine springs back by F/k; the contact has some 200 N/m.
TEST(LoopWarnings, ReportATooSoftMachine) {
    const auto on_machine = [](double stiffness) {
        Loop loop = shape.make();
        const Index last = last_in_contact(loop), rest = loop.displacement.size() - last - 1;
        loop.displacement.tail(rest) += loop.force[last] / stiffness;
        return loop;
    };
    EXPECT_TRUE(has(on_machine(10.0), "STIFFNESS_UNRESOLVED"));
    EXPECT_FALSE(has(on_machine(1000.0), "STIFFNESS_UNRESOLVED"));
    EXPECT_FALSE(has(shape.make(), "STIFFNESS_UNRESOLVED"));
}

// A radius that is read the larger the harder one presses fits no JKR curve.
TEST(LoopWarnings, ReportThatNoJkrCurveFitsTheRadius) {
    Loop bent = shape.make();
    const double largest = bent.contact_radius.maxCoeff();
    bent.contact_radius *= 1.0 + 0.25 * (bent.contact_radius / largest).pow(4);
    EXPECT_TRUE(has(bent, "POOR_FIT"));
    EXPECT_FALSE(has(shape.make(), "POOR_FIT"));
}

// Dirt at the rim: the first contact reads too small by half, less with every sample.
TEST(LoopWarnings, ReportThatTheWorkDependsOnTheFitRange) {
    Loop late = tests::SyntheticLoop{.retraction_work = 0.07, .samples = 60}.make();
    EXPECT_FALSE(has(late, "RANGE_SENSITIVE"));
    constexpr Index contact = 61, spoilt = 30;
    for (Index i = 0; i < spoilt; ++i) late.contact_radius[contact + i] *= 0.5 + 0.5 * static_cast<double>(i) / spoilt;
    EXPECT_TRUE(has(late, "RANGE_SENSITIVE"));
}

}  // namespace
}  // namespace setae::loops::alerts_test
