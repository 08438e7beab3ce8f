// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/screen.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "setae/core/layout.hpp"
#include "setae/output/verdict.hpp"

namespace setae::output::screen_test {
namespace {

using adhesion::PredictionResidual;
using study::StudyResult;

Estimate work(double value, double error) {
    return {.value = value, .standard_error = error, .degrees_of_freedom = 3.0};
}

/// W_int of a fit that rests on one input.
adhesion::WorkFit fit(double value, double error, const char* input) {
    adhesion::WorkFit found;
    found.work_of_adhesion = work(value, error);
    found.generalised.work_of_adhesion = {work(value, error), input};
    found.n = 4;
    return found;
}

adhesion::PredictionTest test(double chi_squared, double probability, double scatter) {
    adhesion::PredictionTest found;
    found.pairs = {{"A", "soft", work(0.04, 1e-3), work(0.037, 1e-3), 3e-3, 1e-3}};
    found.n = 4;
    found.degrees_of_freedom = 3;
    found.chi_squared = chi_squared;
    found.probability = probability;
    found.extra_scatter = scatter;
    return found;
}

/// A study whose approach and loss give different W_int.
StudyResult result_of(const adhesion::PredictionTest& tested, double loss) {
    StudyResult result;
    result.study.title = "Two ways";
    result.surfaces.push_back({.name = "A", .error = "kept short"});
    result.modified = fit(0.037, 2e-4, "noise of the approach");
    result.traced_work_of_adhesion = result.modified->generalised.work_of_adhesion;
    result.work_of_adhesion = result.traced_work_of_adhesion.estimate();
    auto of_loss = fit(loss, 3e-4, "noise of the loss");
    of_loss.r_squared = 0.9;
    result.loop = adhesion::LossFits{.through_origin = of_loss,
                                     .through_origin_without_ideal_loss = {},
                                     .with_intercept = {},
                                     .with_intercept_without_ideal_loss = {}};
    result.prediction_test = tested;
    return result;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(Verdict, StatesThatRoughnessExplainsApproachAndLoss) {
    const auto said = verdict(result_of(test(0.4, 0.94, 0.0), 0.0372));
    ASSERT_EQ(said.answer.size(), 3u);
    EXPECT_EQ(
        said.answer[0],
        "Roughness explains the loss of adhesion on approach within the errors (4 pairs, χ² = 0.4 for 3 degrees of "
        "freedom, p = 0.94). W_int = 37.00 [36.36, 37.64] mJ/m².");
    EXPECT_TRUE(holds(said.answer[1], "mJ/m², consistent with the W_int of approach.")) << said.answer[1];
    EXPECT_EQ(said.answer[2],
              "The noise of 1 measured value contributes 100 % of the variance of W_int. Halving it would reduce the "
              "standard error from 200 µJ/m² to 100 µJ/m².");
    EXPECT_FALSE(
        std::any_of(said.limits.begin(), said.limits.end(), [](const auto& s) { return holds(s, "does not fit"); }));
}

TEST(Verdict, StatesThatTheBalanceFailsAndTheRequiredScatter) {
    auto tested = test(194.0, 4.2e-33, 8.5e-3);
    const auto said = verdict(result_of(tested, 0.050));
    EXPECT_EQ(
        said.answer[0],
        "Roughness does not explain the loss of adhesion on approach within the errors: the full-contact balance (Eq. 7) "
        "does not fit the 4 pairs (χ² = 194.0 for 3 degrees of freedom, p = 4·10⁻³³). It fits with an additional scatter of "
        "8.5 mJ/m² between pairs. W_int = 37.00 [36.36, 37.64] mJ/m².");
    EXPECT_TRUE(holds(said.answer[1],
                      "which differs from the W_int of approach. By generalised least squares, with correlated "
                      "errors, the difference is 13.00 ± 0.36 mJ/m²."))
        << said.answer[1];
    EXPECT_TRUE(std::any_of(said.limits.begin(), said.limits.end(), [](const auto& s) {
        return holds(
            s,
            "does not fit the 4 pairs within the errors (χ² = 194.0 for 3 degrees of freedom, p = 4·10⁻³³). The largest "
            "deviation from the prediction is +3.0 standard errors, for soft on A.");
    }));
    // what the answer states is no reservation once more
    for (const auto& sentence : said.reservations) EXPECT_FALSE(holds(sentence, "does not fit")) << sentence;
    tested.probability_with_scatter = 1e-3;
    EXPECT_FALSE(holds(verdict(result_of(tested, 0.050)).answer[0], "It fits"));
}

TEST(Verdict, ExplainsOneDeviatingPairIfAllTogetherAgree) {
    auto tested = test(2.0, 0.57, 0.0);
    tested.pairs.front().residual = -3.3e-3;
    tested.work_fitted = true;
    const auto limits = verdict(result_of(tested, 0.0372)).limits;
    const auto found = std::find_if(limits.begin(), limits.end(), [](const auto& s) {
        return holds(
            s,
            "soft on A deviates by -3.3 standard errors from its prediction, although the test of all pairs gives p = 0.57.");
    });
    ASSERT_NE(found, limits.end());
    EXPECT_TRUE(holds(*found, deviation_note(tested)));
    for (const auto& sentence : verdict(result_of(tested, 0.0372)).reservations)
        EXPECT_FALSE(holds(sentence, deviation_note(tested))) << "a note is for the report";
    tested.pairs.front().residual = 2.0e-3;
    for (const auto& sentence : verdict(result_of(tested, 0.0372)).limits)
        EXPECT_FALSE(holds(sentence, "standard errors from")) << "one of four pairs may be two off";
}

TEST(Verdict, StatesThatLossAndApproachDiffer) {
    const auto differ = verdict(result_of(test(0.4, 0.94, 0.0), 0.050));
    EXPECT_TRUE(std::any_of(differ.limits.begin(), differ.limits.end(), [](const auto& s) {
        return holds(s, "The energy loss and the approach give different W_int");
    }));
    EXPECT_TRUE(differ.findings.empty());
    const auto agree = verdict(result_of(test(0.4, 0.94, 0.0), 0.0372));
    ASSERT_EQ(agree.findings.size(), 1u);
    EXPECT_TRUE(holds(agree.findings.front(), "The energy loss of loops is proportional to the true area (Eq. 10)"));
}

TEST(Verdict, OfAnEmptyStudyConcludesNothing) {
    const auto said = verdict(StudyResult{});
    EXPECT_TRUE(holds(said.answer.at(0), "Nothing can be concluded"));
    EXPECT_TRUE(holds(said.limits.at(0), "names no surface and no experiment"));
    ASSERT_EQ(said.reservations.size(), 1u);
    EXPECT_EQ(said.reservations[0], said.limits[0]);
}

TEST(Verdict, NamesMissingInformation) {
    StudyResult result;
    result.surfaces.push_back({.name = "A"});
    auto& surface = result.surfaces.front();
    surface.likelihood_error = "the fit of C_iso stopped";
    surface.measurements.resize(2);
    surface.measurements[0].name = "scan";
    surface.measurements[0].alerts = {{"NO_TIP_RADIUS", "scan", "", ""}};
    const auto limits = verdict(result).limits;
    const auto said = [&](const std::string& part) {
        return std::any_of(limits.begin(), limits.end(), [&](const auto& s) { return holds(s, part); });
    };
    EXPECT_TRUE(said(
        "The numbers of A come from the average over its measurements, because the likelihood fit failed: the fit of C_iso "
        "stopped."));
    EXPECT_TRUE(said("The tip radius of scan is not stated"));
    EXPECT_TRUE(said("1 part of the study failed and does not contribute to any number."));
}

TEST(WarningGroups, PutMisleadingWarningsFirst) {
    StudyResult result;
    result.alerts = {{"ONE_DIRECTION", "a", "", ""}, {"NO_INSTRUMENT", "b", "", ""}, {"ONE_DIRECTION", "c", "", ""}};
    const auto groups = grouped_alerts(result);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].code, "NO_INSTRUMENT");
    EXPECT_EQ(groups[1].alerts.size(), 2u);
}

TEST(WarningLines, AreOnePerWarningWithTheWorstFirst) {
    const auto lines = warning_lines({{"ONE_DIRECTION", "a", "one direction", "measure more"},
                                      {"SCARS", "a", "3 scars", ""},
                                      {"NO_INSTRUMENT", "b", "no instrument", "set it"}});
    EXPECT_EQ(lines, (std::vector<std::string>{"NO_INSTRUMENT: b: no instrument; set it", "SCARS: a: 3 scars",
                                               "1 general warning (ONE_DIRECTION); --all shows it"}));
    EXPECT_TRUE(warning_lines({}).empty());
}

TEST(WarningLines, ListFilesOfOneKindTogether) {
    std::vector<Alert> alerts;
    for (int i = 1; i <= 8; ++i) {
        alerts.push_back({"SCARS", fmt::format("{}.ibw", i), fmt::format("{} scars", i), "despike"});
        alerts.push_back({"ONE_PLACE", fmt::format("{}.ibw", i), "one place", ""});
    }
    EXPECT_EQ(warning_lines(alerts),
              (std::vector<std::string>{
                  "SCARS: 1.ibw: 1 scars; despike; also 2.ibw, 3.ibw, 4.ibw, 5.ibw, 6.ibw and 2 more; --all shows each",
                  "8 general warnings (ONE_PLACE); --all shows them"}));
    // warnings about one subject stay apart
    EXPECT_EQ(warning_lines({{"SCARS", "a", "x", ""}, {"SCARS", "a", "y", ""}, {"SCARS", "a", "z", ""}}).size(), 3u);
}

/// A study with more rows than any screen has.
StudyResult many() {
    auto result = result_of(test(0.4, 0.94, 0.0), 0.0372);
    for (int i = 0; i < 50; ++i) {
        result.surfaces.push_back({.name = fmt::format("surface {}", i), .error = "unreadable"});
        study::PairResult pair;
        pair.surface = result.surfaces.back().name;
        pair.elastomer = "soft";
        pair.approach = work(0.037, 1e-3);
        result.pairs.push_back(pair);
        result.alerts.push_back({fmt::format("KIND_{}", i), "some/where/file.csv", std::string(300, 'x'), ""});
    }
    return result;
}

TEST(Screen, NeverExceedsTheGivenLinesAndColumns) {
    const auto result = many();
    for (const std::size_t width : {60u, 80u, 100u, 120u}) {
        std::istringstream text(screen(result, {.width = width, .lines = 40}, 2));
        std::size_t lines = 0;
        for (std::string line; std::getline(text, line); ++lines) EXPECT_LE(display_width(line), width) << line;
        EXPECT_LE(lines, 38u) << width;
        EXPECT_GE(lines, 25u) << width;
    }
}

TEST(Screen, CountsOmittedLines) {
    const auto text = screen(many());
    EXPECT_TRUE(holds(text, " more in surfaces.csv")) << text;
    EXPECT_TRUE(holds(text, " more in pairs.csv")) << text;
    EXPECT_TRUE(holds(text, "Reservation 1 of 3: 51 parts of the study failed")) << text;
    EXPECT_TRUE(holds(text, "and 48 more kinds")) << text;
    EXPECT_TRUE(holds(text, "KIND_0  file.csv: xxx")) << text;
    EXPECT_LT(text.find("Roughness explains"), text.find("Surfaces"));
}

}  // namespace
}  // namespace setae::output::screen_test
