// SPDX-License-Identifier: GPL-3.0-or-later
// Tips and calibrations shared by measurements: derivatives of results against analyses of changed data.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "sample_files.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/container.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/study/study.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::study::instrument_inputs_test {
namespace {

using roughness::SpectralParameters;
using setae::tests::TemporaryFolder;
using Function = roughness::ParameterSpread::Function;

constexpr double shortest = 40e-9, pixel = 0.5 * shortest;
constexpr Index fine = 256, points = fine / 2;
constexpr double error = 0.004;  // that factors are known to

const Function h_rms = [](const SpectralParameters& p) { return p.rms_height; };
const Function slope = [](const SpectralParameters& p) { return p.rms_slope; };
const Function energy = [](const SpectralParameters& p) { return p.elastic_energy_per_modulus; };
const Function area = [](const SpectralParameters& p) { return p.area_ratio(); };

SurfaceInput maps(const TemporaryFolder& folder, const std::string& name, std::uint64_t first_seed) {
    SurfaceInput surface;
    surface.name = name;
    const auto C_iso = spectra::density(spectra::SelfAffine{.plateau = 2e-30,
                                                            .rolloff_wavevector = 2.0 * pi / 400e-9,
                                                            .hurst_exponent = 0.8,
                                                            .short_wavevector = 2.0 * pi / shortest});
    const double size = static_cast<double>(fine) * pixel;
    for (std::uint64_t seed = first_seed; seed < first_seed + 3; ++seed) {
        const auto heights = synthesis::random_surface(C_iso, {fine, fine, size, size}, {.key = {seed, 1}}).heights;
        std::string text;
        for (Index j = 0; j < points; ++j)
            for (Index i = 0; i < points; ++i)
                text += fmt::format("{:.9g}{}", 1e9 * heights(i, j), i + 1 < points ? ' ' : '\n');
        MeasurementInput input;
        input.file = folder.write(fmt::format("{}{}.txt", name, seed), text);
        input.instrument = "afm";
        input.unit = "nm";
        input.size = std::vector<double>{points * pixel, points * pixel};
        surface.measurements.push_back(input);
    }
    return surface;
}

SurfaceAnalysisOptions options(SpectrumMethod method) {
    SurfaceAnalysisOptions options;
    options.spectrum = method;
    options.bootstrap_resamples = 40;
    options.likelihood.shortest_wavelength = 0.7 * shortest;  // beyond Nyquist: lengths can move
    options.likelihood.tip_points = options.likelihood.tip_length = 512;
    return options;
}

const SpectrumResult& of(const SurfaceResult& surface, SpectrumMethod method) {
    return method == SpectrumMethod::average ? surface.average : *surface.likelihood;
}

using Change = std::function<void(MeasurementInput&)>;
SurfaceResult analysed(SurfaceInput input, SpectrumMethod method, const Change& change) {
    for (auto& m : input.measurements) change(m);
    auto result = analyse_surface(input, options(method), {2});
    EXPECT_EQ(result.error + result.likelihood_error, "");
    return result;
}

Change calibrated(double heights, double lengths, double relative_error = 0.0) {
    return [=](MeasurementInput& m) {
        m.height_calibration = Estimate{.value = heights, .standard_error = relative_error * heights, .input = "z"};
        m.lateral_calibration = Estimate{.value = lengths, .standard_error = relative_error * lengths, .input = "x"};
    };
}

const roughness::ParameterSpread::Source& source(const SpectrumResult& result, const std::string& name) {
    for (const auto& s : result.spread.sources)
        if (s.name == name) return s;
    throw InvalidArgument("no source " + name);
}

double response(const SpectrumResult& result, const std::string& name, const Function& f) {
    const auto& s = source(result, name);
    return 0.5 * (f(s.plus) - f(s.minus));
}

/// ∂f/∂ ln(factor) by the sources and by analyses of data that are a little higher or longer.
class Calibration : public testing::TestWithParam<SpectrumMethod> {
protected:
    void compare(double tolerance_of_heights, double tolerance_of_lengths) const {
        constexpr double step = error;
        const auto stated = analysed(input_, GetParam(), calibrated(1.0, 1.0, error));
        const auto higher = analysed(input_, GetParam(), calibrated(1.0 + step, 1.0)),
                   lower = analysed(input_, GetParam(), calibrated(1.0 - step, 1.0)),
                   longer = analysed(input_, GetParam(), calibrated(1.0, 1.0 + step)),
                   shorter = analysed(input_, GetParam(), calibrated(1.0, 1.0 - step));
        for (const auto& f : {h_rms, slope, energy, area}) {
            const auto value = [&](const SurfaceResult& s) { return f(of(s, GetParam()).parameters); };
            const double scale = &f == &area ? value(stated) - 1.0 : value(stated);
            EXPECT_NEAR(response(of(stated, GetParam()), "z", f) / error / scale,
                        (value(higher) - value(lower)) / (2.0 * step) / scale, tolerance_of_heights);
            EXPECT_NEAR(response(of(stated, GetParam()), "x", f) / error / scale,
                        (value(longer) - value(shorter)) / (2.0 * step) / scale, tolerance_of_lengths);
        }
    }
    /// h ∝ k_z, h' ∝ k_z/k_x, U ∝ k_z²/k_x.
    void obeys_scaling(double tolerance) const {
        const auto result = analysed(input_, GetParam(), calibrated(1.0, 1.0, error));
        const auto& spectrum = of(result, GetParam());
        const auto power = [&](const char* input, const Function& f) {
            return response(spectrum, input, f) / (error * f(spectrum.parameters));
        };
        EXPECT_NEAR(power("z", h_rms), 1.0, 1e-4);
        EXPECT_NEAR(power("z", slope), 1.0, 1e-4);
        EXPECT_NEAR(power("z", energy), 2.0, 2e-4);
        EXPECT_NEAR(power("x", h_rms), 0.0, tolerance);
        EXPECT_NEAR(power("x", slope), -1.0, tolerance);
        EXPECT_NEAR(power("x", energy), -1.0, tolerance);
    }

