// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/abel.hpp"
#include "small_studies.hpp"

namespace setae::study_figures::spectra_figures_test {
namespace {

using study::StudyResult;

/// Two AFM measurements and a stylus scan of one surface, averaged.
StudyResult measured_study() {
    StudyResult result;
    auto surface = given_surface("rough");
    const Array1D q = Array1D::LinSpaced(2000, 1e6, 2e9);
    for (const char* name : {"first", "second"})
        surface.measurements.push_back(measurement(name, "afm", q, 1e-6 * q.pow(-3.0), {2e6, 5e8}));
    const Array1D stylus = Array1D::LinSpaced(50, 1e4, 5e5);
    surface.measurements.push_back(measurement("scan", "stylus", stylus, Array1D::Constant(50, 1e-20), {1e4, 4e5}));
    auto& scan = surface.measurements.back();
    scan.preview.positions = Array1D::LinSpaced(1000, 0.0, 5e-4);
    scan.preview.heights = 1e-8 * (scan.preview.positions * 1e6).sin();
    scan.preview.heights[500] = 5e-8;
    scan.preview.size = {5e-4, 0.0};
    surface.combined = spectra::CombinedSpectrum{{.wavevector = Array1D{{1e5, 1e6}},
                                                  .density = Array1D{{1e-20, 2e-20}},
                                                  .band = {1e5, 1e6},
                                                  .standard_error = Array1D{{1e-21, undefined}},
                                                  .count = Array1D{{3.0, 1.0}}},
                                                 Array1D{{1.0, 1.0}}};
    surface.average.curve = {
        surface.combined->wavevector, surface.combined->density, {1e5, 1e6}, spectra::Density::C1D};
    result.surfaces = {surface};
    return result;
}

TEST(Figure1, ShowsTheAverageWithItsUncertaintyIfKnown) {
    const auto drawn = study_figure(measured_study(), "1");
    const auto& panel = drawn.figure.panels[0];
    const auto& curve = series_of(panel, "rough");
    EXPECT_DOUBLE_EQ(curve.y[0], 1e-20);
    const auto& band = series_of(panel, "rough, 95 %");
    EXPECT_NEAR(band.upper[0], 1e-20 + 4.302653e-21, 1e-26);
    EXPECT_NEAR(band.lower[0], 1e-20 - 4.302653e-21, 1e-26);  // t of two degrees of freedom
    EXPECT_TRUE(std::isnan(band.upper[1]));
    const auto& bar = series_of(panel, "reliable band of AFM");
    EXPECT_DOUBLE_EQ(bar.x[0], 2e6);
    EXPECT_DOUBLE_EQ(bar.x[1], 5e8);
    // above every curve
    EXPECT_GT(bar.y[0], curve.y.maxCoeff());
    EXPECT_EQ(panel.notes.size(), 2u);
}

TEST(Figure1, ShowsAReconstructionAsTheAbelIntegralOfItsSpectrum) {
    StudyResult result;
    auto surface = given_surface("published");
    surface.reconstructed = true;
    surface.average.curve.kind = spectra::Density::C_iso;
    result.surfaces = {surface};
    const auto drawn = study_figure(result, "1");
    const auto& curve = series_of(drawn.figure.panels[0], "published (reconstruction)");
    ASSERT_EQ(curve.x.size(), 3);  // at the spectrum's end the integral is 0
    const Array1D expected =
        spectra::profile_from_isotropic(surface.average.curve.wavevector, surface.average.curve.density, curve.x);
    EXPECT_TRUE((curve.y == expected).all());
    EXPECT_NE(drawn.caption.find("published reconstructed from published moments"), std::string::npos) << drawn.caption;
    const auto isotropic = study_figure(result, "S3");
    EXPECT_TRUE(
        (series_of(isotropic.figure.panels[0], "published (reconstruction)").y == surface.average.curve.density).all());
}

TEST(Figure1, ShowsFittedSpectraWithTheirLogarithmicError) {
    StudyResult result;
    auto surface = given_surface("fitted");
    surface.method = study::SpectrumMethod::likelihood;
    study::FittedSpectrum fitted;
    fitted.wavevector = Array1D{{1e5, 1e6}};
    fitted.C1D = Array1D{{1e-20, 1e-21}};
    fitted.log_C1D_standard_error = Array1D{{0.1, 0.2}};
    fitted.C_iso = Array1D{{1e-25, 1e-27}};
    fitted.log_C_iso_standard_error = Array1D{{0.3, 0.4}};
    surface.fitted = fitted;
    surface.likelihood = surface.average;
    result.surfaces = {surface};
    const auto one = study_figure(result, "1"), isotropic = study_figure(result, "S3");
    EXPECT_NEAR(std::log(series_of(one.figure.panels[0], "fitted, 95 %").upper[1] / 1e-21), 1.959964 * 0.2, 1e-6);
    EXPECT_NEAR(std::log(series_of(isotropic.figure.panels[0], "fitted, 95 %").lower[0] / 1e-25), -1.959964 * 0.3,
                1e-6);
}

TEST(FigureS3, ConvertsAveragesByTheConversionOfTheStudy) {
    auto result = study_of_pairs();
    result.study.analysis.conversion = roughness::Conversion::eq11;
    const auto by_11 = series_of(study_figure(result, "S3").figure.panels[0], "rough");
    // π C1D/(q √(1 − (q/q_s)²))
    EXPECT_NEAR(by_11.y[0] / (pi * 1e-20 / 1e5), 1.0, 1e-6);
    ASSERT_EQ(by_11.x.size(), 3);  // q_s itself has none
    result.study.analysis.conversion = roughness::Conversion::exact;
    const auto exact = series_of(study_figure(result, "S3").figure.panels[0], "rough");
    EXPECT_GT(std::abs(exact.y[0] / by_11.y[0] - 1.0), 0.05);
}

TEST(FigureS2, AveragesEachInstrumentWithinItsBand) {
    const auto drawn = study_figure(measured_study(), "S2");
    const auto& afm = series_of(drawn.figure.panels[0], "rough, AFM");
    EXPECT_GE(afm.x[0], 1.9e6);
    EXPECT_LE(afm.x[afm.x.size() - 1], 5.7e8);
    // both measurements are the same power law; bins are ten a decade
    for (Index i = 2; i + 2 < afm.x.size(); ++i) EXPECT_NEAR(afm.y[i] * std::pow(afm.x[i], 3.0) / 1e-6, 1.0, 0.02) << i;
    const auto& stylus = series_of(drawn.figure.panels[0], "rough, stylus");
    EXPECT_NEAR(stylus.y[3], 1e-20, 1e-24);
    EXPECT_NE(afm.dash, stylus.dash);
    EXPECT_NE(afm.colour, stylus.colour);
}

TEST(FigureS1, ShowsTheLongestScanWithItsPeaks) {
    auto result = measured_study();
    result.surfaces[0].measurements.push_back(result.surfaces[0].measurements.back());
    result.surfaces[0].measurements.back().name = "short";
    result.surfaces[0].measurements.back().preview.size = {1e-4, 0.0};
    const auto drawn = study_figure(result, "S1");
    ASSERT_EQ(drawn.figure.panels.size(), 1u);
    const auto& scan = drawn.figure.panels[0].series[0];
    EXPECT_EQ(scan.label, "scan");
    EXPECT_LE(scan.x.size(), 400);
    EXPECT_DOUBLE_EQ(scan.y.maxCoeff(), 50.0);  // nm
    EXPECT_TRUE((scan.x.tail(scan.x.size() - 1) >= scan.x.head(scan.x.size() - 1)).all());
}

TEST(MeasuredSpectra, ShowEveryMeasurementAndExcludedWaves) {
    auto result = measured_study();
    study::MeasurementResult failed{.name = "gone", .error = "unreadable"};
    result.surfaces[0].measurements.push_back(failed);
    const auto drawn = study_figure(result, "spectra:rough");
    const auto& panel = drawn.figure.panels[0];
    const auto& kept = series_of(panel, "first");
    EXPECT_GE(kept.x[0], 2e6 * (1.0 - 1e-12));
    EXPECT_LE(kept.x[kept.x.size() - 1], 5e8 * (1.0 + 1e-12));
    EXPECT_LE(kept.x.size(), 150);
    EXPECT_EQ(kept.names.size(), static_cast<std::size_t>(kept.x.size()));
    EXPECT_EQ(kept.names[0], "first");
    EXPECT_EQ(kept.dash, 0);
    const auto& cut = series_of(panel, "first, cut");
    EXPECT_NE(cut.dash, 0);
    EXPECT_LT(cut.opacity, kept.opacity);
    EXPECT_NE(series_of(panel, "scan").colour, kept.colour);
    EXPECT_EQ(series_of(panel, "second").colour, kept.colour);
    EXPECT_NE(drawn.caption.find("one measurement failed"), std::string::npos) << drawn.caption;
    result.surfaces[0].measurements = {failed};
    EXPECT_EQ(study_figure(result, "spectra:rough").reason, "every measurement of the surface failed");
}

TEST(MeasuredSpectra, OfSixtyMeasurementsStaySmall) {
    auto result = measured_study();
    const auto one = result.surfaces[0].measurements[0];
    result.surfaces[0].measurements.assign(60, one);
    std::size_t points = 0;
    const auto drawn = study_figure(result, "spectra:rough");
    for (const auto& series : drawn.figure.panels[0].series) points += static_cast<std::size_t>(series.x.size());
    EXPECT_LE(points, 60u * 3u * 150u);
    EXPECT_GE(points, 60u * 50u);
}

}  // namespace
}  // namespace setae::study_figures::spectra_figures_test
