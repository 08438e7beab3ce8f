// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study_figures/study_figures.hpp"

#include <set>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "small_studies.hpp"

namespace setae::study_figures::study_figures_test {
namespace {

using study::StudyResult;

std::string reason_of(const StudyResult& result, const std::string& identifier) {
    return study_figure(result, identifier).reason;
}

TEST(StudyFigures, OfAnEmptyStudyReportMissingData) {
    const StudyResult empty;
    std::set<std::string> names;
    for (const auto& figure : study_figures(empty)) {
        EXPECT_FALSE(figure.drawable()) << figure.identifier;
        EXPECT_TRUE(figure.figure.panels.empty()) << figure.identifier;
        EXPECT_FALSE(figure.title.empty());
        names.insert(figure.name);
    }
    EXPECT_EQ(names.size(), 18u);
    EXPECT_EQ(reason_of(empty, "1"), "the study has no surface");
    EXPECT_EQ(reason_of(empty, "2"), "the study has no loop on a rough surface");
    EXPECT_EQ(reason_of(empty, "4"), "the study has no pair of surface and elastomer");
    EXPECT_EQ(reason_of(empty, "S6"), "the study has no loop on a smooth reference");
    EXPECT_EQ(reason_of(empty, "hysteresis"), "no W_int is known");
}

TEST(StudyFigures, OfPublishedSurfacesRequireNoMeasurement) {
    auto result = study_of_pairs();
    EXPECT_TRUE(study_figure(result, "1").drawable());
    EXPECT_TRUE(study_figure(result, "S3").drawable());
    EXPECT_EQ(reason_of(result, "S1"), "no surface has a stylus scan");
    EXPECT_NE(reason_of(result, "S2").find("no surface has measurements"), std::string::npos);
    for (auto& surface : result.surfaces) surface.error = "unreadable";
    EXPECT_EQ(reason_of(result, "1"), "every surface failed");
}

TEST(StudyFigures, OfOneSurfaceShowItsSpectrum) {
    StudyResult result;
    result.surfaces = {given_surface("only")};
    EXPECT_TRUE(study_figure(result, "1").drawable());
    EXPECT_FALSE(study_figure(result, "4").drawable());
    EXPECT_FALSE(study_figure(result, "scales").drawable());
}

TEST(StudyFigures, AreFoundByIdentifierOrTheNearestIsSuggested) {
    const auto result = study_of_pairs();
    EXPECT_EQ(study_figure(result, "4").name, "figure_4");
    try {
        (void)study_figure(result, "scale");
        FAIL();
    } catch (const InvalidArgument& error) {
        EXPECT_NE(std::string(error.what()).find("unknown figure 'scale'; did you mean 'scales'?"), std::string::npos)
            << error.what();
    }
}

TEST(StudyFigures, HaveUniqueFileNamesPerSurface) {
    StudyResult result;
    result.surfaces = {given_surface("a b"), given_surface("a/b"), given_surface("ü")};
    const auto q = Array1D{{1e5, 1e6}};
    for (auto& surface : result.surfaces) surface.measurements = {measurement("m", "afm", q, q, {1e5, 1e6})};
    std::set<std::string> names;
    for (const auto& figure : study_figures(result))
        if (figure.identifier.starts_with("spectra:")) names.insert(figure.name);
    EXPECT_EQ(names, (std::set<std::string>{"spectra_a_b", "spectra_a_b_2", "spectra_ü"}));
}

TEST(Figure4, ShowsMeasuredAgainstPredictedAndTheirDifference) {
    const auto drawn = study_figure(study_of_pairs(), "4");
    ASSERT_EQ(drawn.figure.panels.size(), 2u);
    const auto& point = series_of(drawn.figure.panels[0], "smooth on soft");
    EXPECT_DOUBLE_EQ(point.x[0], 30.0);
    EXPECT_DOUBLE_EQ(point.y[0], 33.0);
    EXPECT_DOUBLE_EQ(point.left[0], 28.0);
    EXPECT_DOUBLE_EQ(point.right[0], 32.0);
    EXPECT_DOUBLE_EQ(point.lower[0], 31.0);
    EXPECT_DOUBLE_EQ(point.upper[0], 35.0);
    EXPECT_EQ(point.names, std::vector<std::string>{"smooth on soft"});
    EXPECT_NEAR(series_of(drawn.figure.panels[1], "smooth on soft").y[0], 3.0, 1e-12);
    const auto& line = series_of(drawn.figure.panels[0], "y = x");
    EXPECT_DOUBLE_EQ(line.x[1], line.y[1]);
    // symbol: surface, colour: elastomer
    const auto& other = series_of(drawn.figure.panels[0], "rough on soft");
    EXPECT_EQ(other.colour, point.colour);
    EXPECT_NE(other.symbol, point.symbol);
    EXPECT_NE(drawn.caption.find("B is missing"), std::string::npos) << drawn.caption;
}

TEST(Figure4, FloorsPredictionsAtZero) {
    const auto drawn = study_figure(study_of_pairs(), "4");
    const auto& point = series_of(drawn.figure.panels[0], "rough on hard");
    EXPECT_DOUBLE_EQ(point.x[0], 0.0);
    EXPECT_DOUBLE_EQ(point.right[0], 0.0);
    EXPECT_NEAR(series_of(drawn.figure.panels[1], "rough on hard").y[0], 4.0, 1e-12);
}

TEST(Figure4, ShowsLossAgainstTrueAreaOnALineThroughTheOrigin) {
    auto result = study_of_pairs();
    std::vector<adhesion::PairPoint> points;
    // 40 mJ/m2 exactly: 4e-8 m2 lose 1.6 nJ
    for (const double area : {4e-8, 8e-8}) {
        adhesion::PairPoint point{.surface = "rough",
                                  .elastomer = area < 5e-8 ? "hard" : "soft",
                                  .measured = {0.04 * area, 1e-11},
                                  .slope = area};
        point.floored = false;
        points.push_back(point);
    }
    result.loop = loops::Outcome<adhesion::LossFits>(
        adhesion::LossFits{.through_origin = adhesion::fit_work_of_adhesion(points)});
    const auto drawn = study_figure(result, "4");
    ASSERT_EQ(drawn.figure.panels.size(), 4u);
    const auto& point = series_of(drawn.figure.panels[2], "rough on hard");
    EXPECT_NEAR(point.x[0], 0.04, 1e-12);
    EXPECT_NEAR(point.y[0], 1.6, 1e-12);
    EXPECT_NEAR(series_of(drawn.figure.panels[3], "rough on hard").y[0], 0.0, 1e-9);
    const auto& line = drawn.figure.panels[2].series[0];
    EXPECT_NEAR(line.y[1] / line.x[1], 40.0, 1e-9);
    EXPECT_EQ(line.label.substr(0, 8), "slope 40");
}

TEST(Figure4, ExplainsAFlooredReconstruction) {
    auto result = study_of_pairs();
    result.surfaces[1].reconstructed = true;
    result.pairs[2].area_ratio = 1.5;
    result.pairs[2].approach = Estimate{0.02, 0.002};
    result.pairs[2].stored_energy = {0.09, 0.001};
    const auto caption = study_figure(result, "4").caption;
    EXPECT_NE(caption.find("Reconstruction: the spectrum of rough"), std::string::npos);
    // (37 · 1.5 − 25 · 0.5) mJ/m² over 2.667 MPa
    EXPECT_NE(caption.find("rough on hard (measured 20.0 ± 2.0 mJ/m2; 16.12 nm, not 33.75 nm)"), std::string::npos)
        << caption;
    EXPECT_EQ(caption.find("smooth on"), std::string::npos);
}

TEST(FigureS8, UsesTheFitOfItsBalance) {
    auto result = study_of_pairs();
    std::vector<adhesion::PairPoint> points;
    for (const auto& pair : result.pairs)
        points.push_back({.surface = pair.surface,
                          .elastomer = pair.elastomer,
                          .measured = *pair.approach,
                          .slope = 1.5,
                          .offset = 0.01});
    result.persson_tosatti = loops::Outcome<adhesion::WorkFit>(adhesion::fit_work_of_adhesion(points));
    const double expected = 1e3 * (1.5 * result.persson_tosatti->work_of_adhesion.value - 0.01);
    const auto drawn = study_figure(result, "S8");
    EXPECT_NEAR(series_of(drawn.figure.panels[0], "smooth on soft").x[0], expected, 1e-9);
    EXPECT_NEAR(series_of(drawn.figure.panels[1], "smooth on soft").y[0], 33.0 - expected, 1e-9);
}

TEST(Scales, AreSharesThatEndAtOne) {
    auto result = study_of_pairs();
    for (auto& pair : result.pairs) {
        adhesion::ScaleBalance scales;
        scales.wavevector = Array1D{{1e5, 1e6, 1e7}};
        scales.stored_share = Array1D{{0.0, 0.6, 1.0}};
        scales.area_share = Array1D{{0.0, 0.1, 1.0}};
        scales.work_share = Array1D{{0.0, 1.4, 1.0}};
        pair.scales = scales;
    }
    const auto drawn = study_figure(result, "scales");
    ASSERT_EQ(drawn.figure.panels.size(), 3u);
    for (const auto& panel : drawn.figure.panels) {
        // both surfaces are on "soft", one alone on "hard"
        ASSERT_EQ(panel.series.size(), 2u);
        for (const auto& series : panel.series) EXPECT_DOUBLE_EQ(series.y[2], 100.0);
    }
    EXPECT_DOUBLE_EQ(drawn.figure.panels[0].series[0].y[1], 60.0);
    EXPECT_DOUBLE_EQ(drawn.figure.panels[2].series[0].y[1], 140.0);
}

TEST(Agreement, IsDrawnByInstrumentInTheMiddleOfEachDecade) {
    auto result = study_of_pairs();
    EXPECT_EQ(reason_of(result, "agreement"), "no spectrum was fitted to the measurements of a surface by likelihood");
    study::FittedSpectrum fitted;
    fitted.agreement = {
        {.instrument = "afm", .decade = 6, .ratio = 1.1, .standard_error = 0.2, .chi_squared = 5.0, .groups = 4},
        {.instrument = "tem", .decade = 8, .ratio = 0.9}};
    result.surfaces[0].fitted = fitted;
    const auto drawn = study_figure(result, "agreement");
    ASSERT_EQ(drawn.figure.panels.size(), 1u);
    EXPECT_NEAR(std::log10(series_of(drawn.figure.panels[0], "AFM").x[0]), 6.5, 1e-12);
    EXPECT_DOUBLE_EQ(series_of(drawn.figure.panels[0], "AFM").y[0], 1.1);
    EXPECT_DOUBLE_EQ(series_of(drawn.figure.panels[0], "AFM").upper[0], 1.3);
    EXPECT_DOUBLE_EQ(series_of(drawn.figure.panels[0], "TEM").y[0], 0.9);
}

TEST(PredictionFigure, ShowsMeasuredValuesAndTheCurveOfTheirSurface) {
    auto result = study_of_pairs();
    std::vector<adhesion::PredictionResidual> residuals;
    for (const auto& pair : result.pairs)
        residuals.push_back({pair.surface, pair.elastomer, *pair.approach, pair.modified->estimate});
    result.prediction_test =
        adhesion::prediction_test(residuals, Array2D((Eigen::MatrixXd::Identity(3, 3) * 4e-6).array()), std::nullopt);
    const auto drawn = study_figure(result, "prediction");
    ASSERT_TRUE(drawn.drawable()) << drawn.reason;
    ASSERT_EQ(drawn.figure.panels.size(), 2u);
    const auto& rough = drawn.figure.panels[1];
    const auto& hard = series_of(rough, "hard");
    EXPECT_NEAR(hard.x[0], 2.0 / 0.75, 1e-12);
    EXPECT_NEAR(hard.right[0] - hard.x[0], 0.02, 1e-12);
    EXPECT_DOUBLE_EQ(hard.y[0], 4.0);
    EXPECT_NEAR(hard.upper[0], 6.0, 1e-12);
    ASSERT_EQ(rough.notes.size(), 2u);
    EXPECT_EQ(rough.notes[0].text, "−1.0 σ");
    // below every bar and the axis' line
    for (const auto& note : rough.notes) EXPECT_LT(note.y, 0.0);
    const auto& curve = series_of(rough, "Eq. 7, 95 % band");
    EXPECT_LT(curve.x[0], 1.0 / 0.75);
    EXPECT_GT(curve.x[curve.x.size() - 1], 2.0 / 0.75);
    EXPECT_TRUE((curve.lower <= curve.y).all() && (curve.y <= curve.upper).all());
    EXPECT_NE(drawn.caption.find("χ² = "), std::string::npos);
}

TEST(PredictionFigure, ShowsUnmeasuredPredictionsHollow) {
    auto result = study_of_pairs();
    auto& pair = result.pairs.back();
    pair.approach.reset();
    const auto drawn = study_figure(result, "prediction");
    ASSERT_TRUE(drawn.drawable()) << drawn.reason;
    const figures::Series* hollow = nullptr;
    for (const auto& panel : drawn.figure.panels)
        for (const auto& series : panel.series)
            if (series.hollow) hollow = &series;
    ASSERT_NE(hollow, nullptr);
    EXPECT_EQ(hollow->label, pair.elastomer + ", not measured");
    EXPECT_DOUBLE_EQ(hollow->y[0], 1e3 * pair.modified->work.floored);
    EXPECT_NE(drawn.caption.find("Hollow: predicted, not measured"), std::string::npos);
}

TEST(ReplicatesFigure, HasAPanelForEachElastomerWithItsExcludedLoops) {
    auto result = study_of_pairs();
    EXPECT_EQ(reason_of(result, "replicates"), "no loop names a lens, a spot or an exclusion");
    for (const char* name : {"soft", "hard"}) {
        study::ElastomerReplicates replicates{.elastomer = name, .symbol = "W_app"};
        replicates.data.rows = {{0.03, 0.001, {"smooth", "1", "1"}, "a"},
                                {0.04, 0.001, {"smooth", "2", "1"}, "b"},
                                {0.09, 0.001, {"smooth", "2", "2"}, "c"}};
        replicates.data.exclusions = {{2, "dust"}};
        replicates.model = statistics::mixed_model(replicates.data);
        result.replicates.push_back(replicates);
    }
    const auto drawn = study_figure(result, "replicates");
    ASSERT_EQ(drawn.figure.panels.size(), 2u);
    EXPECT_EQ(drawn.figure.panels[1].title, "hard");
    EXPECT_NEAR(drawn.figure.panels[1].place->top + drawn.figure.panels[1].place->height, 1.0, 1e-12);
    EXPECT_EQ(drawn.figure.panels[0].notes.at(0).text, "dust");
    EXPECT_NE(drawn.caption.find("6 loops"), std::string::npos);
}

TEST(StudyFigures, FitTheRequestedColumn) {
    const auto single = study_figures(study_of_pairs(), {.width = FigureWidth::single_column}),
               whole = study_figures(study_of_pairs());
    for (std::size_t i = 0; i < single.size(); ++i) {
        if (!single[i].drawable()) continue;
        EXPECT_DOUBLE_EQ(single[i].figure.width_mm, 85.0) << single[i].identifier;
        EXPECT_GT(whole[i].figure.width_mm, 85.0) << whole[i].identifier;
        EXPECT_LE(whole[i].figure.width_mm, 178.0) << whole[i].identifier;
    }
}

}  // namespace
}  // namespace setae::study_figures::study_figures_test
