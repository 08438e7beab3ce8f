// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/loop_answer.hpp"

#include <gtest/gtest.h>

namespace setae::output::loop_answer_test {
namespace {

using loops::Outcome;

loops::LoopAnalysis loop() {
    loops::JkrFit fit{.contact_modulus = {1.84e6, 0.2e6}, .work_of_adhesion = {40e-3, 11e-3}};
    fit.converged = true;
    loops::LoopAnalysis analysis;
    analysis.loading.force_displacement = fit;
    for (const double work : {36.1e-3, 39.6e-3, 69.6e-3}) {
        fit.work_of_adhesion.value = work;
        analysis.loading.sensitivity.push_back({0, fit});
    }
    analysis.pull_off = loops::PullOff{.force = {-2.1143e-6, 0.0003e-6}, .work_of_adhesion = {59.82e-3, 0.01e-3}};
    analysis.loop = loops::LoopEnergy{.energy = 1.6141e-12, .standard_error = {.total = 0.0017e-12}};
    return analysis;
}

TEST(LoopAnswer, StatesModulusWorkWithRangePullOffAndLoss) {
    EXPECT_EQ(answer(loop()),
              "E* 1.84 ± 0.20 MPa, W 40 ± 11 mJ/m² (36.1 to 69.6 for other ranges) on loading, "
              "59.820 ± 0.010 mJ/m² at pull-off (-2.11430 ± 0.00030 µN), loss 1.6141 ± 0.0017 pJ");
}

TEST(LoopAnswer, ShowsADashAndTheReasonForMissingNumbers) {
    auto analysis = loop();
    analysis.pull_off = Outcome<loops::PullOff>::missing("the record ends in contact");
    analysis.loop = Outcome<loops::LoopEnergy>::missing("no return to free flight");
    analysis.loading.force_displacement.value->converged = false;
    EXPECT_EQ(
        answer(analysis),
        "E* –, W – on loading (the fit did not converge), pull-off – (the record ends in contact), loss – (no return "
        "to free flight)");
}

TEST(LoopAnswer, ReportsABranchThatIsNotAJkrCurve) {
    auto analysis = loop();
    analysis.alerts.push_back({"POOR_FIT", "a", "unloading: rms residual 2 nm", ""});
    EXPECT_EQ(answer(analysis).find("no JKR curve"), std::string::npos);
    analysis.alerts.push_back({"POOR_FIT", "a", "loading: rms residual 2 nm", ""});
    EXPECT_NE(answer(analysis).find("on loading (poor fit"), std::string::npos);
}

TEST(CurveAnswer, StatesTheSourceOfEachNumber) {
    loops::ForceCurveSummary curve{.fitted_segment = "extend", .work_by_pull_off = true};
    curve.contact_modulus = Estimate{27.9e3, 1.3e3};
    curve.pull_off_force = Estimate{-0.54e-9, 0.08e-9};
    curve.work_of_adhesion = Estimate{23e-6, 3.4e-6};
    curve.energy_loss = Outcome<Estimate>::missing("the curve has no retraction");
    EXPECT_EQ(
        answer(curve),
        "E* 27.9 ± 1.3 kPa on extend, pull-off -0.540 ± 0.080 nN, W 23.0 ± 3.4 µJ/m² from pull-off, loss – (the curve has no "
        "retraction)");
}

TEST(CurveAnswer, StatesACommonReasonOnce) {
    loops::ForceCurveSummary curve{.fitted_segment = "extend", .work_by_pull_off = true};
    curve.contact_modulus = Estimate{27.9e3, 1.3e3};
    curve.energy_loss = Estimate{2e-15, 1e-16};
    curve.pull_off_force = curve.work_of_adhesion = Outcome<Estimate>::missing("no attraction");
    EXPECT_EQ(answer(curve), "E* 27.9 ± 1.3 kPa on extend, pull-off and W – (no attraction), loss 2.00 ± 0.10 fJ");
}

}  // namespace
}  // namespace setae::output::loop_answer_test
