// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "setae/answers/adhesion.hpp"
#include "setae/answers/power_spectrum.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

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

TEST(PowerSpectrum, OfAWaveInMemoryHasItsClosedForm) {
    AnalysisRequest analysis;
    analysis.window = "none";
    const auto answer = power_spectrum({.surface = surface_of({wave("wave")}), .analysis = analysis.analysis()});
    const auto& density = answer.table.at("C1D");
    EXPECT_NEAR(density.maxCoeff(), amplitude * amplitude * length / 4.0, 1e-12 * amplitude * amplitude * length);
    const auto json = to_json(answer);
    EXPECT_EQ(json["measurements"][0]["file"], "wave");
    EXPECT_EQ(json["units"]["C1D"], "m3");
}

TEST(PowerSpectrum, WithoutAFailedMeasurementOrItsFailure) {
    auto bad = wave("bad");
    bad.in_memory.read = []() -> topography::Measurement { throw FormatError("bad", {}, "torn"); };
    PowerSpectrumRequest request{.surface = surface_of({wave("wave"), bad}), .analysis = AnalysisRequest{}.analysis()};
    const auto answer = power_spectrum(request);
    EXPECT_EQ(to_json(answer)["measurements"].size(), 1U);
    request.every_measurement = true;
    EXPECT_THROW((void)power_spectrum(request), FormatError);
}

TEST(AnalysisRequest, RefusesWhatItDoesNotKnow) {
    EXPECT_THROW((void)AnalysisRequest{.contours = "lines"}.analysis(), InvalidArgument);
    EXPECT_THROW((void)AnalysisRequest{.conversion = "none"}.analysis(), InvalidArgument);
    EXPECT_THROW((void)AnalysisRequest{.longest = "5 kg"}.analysis(), InvalidArgument);
    EXPECT_THROW((void)AnalysisRequest{.memory = 0.0}.analysis(), InvalidArgument);
    EXPECT_THROW((void)MeasurementRequest{.instrument = "camera"}.input("a"), InvalidArgument);
}

TEST(AdhesionRequest, NeedsItsThreeNumbersAndBothOfASphere) {
    const AdhesionRequest whole{.youngs_modulus = "1 MPa", .work = "37 mJ/m2", .surface_energy = "25 mJ/m2"};
    EXPECT_EQ(whole.study({}).elastomers.size(), 1U);
    auto without_work = whole;
    without_work.work.clear();
    EXPECT_THROW((void)without_work.study({}), InvalidArgument);
    auto without_preload = whole;
    without_preload.radius = "1 mm";
    EXPECT_THROW((void)without_preload.study({}), InvalidArgument);
}

TEST(Lengths, AreOneOrTwo) {
    EXPECT_EQ(lengths_of("2 m x 3 m"), (std::vector{2.0, 3.0}));
    EXPECT_EQ(lengths_of("1 m"), std::vector{1.0});
    EXPECT_THROW((void)lengths_of("1 m x 1 m x 1 m"), InvalidArgument);
}

}  // namespace
}  // namespace setae::answers::answers_test
