// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "setae/answers/adhesion.hpp"
#include "setae/answers/comparison_fields.hpp"
#include "setae/answers/diagnosis.hpp"
#include "setae/answers/parameters.hpp"
#include "setae/answers/power_spectrum_fields.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"

namespace setae::answers::answers_test {
namespace {

constexpr double amplitude = 3e-9, length = 2e-6;
constexpr Index points = 512, periods = 8;

/// A wave in memory, which no file holds.
study::MeasurementInput wave(const std::string& name) {
    topography::LineScan scan{.heights = Array1D(points), .size = length};
    for (Index i = 0; i < points; ++i)
        scan.heights[i] = amplitude * std::cos(2.0 * pi * periods * static_cast<double>(i) / points);
    auto input = MeasurementRequest{}.input(name);
    input.trend = topography::Trend::mean;
    input.in_memory.read = [scan] { return topography::Measurement(scan); };
    return input;
}

study::SurfaceInput surface_of(std::vector<study::MeasurementInput> measurements) {
    return {.name = "surface", .measurements = std::move(measurements)};
}

TEST(PowerSpectrum, OfAWaveInMemoryMatchesTheClosedForm) {
    AnalysisRequest analysis;
    analysis.window = "none";
    const auto answer = power_spectrum({.surface = surface_of({wave("wave")}), .analysis = analysis.analysis()});
    const auto& density = answer.table.at("C1D");
    EXPECT_NEAR(density.maxCoeff(), amplitude * amplitude * length / 4.0, 1e-12 * amplitude * amplitude * length);
    const auto json = output::described(answer);
    EXPECT_EQ(json["measurements"][0]["file"], "wave");
    EXPECT_EQ(json["units"]["C1D"], "m3");
}

TEST(PowerSpectrum, SkipsAFailedMeasurementOrThrows) {
    auto bad = wave("bad");
    bad.in_memory.read = []() -> topography::Measurement { throw FormatError("bad", {}, "torn"); };
    PowerSpectrumRequest request{.surface = surface_of({wave("wave"), bad}), .analysis = AnalysisRequest{}.analysis()};
    const auto answer = power_spectrum(request);
    EXPECT_EQ(output::described(answer)["measurements"].size(), 1U);
    request.every_measurement = true;
    EXPECT_THROW((void)power_spectrum(request), FormatError);
}

TEST(Parameters, OnlyAHeightNeedsNoSpectrum) {
    ParametersRequest request{surface_of({wave("wave")}), AnalysisRequest{}.analysis(), true, {"Rq"}};
    const auto only = parameters(request);
    EXPECT_EQ(only.surface.measurements[0].spectrum.independent_lines.size(), 0);
    const auto entries = parameter_entries(only);
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_NEAR(entries[0].quantity.estimate.value, amplitude / std::sqrt(2.0), 1e-12 * amplitude);
    request.only = {};
    const auto all = parameter_entries(parameters(request));
    EXPECT_EQ(output::described(entries)[0], output::described(all)[0]);
    request.only = {"rms_slope_from_spectrum", "rms_height"};
    EXPECT_EQ(parameter_entries(parameters(request)).size(), 2U);
    request.only = {"Sq"};
    EXPECT_THROW((void)parameters(request), InvalidArgument);
}

TEST(Parameters, OnlyAHeightOfAFailedMeasurementIsAFailure) {
    auto bad = wave("bad");
    bad.in_memory.read = []() -> topography::Measurement { throw FormatError("bad", {}, "torn"); };
    ParametersRequest request{surface_of({bad}), AnalysisRequest{}.analysis(), false, {"Rq"}};
    EXPECT_TRUE(parameters(request).surface.failed());
    request.surface = surface_of({wave("wave"), bad});
    EXPECT_EQ(parameter_entries(parameters(request)).size(), 1U);
}

TEST(AnalysisRequest, RefusesUnknownValues) {
    EXPECT_THROW((void)AnalysisRequest{.contours = "lines"}.analysis(), InvalidArgument);
    EXPECT_THROW((void)AnalysisRequest{.conversion = "none"}.analysis(), InvalidArgument);
    EXPECT_THROW((void)AnalysisRequest{.longest = "5 kg"}.analysis(), InvalidArgument);
    EXPECT_THROW((void)AnalysisRequest{.memory = 0.0}.analysis(), InvalidArgument);
    EXPECT_THROW((void)MeasurementRequest{.instrument = "camera"}.input("a"), InvalidArgument);
}

TEST(AdhesionRequest, RequiresThreeQuantitiesAndBothOrNoneOfASphere) {
    const AdhesionRequest whole{.youngs_modulus = "1 MPa", .work = "37 mJ/m2", .surface_energy = "25 mJ/m2"};
    EXPECT_EQ(whole.study({}).elastomers.size(), 1U);
    auto without_work = whole;
    without_work.work.clear();
    EXPECT_THROW((void)without_work.study({}), InvalidArgument);
    auto without_preload = whole;
    without_preload.radius = "1 mm";
    EXPECT_THROW((void)without_preload.study({}), InvalidArgument);
}

TEST(AdhesionRequest, RefusesAPoissonRatioAboveOneHalf) {
    const AdhesionRequest solids{
        .youngs_modulus = "1 MPa", .work = "37 mJ/m2", .surface_energy = "25 mJ/m2", .poisson_ratio = 0.7};
    EXPECT_THROW((void)solids.study({}), InvalidArgument);
}

TEST(Diagnosis, AcceptsATipWithItsStandardError) {
    const std::vector<Suspect> suspects{{"wave", [] { return std::vector{wave("wave").in_memory.read()}; }}};
    EXPECT_TRUE(diagnosis(suspects, {"10 ± 2 nm"}).failures.empty());
    EXPECT_THROW((void)diagnosis(suspects, {"-10 nm"}), InvalidArgument);
}

/// C_iso = 1e-4 q^-3.6 between waves of 1 um and 125 nm, by its table.
study::SurfaceResult self_affine_surface() {
    study::SurfaceResult surface{.name = "surface"};
    const Array1D q = Array1D::LinSpaced(20, std::log(2e6 * pi), std::log(16e6 * pi)).exp();
    surface.average.curve = {q, 1e-4 * q.pow(-3.6), {q[0], q[19]}, spectra::Density::C_iso};
    return surface;
}

ComparisonRequest comparison(const std::string& pressure) {
    ComparisonRequest request;
    request.theory.contact_modulus = "1 GPa";
    request.theory.pressure = pressure;
    request.pixels = "96";
    request.surfaces = 3;
    return request;
}

TEST(ContactComparison, TheoryAndSolutionsAgreeInFullContact) {
    const auto found = compare_contact(self_affine_surface(), comparison("100 GPa"));
    const auto& load = found.load;
    EXPECT_EQ(load.at("area_fraction")[0], 1.0);
    EXPECT_NEAR(load.at("area_fraction_persson")[0], 1.0, 1e-9);
    EXPECT_NEAR(load.at("mean_gap")[0], 0.0, 1e-15);
    const double stored = load.at("stored_energy")[0];
    EXPECT_NEAR(load.at("stored_energy_persson")[0] / stored, 1.0, 1e-6);
    // sums over the cell's modes against integrals
    EXPECT_NEAR(found.made.rms_slope / found.rms_slope, 1.0, 0.03);
    EXPECT_LT(load.at("stored_energy_standard_error")[0], 1e-6 * stored) << "surfaces differ by places of waves alone";
}

TEST(ContactComparison, TheoryUnderestimatesAreaByAFifthAtLowLoad) {
    const auto surface = self_affine_surface();
    const auto found = compare_contact(surface, comparison("5 MPa,20 MPa"));
    const double slope = found.made.rms_slope;
    for (Index p = 0; p < 2; ++p) {
        const double pressure = found.load.at("pressure")[p];
        const double theory = found.load.at("area_fraction_persson")[p], solved = found.load.at("area_fraction")[p];
        EXPECT_NEAR(theory, std::erf(std::sqrt(2.0) * pressure / (1e9 * slope)), 1e-4 * theory);
        EXPECT_NEAR(theory / solved, 0.8, 0.1);
        EXPECT_LT(found.load.at("area_fraction_standard_error")[p], 0.1 * solved);
    }
    auto other = comparison("5 MPa");
    other.seed = 3;
    EXPECT_NE(compare_contact(surface, other).load.at("mean_gap")[0], found.load.at("mean_gap")[0]);
    EXPECT_EQ(output::described(found)["surfaces"], 3);
}

TEST(ContactComparison, RefusesGridsThatDoNotFitTheSurface) {
    const auto surface = self_affine_surface();
    auto request = comparison("5 MPa");
    for (const char* pixels : {"32", "0", "-96", "100000000", "96x1"}) {
        request.pixels = pixels;
        EXPECT_THROW((void)compare_contact(surface, request), InvalidArgument) << pixels;
    }
    request = comparison("5 MPa");
    request.cell = "0.5 um";
    EXPECT_THROW((void)compare_contact(surface, request), InvalidArgument);
    EXPECT_THROW((void)compare_contact(surface, comparison("-5 MPa")), InvalidArgument);
    EXPECT_THROW((void)compare_contact(surface, comparison("")), InvalidArgument);
    request = comparison("5 MPa");
    request.surfaces = 0;
    EXPECT_THROW((void)compare_contact(surface, request), InvalidArgument);
}

TEST(Lengths, AreOneOrTwo) {
    EXPECT_EQ(lengths_of("2 m x 3 m"), (std::vector{2.0, 3.0}));
    EXPECT_EQ(lengths_of("1 m"), std::vector{1.0});
    EXPECT_THROW((void)lengths_of("1 m x 1 m x 1 m"), InvalidArgument);
}

}  // namespace
}  // namespace setae::answers::answers_test
