// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pages.hpp"
#include "report/assets.hpp"
#include "report/markup.hpp"
#include "report/table.hpp"
#include "setae/figures/figure.hpp"
#include "setae/output/json.hpp"
#include "setae/output/verdict.hpp"

namespace setae::report::report_test {
namespace {

using output::Json;
using tests::Folder;
using tests::hostile_name;

const RunRecord run{"setae study study.toml", "2026-11-21T18:40:20Z"};

std::string unescaped(std::string text) {
    for (const auto& [entity, letter] :
         {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}})
        for (auto at = text.find(entity); at != std::string::npos; at = text.find(entity, at + 1))
            text.replace(at, std::string(entity).size(), letter);
    return text;
}

/// The page without its programs and styles: Plotly is long.
std::string visible(const std::string& page) {
    const auto style = page.find("</style>"), scripts = page.find("<script type=\"application/json\" id=\"study\">");
    return page.substr(style, scripts - style);
}

/// The page without the JSON in it.
std::string without_data(std::string page) {
    const std::string head = "<script type=\"application/json\"", tail = "</script>";
    for (auto from = page.find(head); from != std::string::npos; from = page.find(head, from))
        page.erase(from, page.find(tail, from) + tail.size() - from);
    return page;
}

/// What a reader sees: no tags.
std::string words(const std::string& html) {
    std::string text;  // by hand: std::regex goes a step deeper into the stack with every letter of a tag
    bool tag = false;
    for (const char c : html) {
        if (c == '<') tag = true;
        else if (tag && c == '>') tag = false;
        else if (!tag) text += c;
    }
    return std::regex_replace(unescaped(text), std::regex("\u00A0"), " ");
}

std::string limits_of(const study::StudyResult& result) {
    const auto page = as_html(result, {}, run);
    const auto from = page.find("<section id=\"limits\""), to = page.find("<section id=\"tables\"");
    return words(page.substr(from, to - from));
}

/// Every number of the page and its place in the JSON; checks that they agree.
std::size_t numbers_that_agree(const std::string& page, const Json& study) {
    static const std::regex number("data-pointer=\"([^\"]*)\" data-part=\"([^\"]*)\" data-value=\"([^\"]*)\">([^<]*)<");
    std::size_t count = 0;
    for (auto it = std::sregex_iterator(page.begin(), page.end(), number); it != std::sregex_iterator();
         ++it, ++count) {
        const Json::json_pointer pointer(unescaped((*it)[1]));
        if (!study.contains(pointer)) {
            ADD_FAILURE() << pointer.to_string() << " is not in the JSON";
            continue;
        }
        const auto& value = study.at(pointer);
        EXPECT_EQ((*it)[3].str(), value.is_string() ? value.get<std::string>() : value.dump()) << pointer.to_string();
    }
    return count;
}

TEST(Report, NumbersOfThePublishedStudyMatchTheJson) {
    const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    const auto page = visible(as_html(result, {}, run));
    // 4 surfaces of 5 quantities with ± and interval alone are 80
    EXPECT_GT(numbers_that_agree(page, output::to_json(result)), 400u);
    EXPECT_NE(
        words(page).find(
            "Approach, full-contact balance (Eq. 7): Wint = 37.8 ± 3.7 mJ m⁻² (95 % interval 30.9 to 45.4 mJ m⁻²), R² = 0.499, from 16 pairs; "
            "reported: Wint = 37.0 ± 3.7 mJ m⁻², R² = 0.6700 ([D19], Fig. 4A)."),
        std::string::npos);
    EXPECT_NE(words(page).find(
                  "Energy loss of loops, true-area loss (Eq. 10): not fitted; reported: Wint = 46.1 ± 7.7 mJ m⁻²"),
              std::string::npos);
}

TEST(Report, StartsWithTheVerdictAndItsFigures) {
    const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    const auto figures = study_figures::study_figures(result);
    const auto page = as_html(result, figures, run);
    std::vector<std::size_t> places{page.find("<main"), page.find("id=\"verdict\"")};
    for (const auto& sentence : output::verdict(result).answer)
        places.push_back(page.find("<p class=\"lead\">" + prose(sentence) + "</p>"));
    for (const char* part :
         {"figure-4", "figure-prediction", "figure-1", "limits", "tables", "table-fits", "more-figures", "figure-S3",
          "not-drawn", "figure-2", "cut", "alerts", "steps", "provenance", "references"})
        places.push_back(page.find(" id=\"" + std::string(part) + "\""));
    EXPECT_EQ(places.back(), page.rfind(" id=\"references\"")) << "there is one";
    EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
    EXPECT_NE(places.back(), std::string::npos);
    EXPECT_EQ(page.find("id=\"figure-1\" aria-labelledby=\"figure-1-title\"><details"), std::string::npos);
    EXPECT_NE(page.find("id=\"figure-S3\" aria-labelledby=\"figure-S3-title\"><details>"), std::string::npos);
    EXPECT_EQ(visible(page).find("<details open"), std::string::npos);
}

TEST(Report, OfThePublishedStudyStatesEveryLimitation) {
    const auto limits = limits_of(study::run_study(study::read_study("examples/nanodiamond/published.toml")));
    for (const char* sentence :
         {"The pairs support the full-contact balance (Eq. 7) more than the small-slope balance (Eq. 2) and the "
          "Persson–Tosatti balance (Eq. S13).",
          "does not fit the 16 pairs within the errors (χ² = 229.9 for 15 degrees of freedom, p = 2·10⁻⁴⁰)",
          "has an additional uncertainty of 9.5 mJ m⁻²",
          "The spectra of PUNCD, UNCD, NCD and MCD are reconstructed from published moments",
          "gives no adhesion for UNCD × E10, NCD × E10 and MCD × E10", "stores more energy than full contact gains",
          "The contact of NCD × E1.0, NCD × E1.9, MCD × E1.0 and MCD × E1.9 is full only under pressure",
          "The hysteresis of the smooth reference on E0.7, E1.0, E1.9 and E10"})
        EXPECT_NE(limits.find(sentence), std::string::npos) << sentence << "\nnot in\n" << limits;
}

/// Identifiers in the order of the page; those of links within it.
std::vector<std::string> found_in(const std::string& page, const char* pattern) {
    std::vector<std::string> found;
    const std::regex wanted(pattern);
    for (auto it = std::sregex_iterator(page.begin(), page.end(), wanted); it != std::sregex_iterator(); ++it)
        found.push_back((*it)[1]);
    return found;
}

TEST(Report, IdentifiersAreUniqueAndLinksHaveTargets) {
    const Folder folder("links");
    folder.write_scan("a.csv", 20e-9);
    auto measured = folder.run(
        "[surfaces.A]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\" }, { file = \"lost.csv\", instrument = \"stylus\" }]\n");
    auto published = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    published.replicates.push_back(tests::sample_replicates("PUNCD", hostile_name));
    for (const auto& result : {measured, published}) {
        const auto page = as_html(result, study_figures::study_figures(result), run);
        const auto attributes = without_data(visible(page));
        const auto identifiers = found_in(attributes, " id=\"([^\"]*)\"");
        const std::set<std::string> known(identifiers.begin(), identifiers.end());
        EXPECT_EQ(known.size(), identifiers.size());
        EXPECT_FALSE(known.contains("study")) << "the JSON's";
        const auto links = found_in(attributes, "(?:href=\"#|aria-labelledby=\")([^\"]*)\"");
        EXPECT_GT(links.size(), 20u);
        for (const auto& link : links) EXPECT_TRUE(known.contains(link)) << link;
    }
}

TEST(Report, FoldsManyFiguresOfOneFamily) {
    std::vector<study_figures::StudyFigure> figures;
    const auto page_of = [&](int n) {
        figures.clear();
        for (int i = 0; i < n; ++i)
            figures.push_back({.identifier = "loop:same",
                               .name = "loop_same_" + std::to_string(i),
                               .title = "a loop",
                               .caption = "",
                               .figure = {.panels = {figures::Panel{}}}});
        return as_html({}, figures, run);
    };
    // the first stands for the verdict, the others are folded
    EXPECT_EQ(page_of(4).find("id=\"figures-loop\""), std::string::npos);
    const auto many = page_of(5);
    const auto family = many.find("id=\"figures-loop\"");
    ASSERT_NE(family, std::string::npos);
    EXPECT_LT(many.find("id=\"figure-loop_same_0\""), family);
    EXPECT_GT(many.find("id=\"figure-loop_same_1\""), family);
}

TEST(Report, ExplainsDeviationsNextToTheTestOfAllPairs) {
    const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    const auto page = visible(as_html(result, study_figures::study_figures(result), run));
    const auto note = prose(output::deviation_note(*result.prediction_test));
    const auto below_figure = page.find(note, page.find("id=\"figure-prediction\"")),
               above_table = page.find(note, page.find("id=\"table-prediction-test\""));
    EXPECT_LT(below_figure, page.find("id=\"figure-1\""));
    ASSERT_NE(above_table, std::string::npos);
    EXPECT_NE(note.find("only the errors of this pair"), std::string::npos);
}

TEST(Report, ShowsReplicatesWithVariancesAndExcludedData) {
    auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    const auto before = numbers_that_agree(visible(as_html(result, {}, run)), output::to_json(result));
    result.replicates.push_back(tests::sample_replicates("PUNCD", hostile_name));
    study::ExperimentResult left_out;
    left_out.input.file = "d.csv";
    left_out.input.surface = "PUNCD";
    left_out.input.elastomer = "E0.7";
    left_out.input.exclusion = "the lens slipped";
    result.experiments.push_back(left_out);
    const auto page = visible(as_html(result, {}, run));
    // mean with ± and interval, prediction, mean with the excluded, n, excluded, I²; two variances
    EXPECT_GE(numbers_that_agree(page, output::to_json(result)), before + 16);
    const auto text = words(page);
    EXPECT_NE(text.find("Work of adhesion over lenses, spots and repeats"), std::string::npos);
    EXPECT_NE(text.find("spot and repeat"), std::string::npos);
    EXPECT_NE(text.find("the lens slipped", text.find("Loops excluded from every mean")), std::string::npos);
    EXPECT_NE(text.find("Measured against predicted, with the errors of both"), std::string::npos);
}

TEST(Report, EveryNumericColumnStatesItsUnit) {
    const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    const auto page = visible(as_html(result, {}, run));
    EXPECT_NE(
        page.find(
            "data-name=\"h_rms\" data-unit=\"m\" class=\"number\"><button type=\"button\"><i>h</i><sub>rms</sub> [nm]</button>"),
        std::string::npos);
    // 37.09 mJ/m²: shown number times unit is the full one
    std::smatch found;
    ASSERT_TRUE(std::regex_search(
        page, found,
        std::regex(
            "data-pointer=\"/fits/modified/work_of_adhesion/value\" data-part=\"value\" data-value=\"([^\"]*)\">([^<]*)<")));
    EXPECT_NEAR(std::stod(found[2]) * 1e-3, std::stod(found[1]), 0.5e-4);
}

TEST(Report, HostileNamesAreShownAsText) {
    const Folder folder("hostile");
    folder.write_scan("a.csv", 20e-9);
    study::StudyResult result =
        folder.run("[surfaces.A]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\", trend = \"mean\" }]\n");
    result.study.title = result.study.description = hostile_name;
    result.surfaces[0].name = result.study.surfaces[0].name = hostile_name;
    result.surfaces[0].measurements[0].file = std::string("bytes \xff\x01 ") + hostile_name;
    result.surfaces[0].alerts.push_back({hostile_name, hostile_name, hostile_name, hostile_name});
    result.inputs.push_back({hostile_name, hostile_name, 3});
    auto& failed = result.experiments.emplace_back();
    failed.input.file = failed.input.surface = failed.input.elastomer = failed.error = hostile_name;
    const auto page = as_html(result, tests::sample_figures(), {hostile_name, hostile_name});
    EXPECT_EQ(page.find("<script>alert"), std::string::npos);
    EXPECT_EQ(without_data(visible(page)).find("\"'&~/"), std::string::npos) << "a quote of the name stands bare";
    EXPECT_EQ(page.find('\xff'), std::string::npos);
    EXPECT_GT(numbers_that_agree(visible(page), output::to_json(result)), 20u);
}

TEST(Report, JsonInThePageIsTheStudyWithoutCurves) {
    const Folder folder("json");
    folder.write_scan("a.csv", 20e-9);
    const auto result = folder.run(
        "[surfaces.\"</script>\"]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\", trend = \"mean\" }]\n");
    const auto page = as_html(result, {}, run);
    const std::string head = "id=\"study\">";
    const auto from = page.find(head) + head.size();
    const auto embedded = Json::parse(page.substr(from, page.find("</script>", from) - from));
    EXPECT_EQ(embedded.at("surfaces").at("</script>").at("rms_height"),
              output::to_json(result).at("surfaces").at("</script>").at("rms_height"));
}

TEST(Report, StatesFailuresWithReasons) {
    const Folder folder("failed");
    folder.write_scan("a.csv", 20e-9);
    const auto result = folder.run(
        "[surfaces.A]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\" }, { file = \"lost.csv\", instrument = \"stylus\" }]\n");
    ASSERT_EQ(result.failures(), 1);
    const auto page = visible(as_html(result, {}, run));
    EXPECT_NE(words(page).find("1 failed: measurement "), std::string::npos);
    EXPECT_NE(words(page).find("; 1 of 2 measurements."), std::string::npos);
    EXPECT_NE(words(page).find("1 part of the study failed and does not contribute to any number."), std::string::npos);
    const auto failed = page.substr(page.find("id=\"table-failed\""), 2000);
    EXPECT_NE(failed.find("<details open>"), std::string::npos);
    EXPECT_NE(failed.find("lost.csv"), std::string::npos);
    EXPECT_NE(words(failed).find(result.surfaces[0].measurements[1].error), std::string::npos);
}

TEST(Report, OfAnEmptyStudyConcludesNothing) {
    study::StudyResult result;
    result.work_of_adhesion = decltype(result.work_of_adhesion)::missing("no pair");
    EXPECT_NE(limits_of(result).find("The study names no surface and no experiment. Nothing can be concluded"),
              std::string::npos);
    EXPECT_NE(words(as_html(result, {}, run)).find("The study contains no surfaces with no measurements"),
              std::string::npos);
}

TEST(Report, WithoutExperimentsPredictsOnlyWithAGivenWorkOfAdhesion) {
    const Folder folder("predicted");
    folder.write_scan("a.csv", 20e-9);
    const std::string surface =
        "[surfaces.A]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\", trend = \"mean\" }]\n";
    const auto without = limits_of(folder.run(surface));
    EXPECT_NE(
        without.find("The study contains no experiment. Roughness is known, but a prediction of Wapp needs Wint."),
        std::string::npos)
        << without;
    auto given = folder.run(surface);
    given.study.work_of_adhesion = Estimate{0.037, 0.004};
    given.work_of_adhesion = *given.study.work_of_adhesion;
    const auto with = limits_of(given);
    EXPECT_NE(
        with.find(
            "The study contains no experiment. Wapp is predicted with the given Wint of 37.0 ± 4.0 mJ m⁻². No measurement "
            "tests this prediction."),
        std::string::npos)
        << with;
    EXPECT_NE(with.find("The study contains one measurement of A."), std::string::npos);
}

/// Published pairs of surfaces given by moments: nothing is read but the study.
std::string published(const std::vector<std::string>& surfaces, const std::vector<std::string>& elastomers) {
    std::string toml;
    for (const auto& name : surfaces)
        toml +=
            "[surfaces." + name +
            "]\nmoments = { rms_height = \"5 nm\", rms_slope = \"0.3\", rms_curvature = \"1 1/nm\", short_wavevector = \"1.6e10 1/m\" }\n";
    for (const auto& name : elastomers)
        toml += "[elastomers." + name +
                "]\nyoungs_modulus = \"0.7 MPa\"\nsurface_energy = \"25 mJ/m2\"\nsphere_radius = \"1 mm\"\n";
    std::string columns, works;
    for (const auto& name : elastomers) {
        columns += (columns.empty() ? "\"" : ", \"") + name + "\"";
        works += (works.empty() ? "" : ", ") + std::string("\"40 ± 2 mJ/m2\"");
    }
    toml += "[published]\nelastomers = [" + columns + "]\n[published.approach]\n";
    for (const auto& name : surfaces) toml += name + " = [" + works + "]\n";
    return toml;
}

TEST(Report, OfOneSurfaceStatesThatRoughnessIsNotTested) {
    const auto limits = limits_of(Folder("one_surface").run(published({"A"}, {"soft", "hard", "other"})));
    EXPECT_NE(limits.find("All 3 pairs are on one surface, A. The data do not test how adhesion depends on roughness."),
              std::string::npos)
        << limits;
}

TEST(Report, OfOneElastomerStatesThatModulusIsNotTested) {
    const auto limits = limits_of(Folder("one_elastomer").run(published({"A", "B"}, {"soft"})));
    EXPECT_NE(limits.find(
                  "All 2 pairs are on one elastomer, soft. The data do not test that the stored energy grows with the "
                  "modulus."),
              std::string::npos)
        << limits;
}

TEST(Report, OfOnePairStatesThatNothingIsTested) {
    const auto limits = limits_of(Folder("one_pair").run(published({"A"}, {"soft"})));
    EXPECT_NE(limits.find("Only one pair is measured. One value of Wint always matches one pair"), std::string::npos)
        << limits;
    EXPECT_NE(limits.find("Wapp is not predicted: "), std::string::npos) << limits;
}

TEST(Report, OfOneExperimentStatesThatScatterIsUnknown) {
    const auto limits =
        limits_of(Folder("one_experiment")
                      .run(published({"A"}, {"soft"}) +
                           "[[experiments]]\nfile = \"lost.csv\"\nsurface = \"A\"\nelastomer = \"soft\"\n"));
    EXPECT_NE(limits.find("The study contains one experiment. The scatter between repeated loops is not known."),
              std::string::npos)
        << limits;
}

TEST(Report, MakesNoNetworkRequest) {
    const auto page = as_html(study::StudyResult{}, tests::sample_figures(), run);
    EXPECT_NE(
        page.find(
            "content=\"default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:\""),
        std::string::npos);
    EXPECT_FALSE(std::regex_search(visible(page), std::regex("(src|href)=\"(https?:)?//")));
}

TEST(Report, FiguresIncludeNumbersCommandAndReason) {
    const auto page = visible(as_html(study::StudyResult{}, tests::sample_figures(), run));
    EXPECT_NE(page.find("Not drawn: no experiment has a contact radius."), std::string::npos);
    EXPECT_NE(words(page).find("setae plot '' --figure 'spectra:it'\\''s'"), std::string::npos);
    const std::string head = "class=\"figure-data\">";
    const auto from = page.find(head) + head.size();
    const auto figure = Json::parse(page.substr(from, page.find("</script>", from) - from));
    const auto& hostile = figure.at("panels").at(0).at("series").at(1);
    EXPECT_EQ(hostile.at("label"), hostile_name);
    EXPECT_TRUE(hostile.at("y").at(7).is_null());
    EXPECT_EQ(hostile.at("x").size(), 50u);
    EXPECT_EQ(figure.at("panels").at(0).at("y").at("html"), "<i>C</i><sub>1D</sub>");
    EXPECT_EQ(figure.at("panels").at(0).at("x").at("shown_unit"), "m⁻¹");
}

// Ends, peaks and valleys of 10 000 points stay, and of hundreds of loops the page holds a part.
TEST(Report, IsSmallForLargeStudies) {
    constexpr Index points = 10000;
    study_figures::StudyFigure figure{.identifier = "loop:a", .name = "loop_a", .title = "a loop"};
    figures::Series series{.label = "force"};
    series.x = Array1D::LinSpaced(points, 0.0, 1.0);
    series.y = Array1D::Zero(points);
    series.y[1234] = 7.5;
    series.y[5678] = -3.25;
    figure.figure.panels.resize(1);
    figure.figure.panels[0].series = {series};
    const auto page = as_html({}, {figure}, {"setae study a.toml", "now"});
    EXPECT_NE(page.find("figures/loop_a.csv contains all points"), std::string::npos);
    EXPECT_NE(page.find("7.5"), std::string::npos);
    EXPECT_NE(page.find("-3.25"), std::string::npos);
    const auto empty = as_html({}, {}, {"setae study a.toml", "now"});
    const std::vector<study_figures::StudyFigure> many(800, figure);
    const auto of_many = as_html({}, many, {"setae study a.toml", "now"});
    EXPECT_LT(of_many.size(), empty.size() + 7'000'000);
    EXPECT_NE(of_many.find("more loops are not in this page"), std::string::npos);
}

TEST(Report, IsTheSameBytesEachTime) {
    const Folder folder("twice");
    folder.write_scan("a.csv", 20e-9);
    const auto result = folder.run("[surfaces.A]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\" }]\n");
    EXPECT_EQ(as_html(result, tests::sample_figures(), run), as_html(result, tests::sample_figures(), run));
}

TEST(Report, HeadingsAreInOrder) {
    const auto page = visible(as_html(study::run_study(study::read_study("examples/nanodiamond/published.toml")),
                                      tests::sample_figures(), run));
    int before = 0;
    const std::regex heading("<h([1-6])");
    for (auto it = std::sregex_iterator(page.begin(), page.end(), heading); it != std::sregex_iterator(); ++it) {
        const int level = std::stoi((*it)[1]);
        EXPECT_LE(level, before + 1);
        before = level;
    }
    EXPECT_EQ(before, 3);
}

TEST(Numbers, ShowTwoDigitsOfTheErrorOrFourOfTheValue) {
    EXPECT_EQ(shown(37.0912, decimals_of(37.0912, 2.1)), "37.1");
    EXPECT_EQ(shown(0.9331761, decimals_of(0.9331761, 0.00015)), "0.93318");
    EXPECT_EQ(shown(2.44123, decimals_of(2.44123, 0.0)), "2.441");
    EXPECT_EQ(shown(-12.289, decimals_of(-12.289, 0.0)), "−12.29");
    EXPECT_EQ(shown(1.548e-22, decimals_of(1.548e-22, 2.1e-23)), "1.548×10⁻²²");
    EXPECT_EQ(shown(1.5707963e10, 0), "1.571×10¹⁰");
    EXPECT_EQ(shown(4e-4, decimals_of(4e-4, 0.0)), "4.000×10⁻⁴");
    EXPECT_EQ(shown(-1.6e-4, decimals_of(-1.6e-4, 1.8e-4)), "−0.00016");
    EXPECT_EQ(shown(0.0, decimals_of(0.0, 0.0)), "0.0");
}

TEST(Numbers, UseTheUnitThatPutsTheLargestBelowAThousand) {
    EXPECT_EQ(display_unit("m", 126.6e-9).name, "nm");
    EXPECT_EQ(display_unit("J/m2", 0.06).name, "mJ/m2");
    EXPECT_EQ(display_unit("1/m", 3.4e9).name, "1/nm");
    EXPECT_EQ(display_unit("Pa", 13.4e6).name, "MPa");
    EXPECT_EQ(display_unit("m3", 1e-20).name, "m3");
    EXPECT_EQ(display_unit("m", 1e-9).name, "nm") << "not 1000 pm";
}

TEST(Markup, FormatsNumbersAndSymbolsButNotNames) {
    EXPECT_EQ(prose("the tip of 5e-06 m hides wavelengths below 1.038e-06 m"),
              "the tip of 5×10⁻⁶ m hides wavelengths below 1.038×10⁻⁶ m");
    EXPECT_EQ(prose("between 1e8 and 1e+09 1/m"), "between 10⁸ and 10⁹ 1/m");
    EXPECT_EQ(prose("W_app of A_w_int <37 mJ/m2>"), "<i>W</i><sub>app</sub> of A_w_int &lt;37 mJ\u00A0m⁻²&gt;");
    EXPECT_EQ(prose("scans/1e5.csv, run_2e3, 3e4_b"), "scans/1e5.csv, run_2e3, 3e4_b");
}

TEST(Page, HasTheColoursOfTheFigureFiles) {
    std::string colours;
    for (const auto* colour : figures::palette)
        colours += fmt::format("{}\"#{}\"", colours.empty() ? "" : ", ", colour);
    EXPECT_NE(assets::program.find("const palette = [" + colours + "]"), std::string_view::npos);
}

TEST(Markup, FormatsUnitsAndQuantities) {
    EXPECT_EQ(typeset_unit("mJ/m2"), "mJ m⁻²");
    EXPECT_EQ(typeset_unit("1/um"), "µm⁻¹");
    EXPECT_EQ(typeset_unit("N/m^1.5"), "N m⁻¹.⁵");
    EXPECT_EQ(typeset_unit("1"), "");
    EXPECT_EQ(typeset("rms slope *h*'_rms"), "rms slope <i>h</i>&#39;<sub>rms</sub>");
    EXPECT_EQ(typeset("*E*\\*"), "<i>E</i>*");
    EXPECT_EQ(typeset("a<b"), "a&lt;b");
    EXPECT_EQ(named("/surfaces", "A/B~C"), "/surfaces/A~1B~0C");
}

}  // namespace
}  // namespace setae::report::report_test
