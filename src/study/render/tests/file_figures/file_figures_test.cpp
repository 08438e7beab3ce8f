// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include <algorithm>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/file_figures/comparison_figure.hpp"
#include "setae/file_figures/contact_map_figure.hpp"
#include "setae/file_figures/contour_figure.hpp"
#include "setae/file_figures/level_figure.hpp"
#include "setae/file_figures/parameter_figure.hpp"
#include "setae/file_figures/persson_figure.hpp"
#include "setae/file_figures/predicted_loop_figure.hpp"
#include "setae/file_figures/scale_figure.hpp"
#include "setae/file_figures/spectrum_figure.hpp"

namespace setae::file_figures::file_figures_test {
namespace {

const figures::Series& series_of(const figures::Panel& panel, const std::string& label) {
    for (const auto& series : panel.series)
        if (series.label == label) return series;
    throw std::runtime_error("no series '" + label + "'");
}

/// A surface whose C1D is 1e-6 q^-3 from 1e5 to 1e8 1/m, of one measurement that shows it to 1e7 1/m.
study::SurfaceResult power_law() {
    study::SurfaceResult surface{.name = "surface"};
    const Array1D q = Array1D::LinSpaced(400, std::log(1e5), std::log(1e8)).exp();
    surface.average.curve = {q, 1e-6 * q.pow(-3.0), {1e5, 1e8}, spectra::Density::C1D};
    study::MeasurementResult measurement{.file = "folder/map.ibw", .name = "map"};
    measurement.spectrum.wavevector = q;
    measurement.spectrum.density = 1e-6 * q.pow(-3.0);
    measurement.spectrum.standard_error = Array1D::Constant(q.size(), undefined);
    measurement.spectrum.count = Array1D::Ones(q.size());
    measurement.spectrum.band = {1e5, 1e7};
    surface.measurements.push_back(measurement);
    return surface;
}

Table table_of(const study::SurfaceResult& surface) {
    const auto& curve = surface.average.curve;
    return {{{"wavevector", "1/m", curve.wavevector},
             {"C1D", "m3", curve.density},
             {"standard_error", "m3", 0.1 * curve.density}},
            {}};
}

TEST(SpectrumFigure, ShowsWhichWavesAreKeptAndExcluded) {
    const auto surface = power_law();
    const auto drawn = spectrum_figure(surface, table_of(surface), {});
    ASSERT_TRUE(drawn.drawable()) << drawn.reason;
    EXPECT_EQ(drawn.title, "Power spectral density of map.ibw");
    ASSERT_EQ(drawn.figure.panels.size(), 1U);
    EXPECT_LE(series_of(drawn.figure.panels[0], "map").x.maxCoeff(), 1e7);
    EXPECT_GE(series_of(drawn.figure.panels[0], "map, cut").x.minCoeff(), 1e7);
    EXPECT_EQ(drawn.figure.width_mm, 85.0);
    // no average hides the one measurement; its errors are shaded
    EXPECT_THROW((void)series_of(drawn.figure.panels[0], "average"), std::runtime_error);
    const auto& errors = series_of(drawn.figure.panels[0], "one standard error");
    EXPECT_NEAR(errors.upper[7] / errors.lower[7], 1.1 / 0.9, 1e-9);
}

TEST(SpectrumFigure, DrawsTheFitInsideAndOutsideItsRange) {
    const auto surface = power_law();
    auto table = table_of(surface);
    const Array1D q = table.at("wavevector");
    table.columns.push_back({"C1D_model", "m3", 1e-6 * q.pow(-3.0)});
    table.columns.push_back({"extrapolated", "1", (q > 1e7).cast<double>()});
    const auto drawn = spectrum_figure(surface, table, {});
    const auto& inside = series_of(drawn.figure.panels[0], "self-affine fit");
    const auto& outside = series_of(drawn.figure.panels[0], "self-affine fit, outside its range");
    for (Index i = 0; i < inside.x.size(); ++i) {
        EXPECT_EQ(std::isnan(inside.y[i]), inside.x[i] > 1e7);
        EXPECT_EQ(std::isnan(outside.y[i]), inside.x[i] <= 1e7);
    }
}

TEST(SpectrumFigure, HasASeparatePanelForCIso) {
    const auto surface = power_law();
    auto table = table_of(surface);
    table.columns.push_back({"C_iso", "m4", table.at("C1D") / table.at("wavevector")});
    const auto narrow = spectrum_figure(surface, table, {});
    ASSERT_EQ(narrow.figure.panels.size(), 2U);
    EXPECT_EQ(narrow.figure.columns, 1);
    EXPECT_LE(narrow.figure.height_mm, 120.0);
    EXPECT_EQ(narrow.figure.panels[1].y.unit, "m4");
    EXPECT_EQ(spectrum_figure(surface, table, {.width = FigureWidth::double_column}).figure.columns, 2);
}

TEST(SpectrumFigure, OfATableShowsItsStandardErrors) {
    auto surface = power_law();
    const auto table = table_of(surface);
    surface.measurements.clear();
    const auto drawn = spectrum_figure(surface, table, {});
    const auto& given = series_of(drawn.figure.panels[0], "C1D");
    EXPECT_DOUBLE_EQ(given.upper[3], 1.1 * given.y[3]);
}

scales::FunctionOfScale linear(const std::string& file, double reliable_from) {
    scales::FunctionOfScale f;
    f.quantity = "autocorrelation";
    f.unit = "m2";
    f.distance = Array1D::LinSpaced(100, 1e-8, 1e-6);
    f.value = 4e-12 * f.distance;
    f.standard_error = Array1D::Constant(100, undefined);
    f.count = Array1D::Ones(100);
    f.reliable_from = reliable_from;
    f.metadata.file = file;
    return f;
}

TEST(ScaleFigure, DistinguishesReliableValues) {
    const auto drawn = scale_figure({linear("folder/a.csv", 1e-7)}, nullptr, {});
    const auto& panel = drawn.figure.panels[0];
    EXPECT_EQ(panel.x.unit, "µm");
    EXPECT_EQ(panel.y.unit, "nm2");
    EXPECT_TRUE(panel.y.logarithmic);
    EXPECT_GE(series_of(panel, "a.csv").x.minCoeff(), 0.1 * (1.0 - 1e-6));
    EXPECT_LT(series_of(panel, "a.csv, not reliable").x.maxCoeff(), 0.1);
    EXPECT_NEAR(series_of(panel, "a.csv").y[0], 0.4, 0.01);
}

TEST(ScaleFigure, OfSeveralShowsTheirMeanWithItsError) {
    auto second = linear("b.csv", 0.0);
    second.value *= 3.0;
    const std::vector<scales::FunctionOfScale> functions{linear("a.csv", 0.0), second};
    const auto combined = scales::combine(functions);
    const auto drawn = scale_figure(functions, &combined, {});
    const auto& mean = series_of(drawn.figure.panels[0], "mean");
    EXPECT_GT(mean.upper[0], mean.y[0]);
    EXPECT_EQ(drawn.title, "autocorrelation of 2 measurements");
}

TEST(ScaleFigure, OfValuesBelowZeroIsNotLogarithmic) {
    auto f = linear("a.csv", 0.0);
    f.value[4] = -1e-20;
    EXPECT_FALSE(scale_figure({f}, nullptr, {}).figure.panels[0].y.logarithmic);
}

TEST(LevelFigure, ShowsMapsFromTheirMeanAndUndefinedPoints) {
    topography::HeightMap map{.heights = Array2D::Constant(8, 8, 5e-6), .size = {8e-6, 8e-6}};
    map.heights(3, 4) = undefined;
    map.heights(0, 0) += 64e-9;
    processing::PipelineResult after{map, {}};
    const auto drawn = level_figure(map, after, {});
    ASSERT_EQ(drawn.figure.panels.size(), 2U);
    const auto& panel = drawn.figure.panels[0];
    EXPECT_EQ(panel.title, "before, 1.6 % undefined (white)");
    ASSERT_TRUE(panel.map);
    EXPECT_EQ(panel.map->values_axis.unit, "nm");
    EXPECT_NEAR(panel.map->values(0, 0), 64.0 - 64.0 / 63.0, 1e-6);
    EXPECT_TRUE(std::isnan(panel.map->values(3, 4)));
    EXPECT_EQ(panel.map->width, 8.0);
}

TEST(LevelFigure, ShowsLinesOverTheirLength) {
    topography::LineScan scan{.heights = Array1D::LinSpaced(50, 0.0, 1e-8), .size = 1e-3};
    const auto drawn = level_figure(scan, {scan, {}}, {.width = FigureWidth::double_column});
    EXPECT_EQ(drawn.figure.columns, 2);
    EXPECT_EQ(drawn.figure.panels[0].y.unit, "nm");
    EXPECT_FALSE(drawn.figure.panels[0].map);
}

TEST(ContactMapFigure, ShowsPressureAndGapOfEveryState) {
    Array2D pressures = Array2D::Zero(300, 200), gaps = Array2D::Constant(300, 200, 5e-9);
    pressures.topRows(30) = 2e6;
    pressures(200, 100) = 1e9;  // one point does not set the colours
    const std::array size{3e-6, 2e-6};
    const auto one = contact_map_figure({{"", pressures, gaps}}, size, "a/map.npy", {});
    ASSERT_EQ(one.figure.panels.size(), 2u);
    const auto& map = one.figure.panels[0].map.value();
    EXPECT_EQ(map.values_axis.unit, "MPa");
    EXPECT_EQ(map.values_axis.to, 2.0);
    EXPECT_EQ(map.width, 3.0);
    EXPECT_NEAR(*one.figure.panels[1].map->values_axis.from, 5.0, 1e-12);  // nm, all alike
    EXPECT_GT(*one.figure.panels[1].map->values_axis.to, 5.0);
    const auto several =
        contact_map_figure({{"turn", pressures, gaps}, {"greatest tension", pressures, gaps}}, size, "map.npy", {});
    ASSERT_EQ(several.figure.panels.size(), 4u);
    EXPECT_EQ(several.figure.panels[3].shows, "greatest tension");
    EXPECT_EQ(several.figure.columns, 2);
    EXPECT_THROW((void)contact_map_figure({}, size, "map.npy", {}), InvalidArgument);
}

TEST(ContactMapFigure, OfALineIsDrawnAlongIt) {
    const Array2D pressures = Array2D::Constant(1, 50, 1e3), gaps = Array2D::Zero(1, 50);
    const auto drawn = contact_map_figure({{"", pressures, gaps}}, {1.0, 5e-6}, "line.txt", {});
    ASSERT_EQ(drawn.figure.panels.size(), 2u);
    EXPECT_FALSE(drawn.figure.panels[0].map);
    EXPECT_NEAR(drawn.figure.panels[0].series.at(0).x[49], 4.9, 1e-12);
}

TEST(ParameterFigure, ShowsThatSlopeDependsOnShorterWavesThanHeight) {
    const auto drawn = parameter_figure(power_law(), {});
    const auto& panel = drawn.figure.panels[0];
    const auto &height = series_of(panel, "mean square height"), &slope = series_of(panel, "mean square slope");
    const auto last = height.x.size() - 1;
    EXPECT_NEAR(height.y[last], 100.0, 1e-9);
    EXPECT_NEAR(slope.y[last], 100.0, 1e-9);
    EXPECT_NEAR(height.x[last], 2.0 * pi / 1e8 / (panel.x.unit == "nm" ? 1e-9 : 1e-6), 1e-6);
    // of C1D ~ q^-3 half of the decades carry nearly all of the height, and half of the slope
    const Index middle = last / 2;
    EXPECT_GT(height.y[middle], 95.0);
    EXPECT_LT(slope.y[middle], 70.0);
}

TEST(ParameterFigure, DrawsTheSharesBetweenTwoRowsOfATable) {
    auto few = power_law();
    Array1D q(2), density(2);
    q << 1e5, 1e8;
    density << 1e-6 * std::pow(1e5, -3.0), 1e-6 * std::pow(1e8, -3.0);
    few.average.curve = {q, density, {1e5, 1e8}, spectra::Density::C1D};
    const auto many_rows = parameter_figure(power_law(), {}), two_rows = parameter_figure(few, {});
    const auto &many = series_of(many_rows.figure.panels[0], "mean square slope"),
               &two = series_of(two_rows.figure.panels[0], "mean square slope");
    ASSERT_GT(two.x.size(), 100);
    const auto share_near = [](const figures::Series& series, double wavelength) {
        Index nearest = 0;
        (series.x - wavelength).abs().minCoeff(&nearest);
        return series.y[nearest];
    };
    for (Index i = 10; i < two.x.size(); i += 20) EXPECT_NEAR(two.y[i], share_near(many, two.x[i]), 2.0);
}

TEST(ParameterFigure, HasItsLegendAboveTheCurves) {
    EXPECT_TRUE(parameter_figure(power_law(), {}).figure.panels[0].legend_place);
}

TEST(ContourFigure, ShadesNinetyFivePercentOfHeights) {
    study::TracedPicture picture;
    picture.micrograph.file = "folder/tem.dm3";
    study::ContourProfile profile;
    profile.levelled.profile.positions = Array1D::LinSpaced(20, 1e-9, 21e-9);
    profile.levelled.profile.heights = 1e-9 * profile.levelled.profile.positions * 1e9;
    profile.levelled.profile.standard_error = Array1D::Constant(20, 1e-10);
    picture.profiles.push_back(profile);
    const auto drawn = contour_figure(picture, {0}, study::ContourShape::envelope, {});
    const auto& band = series_of(drawn.figure.panels[0], "95 %");
    EXPECT_NEAR(band.upper[0] - band.lower[0], 2.0 * 1.96 * 0.1, 1e-3);
    EXPECT_EQ(drawn.title, "Contour of tem.dm3");
    EXPECT_EQ(drawn.figure.panels[0].x.unit, "nm");
}

TEST(FigurePath, IsRecognisedByItsEnding) {
    EXPECT_TRUE(is_figure_path("a.b/c.svg"));
    EXPECT_TRUE(is_figure_path("c.png"));
    EXPECT_FALSE(is_figure_path("c.svg.csv"));
    EXPECT_FALSE(is_figure_path("svg"));
}

TEST(WriteFigure, GivesTheReasonForAMissingFigure) {
    StudyFigure none;
    none.reason = "it has no data";
    try {
        write_figure(none, "a.svg");
        FAIL() << "written";
    } catch (const UndefinedDataError& error) {
        EXPECT_NE(std::string(error.what()).find("it has no data"), std::string::npos);
    }
    EXPECT_THROW(write_figure({}, "a.eps"), InvalidArgument);
}

TEST(PerssonFigure, UsesTheVariableOfItsTableAsAbscissa) {
    Table load;
    load.columns = {{"pressure", "Pa", Array1D{{1e5, 1e6, 1e7}}},
                    {"area_fraction", "1", Array1D{{0.01, 0.1, 0.7}}},
                    {"mean_gap", "m", Array1D{{3e-8, 2e-8, 1e-9}}}};
    const auto plain = persson_figure(load, "folder/spectrum.csv", {});
    EXPECT_EQ(plain.title, "Contact of spectrum.csv against load");
    ASSERT_EQ(plain.figure.panels.size(), 2U);
    EXPECT_EQ(plain.figure.panels[0].x.unit, "MPa");
    EXPECT_EQ(plain.figure.panels[0].series.size(), 1U);
    EXPECT_DOUBLE_EQ(plain.figure.panels[1].series[0].y[0], 30.0);
    // under tension there is no contact without adhesion, and the axis of pressures is linear
    load.columns[0].values = Array1D{{-1e5, 1e5, 1e6}};
    load.columns[2].values[0] = undefined;
    load.columns.push_back({"adhesive_area_fraction", "1", Array1D{{0.5, 0.6, 0.9}}});
    const auto adhesive = persson_figure(load, "spectrum.csv", {});
    EXPECT_FALSE(adhesive.figure.panels[0].x.logarithmic);
    EXPECT_EQ(series_of(adhesive.figure.panels[0], "with adhesion").y[2], 0.9);
    Table scales;
    scales.columns = {{"wavevector", "1/m", Array1D{{1e6, 1e8}}},
                      {"area_fraction", "1", Array1D{{1.0, 0.1}}},
                      {"mean_gap", "m", Array1D{{0.0, 1e-8}}}};
    EXPECT_EQ(persson_figure(scales, "s.csv", {}).title, "Contact of s.csv against the included waves");
}

TEST(ComparisonFigure, ShowsSolutionsWithErrorsAndTheory) {
    Table load;
    load.columns.push_back({"pressure", "Pa", Array1D{{1e6, 1e7, 1e8}}});
    for (const auto& [name, unit] : {std::pair{"area_fraction", "1"},
                                     {"mean_gap", "m"},
                                     {"contact_stiffness", "Pa/m"},
                                     {"stored_energy", "J/m2"}}) {
        load.columns.push_back({name, unit, Array1D{{2e-2, 2e-1, 1.0}}});
        load.columns.push_back({name + std::string("_standard_error"), unit, Array1D{{1e-3, 1e-2, undefined}}});
        load.columns.push_back({name + std::string("_persson"), unit, Array1D{{1.6e-2, 1.7e-1, 1.0}}});
    }
    load.columns[7].values[2] = std::numeric_limits<double>::infinity();  // a full contact does not give way
    const auto narrow = comparison_figure(load, "folder/spectrum.csv", {});
    EXPECT_EQ(narrow.title, "Contact of spectrum.csv: solved, and Persson's theory");
    EXPECT_EQ(narrow.figure.panels.size(), 2U);
    EXPECT_LE(narrow.figure.height_mm, 120.0);
    const auto wide = comparison_figure(load, "spectrum.csv", {.width = FigureWidth::double_column});
    ASSERT_EQ(wide.figure.panels.size(), 4U);
    const auto& area = series_of(wide.figure.panels[0], "solved");
    EXPECT_DOUBLE_EQ(area.upper[0] - area.lower[0], 2e-3);
    EXPECT_DOUBLE_EQ(area.upper[2], 1.0);
    EXPECT_TRUE(std::isnan(series_of(wide.figure.panels[2], "Persson's theory").y[2]));
    EXPECT_EQ(wide.figure.panels[3].y.unit, "J/m2");
}

TEST(PredictedLoopFigure, HasItsPanelsOrAReason) {
    const auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    const auto& h = *result.hysteresis;
    const auto loop = predicted_loop_figure(h.pairs.front(), result, {});
    ASSERT_TRUE(loop.drawable()) << loop.reason;
    EXPECT_EQ(loop.figure.panels.size(), 3U);
    const double unit = loop.figure.panels[0].y.unit == "mN" ? 1e-3 : 1e-6;  // 1 mN is where one ends
    EXPECT_NEAR(series_of(loop.figure.panels[0], "predicted, crack_tip_pinning").y.maxCoeff() * unit, 1e-3, 1e-12);
    // a contact that is partial has a loop, too, where anything of W_app is left
    for (const auto& pair : h.pairs) {
        if (pair.work_approach.value > 0.0) EXPECT_TRUE(predicted_loop_figure(pair, result, {}).drawable());
    }
    auto unknown = h.pairs.back();
    unknown.loop = study::Outcome<hysteresis::PredictedRetraction>::missing("elastomer E10 has no preload");
    EXPECT_EQ(predicted_loop_figure(unknown, result, {}).reason, unknown.loop.reason);
}

TEST(PredictedLoopFigure, LabelsItsRecordsOnce) {
    auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    const auto& pair = result.hysteresis->pairs.front();
    study::ExperimentResult record;
    record.input.surface = pair.surface;
    record.input.elastomer = pair.elastomer;
    record.analysis.emplace();
    record.analysis->corrected = {.force = Array1D::LinSpaced(5, 0.0, 1e-3),
                                  .displacement = Array1D::LinSpaced(5, 0.0, 1e-6)};
    result.experiments = {record, record};
    const auto figure = predicted_loop_figure(pair, result, {});
    const auto& series = figure.figure.panels[0].series;
    EXPECT_EQ(std::ranges::count_if(series, [](const auto& one) { return one.label == "measured" && one.in_legend; }),
              1);
    EXPECT_NE(figure.caption.find("2 records"), std::string::npos);
}

// the force is then that of the measured contact area
TEST(PredictedLoopFigure, WithoutPreloadUsesTheForceOfTheMeasuredContact) {
    auto result = study::run_study(study::read_study("examples/nanodiamond/published.toml"));
    for (auto& elastomer : result.elastomers) elastomer.input.preload.reset();
    result.pairs.front().contact_area = 1e-7;
    const auto h = study::hysteresis_of(result);
    const auto& pair = h.pairs.front();
    ASSERT_TRUE(pair.loop) << pair.loop.reason;
    ASSERT_GT(pair.loop->pressing.maximum_force, 0.0);
    const auto figure = predicted_loop_figure(pair, result, {});
    const double unit = figure.figure.panels[0].y.unit == "mN" ? 1e-3 : 1e-6;
    EXPECT_NEAR(series_of(figure.figure.panels[0], "predicted, crack_tip_pinning").y.maxCoeff() * unit,
                pair.loop->pressing.maximum_force, 1e-12);
}

}  // namespace
}  // namespace setae::file_figures::file_figures_test