    TemporaryFolder folder_;
    SurfaceInput input_ = maps(folder_, "A", 1);
};

TEST_P(Calibration, ChangesResultsAsScaledDataDo) { compare(1e-4, 1e-3); }
// Bins of an average stay where they are: modes that pass their edges move it in steps.
TEST_P(Calibration, FollowsScalingRelations) { obeys_scaling(GetParam() == SpectrumMethod::average ? 0.1 : 0.01); }
INSTANTIATE_TEST_SUITE_P(BothMethods, Calibration,
                         testing::Values(SpectrumMethod::average, SpectrumMethod::likelihood));

Change with_tip(double radius, double standard_error, const std::string& name) {
    return [=](MeasurementInput& m) {
        m.tip_radius = Estimate{.value = radius, .standard_error = standard_error, .input = name};
    };
}

double covariance_by_sources(const SpectrumResult& a, const SpectrumResult& b, const Function& f) {
    double sum = 0.0;
    for (const auto& s : a.spread.sources)
        for (const auto& t : b.spread.sources)
            if (s.name == t.name) sum += 0.25 * (f(s.plus) - f(s.minus)) * (f(t.plus) - f(t.minus));
    return sum;
}

TEST(NamedTip, CorrelatesSurfaces) {
    const TemporaryFolder folder;
    const auto first = maps(folder, "A", 1), second = maps(folder, "B", 11);
    for (const auto method : {SpectrumMethod::average, SpectrumMethod::likelihood}) {
        const auto a = analysed(first, method, with_tip(50e-9, 5e-9, "the tip")),
                   b = analysed(second, method, with_tip(50e-9, 5e-9, "the tip"));
        const double product = response(of(a, method), "the tip", slope) * response(of(b, method), "the tip", slope);
        EXPECT_GT(product, 0.0);
        EXPECT_DOUBLE_EQ(covariance_by_sources(of(a, method), of(b, method), slope), product);
    }
}

TEST(UnnamedTip, IsIndependentPerSurface) {
    const TemporaryFolder folder;
    const auto first = maps(folder, "A", 1), second = maps(folder, "B", 11);
    for (const auto method : {SpectrumMethod::average, SpectrumMethod::likelihood}) {
        const auto a = analysed(first, method, with_tip(50e-9, 5e-9, "")),
                   b = analysed(second, method, with_tip(50e-9, 5e-9, ""));
        ASSERT_EQ(of(a, method).spread.sources.size(), 1u);
        EXPECT_EQ(of(a, method).spread.sources[0].name, "tip radius of afm (50.0 nm), A");
        EXPECT_EQ(covariance_by_sources(of(a, method), of(b, method), slope), 0.0);
        // what the tip does is in the standard error, once
        auto without = of(a, method).spread;
        without.sources.clear();
        EXPECT_NEAR(of(a, method).spread.covariance(slope, slope),
                    without.covariance(slope, slope) +
                        std::pow(response(of(a, method), "tip radius of afm (50.0 nm), A", slope), 2),
                    1e-12);
    }
}

TEST(MeasurementCalibration, MultipliesItsData) {
    const TemporaryFolder folder;
    auto input = maps(folder, "A", 1);
    const auto plain = measurement_sources(input.measurements[0]).front().prepare();
    calibrated(1.1, 0.8)(input.measurements[0]);
    const auto source = measurement_sources(input.measurements[0]).front();
    const auto scaled = source.prepare();
    const auto &before = std::get<topography::HeightMap>(plain.measurement),
               &after = std::get<topography::HeightMap>(scaled.measurement);
    EXPECT_LT((after.heights - 1.1 * before.heights).abs().maxCoeff(), 1e-12 * before.heights.abs().maxCoeff());
    EXPECT_DOUBLE_EQ(after.size[0], 0.8 * before.size[0]);
    EXPECT_DOUBLE_EQ(after.size[1], 0.8 * before.size[1]);
}

TEST(MeasurementCalibration, MustBePositive) {
    const TemporaryFolder folder;
    auto input = maps(folder, "A", 1);
    input.measurements[0].height_calibration = Estimate{0.0, 0.1};
    const auto result = analyse_surface(input, options(SpectrumMethod::average), {1});
    EXPECT_NE(result.measurements[0].error.find("height_calibration 0, expected"), std::string::npos)
        << result.measurements[0].error;
}

/// A container of one map of an AFM that states its tip and the calibration of its heights.
std::string container_of(const TemporaryFolder& folder, const std::string& tip, const std::string& heights) {
    formats::ContainerTopography map;
    map.name = "map";
    map.datafile.original = "a.txt";
    map.size = {2.0, 2.0};
    map.unit = "um";
    map.instrument.emplace().name = "Dimension V";
    map.instrument->parameters.emplace().tip_radius = formats::ContainerLength{.text = tip};
    map.instrument->parameters->height_calibration = heights;
    formats::ContainerSurface surface;
    surface.name = "A";
    surface.topographies = {map};
    formats::Container container;
    container.surfaces = {surface};
    auto path = folder.path("set.zip");
    formats::write_container(path, container, {{"a.txt", [] { return bytes::memory_source("a.txt", "1 2\n3 4\n"); }}});
    return path;
}

TEST(InstrumentInputs, AreReadFromContainers) {
    const TemporaryFolder folder;
    MeasurementInput input;
    input.file = container_of(folder, "10 ± 2 nm", "1.00 ± 0.02");
    const auto prepared = measurement_sources(input).front().prepare();
    const auto& instrument = topography::metadata(prepared.measurement).instrument;
    EXPECT_DOUBLE_EQ(instrument.tip_radius.value(), 1e-8);
    EXPECT_DOUBLE_EQ(instrument.tip_radius_standard_error.value(), 2e-9);
    EXPECT_EQ(prepared.inputs.tip_radius, "tip radius of Dimension V in set.zip (10.0 nm)");
    EXPECT_EQ(prepared.inputs.height_calibration.input, "height calibration of Dimension V in set.zip");
    EXPECT_DOUBLE_EQ(prepared.inputs.height_calibration.standard_error, 0.02);
    EXPECT_FALSE(prepared.inputs.lateral_calibration.uncertain());
    // the statement of the study comes first
    input.tip_radius = Estimate{.value = 2e-8, .standard_error = 1e-9, .input = "mine"};
    input.height_calibration = Estimate{.value = 1.1, .standard_error = 0.01, .input = "scale"};
    const auto told = measurement_sources(input).front().prepare();
    EXPECT_EQ(told.inputs.tip_radius, "mine");
    EXPECT_EQ(told.inputs.height_calibration.input, "scale");
}

TEST(InstrumentInputs, OfInvalidContainersAreReportedWithFileAndField) {
    const TemporaryFolder folder;
    const auto message = [&](const std::string& tip, const std::string& heights) -> std::string {
        MeasurementInput input;
        input.file = container_of(folder, tip, heights);
        try {
            (void)measurement_sources(input).front().prepare();
        } catch (const FormatError& failure) {
            return failure.what();
        }
        return "nothing";
    };
    EXPECT_NE(message("10 ± 2 nm", "1 ± -0.1").find("index.json:"), std::string::npos);
    for (const auto* tip : {"10 ± 20 nm", "10 ± -1 nm", "10 ± 2", "-10 nm"}) {
        const auto said = message(tip, "");
        EXPECT_NE(said.find("set.zip: index.json:"), std::string::npos) << said;
        EXPECT_NE(said.find(": tip_radius: "), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
}

TEST(InstrumentInputs, AreNamedInStudyFiles) {
    const TemporaryFolder folder;
    folder.write("a.txt", "1 2\n3 4\n");
    const auto path = folder.write(
        "study.toml",
        "[inputs]\nscale = \"1.00 ± 0.02\"\n[rough_solid]\nyoungs_modulus = \"1 GPa\"\npoisson_ratio = 0.1\n"
        "[surfaces.A]\nmeasurements = [{ file = \"a.txt\", height_calibration = \"scale\", "
        "lateral_calibration = \"1.01 ± 0.01\", tip_radius = \"10 ± 1 nm\" }]\n");
    const auto study = read_study(path);
    const auto& m = study.surfaces[0].measurements[0];
    EXPECT_EQ(m.height_calibration->input, "scale");
    EXPECT_DOUBLE_EQ(m.height_calibration->standard_error, 0.02);
    EXPECT_EQ(m.lateral_calibration->input, "");
    EXPECT_EQ(m.tip_radius->input, "");
}

}  // namespace
}  // namespace setae::study::instrument_inputs_test
