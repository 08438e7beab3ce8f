// SPDX-License-Identifier: GPL-3.0-or-later
// Direction and probe that a study states for a measurement reach the spectrum;
// surfaces that are not Gaussian and isotropic are reported.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/study/study.hpp"
#include "setae/study/study_result.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/synthesis/random_surface.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study::directions_and_probes_test {
namespace {

using setae::tests::TemporaryFolder;
constexpr double shortest = 40e-9, pixel = 0.5 * shortest;
constexpr Index fine = 256, points = fine / 2;

Array2D heights(std::uint64_t seed, double stretch = 1.0) {
    const auto C_iso = spectra::density(spectra::SelfAffine{.plateau = 2e-30,
                                                            .rolloff_wavevector = 2.0 * pi / 400e-9,
                                                            .hurst_exponent = 0.8,
                                                            .short_wavevector = 2.0 * pi / shortest});
    const double size = static_cast<double>(fine) * pixel;
    return synthesis::random_surface(C_iso, {fine, fine, size, size},
                                     {.key = {seed, 1}, .anisotropy = {stretch, 0.0}, .threads = {1}})
        .heights;
}

std::string map_file(const TemporaryFolder& folder, std::uint64_t seed, const Array2D& values) {
    std::string text;
    for (Index j = 0; j < points; ++j)
        for (Index i = 0; i < points; ++i)
            text += fmt::format("{:.9g}{}", 1e9 * values(i, j), i + 1 < points ? ' ' : '\n');
    return folder.write(fmt::format("map{}.txt", seed), text);
}

MeasurementInput map_input(const std::string& file) {
    MeasurementInput input;
    input.file = file;
    input.instrument = "afm";
    input.unit = "nm";
    input.size = std::vector<double>{points * pixel, points * pixel};
    return input;
}

SurfaceInput maps(const TemporaryFolder& folder, double stretch, double bend = 0.0) {
    SurfaceInput surface;
    surface.name = "A";
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Array2D h = heights(seed, stretch);
        const double rms = std::sqrt((h - h.mean()).square().mean());
        if (bend > 0.0) h = rms * (bend * (h - h.mean()) / rms).exp();
        surface.measurements.push_back(map_input(map_file(folder, seed, h)));
    }
    return surface;
}

SurfaceAnalysisOptions options() {
    SurfaceAnalysisOptions options;
    options.likelihood.shortest_wavelength = shortest;
    return options;
}

bool has(const std::vector<Alert>& alerts, const std::string& code) {
    return std::any_of(alerts.begin(), alerts.end(), [&](const Alert& alert) { return alert.code == code; });
}

/// ⟨√(1 + s²)⟩ − 1 of Gaussian slopes, `stretch` times as large across as along, over that of equal ones.
double area_shape(double rms_slope, double stretch) {
    const auto excess = [&](double ratio) {
        const double along = rms_slope / std::hypot(1.0, ratio), across = ratio * along;
        constexpr int steps = 400;
        double sum = 0.0, weights = 0.0;
        for (int i = 0; i < steps; ++i)
            for (int j = 0; j < steps; ++j) {
                const double u = 6.0 * (i + 0.5) / steps, v = 6.0 * (j + 0.5) / steps;
                const double weight = std::exp(-0.5 * (u * u + v * v));
                sum += weight * (std::sqrt(1.0 + std::pow(along * u, 2) + std::pow(across * v, 2)) - 1.0);
                weights += weight;
            }
        return sum / weights;
    };
    return excess(stretch) / excess(1.0);
}

TEST(SurfaceOfMaps, WhenAnisotropicHasTheAreaOfItsSlopes) {
    const TemporaryFolder folder;
    const auto surface = analyse_surface(maps(folder, 1.8), options(), {2});
    ASSERT_EQ(surface.error, "");
    EXPECT_TRUE(has(surface.alerts, "STRETCHED"));
    EXPECT_TRUE(has(surface.alerts, "MEASURED_SLOPES"));
    ASSERT_FALSE(surface.fitted->stretch.empty());
    const auto& found = surface.fitted->stretch.front().ratio;
    EXPECT_NEAR(found.value, 1.8, 3.0 * found.standard_error);
    const auto& parameters = surface.used().parameters;
    const double true_shape = area_shape(parameters.rms_slope, 1.8);
    EXPECT_NEAR(parameters.area_shape - 1.0, true_shape - 1.0, 0.25 * (1.0 - true_shape));  // of three maps
    StudyResult result;
    result.surfaces.push_back(surface);
    EXPECT_EQ(output::stretch_table(result).rows.size(), surface.fitted->stretch.size());
}

TEST(SurfaceOfMaps, WhenSkewedHasTheAreaOfItsSlopes) {
    const TemporaryFolder folder;
    const auto surface = analyse_surface(maps(folder, 1.0, 0.4), options(), {2});
    ASSERT_EQ(surface.error, "");
    EXPECT_TRUE(has(surface.alerts, "MEASURED_SLOPES"));
    EXPECT_LT(surface.used().parameters.area_shape, 0.995);
}

TEST(SurfaceOfMaps, WhenGaussianAndIsotropicHasTheAreaOfItsSpectrum) {
    const TemporaryFolder folder;
    const auto surface = analyse_surface(maps(folder, 1.0), options(), {2});
    ASSERT_EQ(surface.error, "");
    EXPECT_FALSE(has(surface.alerts, "STRETCHED"));
    EXPECT_FALSE(has(surface.alerts, "MEASURED_SLOPES"));
    EXPECT_DOUBLE_EQ(surface.used().parameters.area_shape, 1.0);
    EXPECT_TRUE(surface.fitted->stretch.empty());
}

// One wave A cos(qx): ¼ Σ |q||h_q|² over ±q is q A²/8.
TEST(MapOfOneWave, HasTheEnergyOfTheClosedForm) {
    constexpr double amplitude = 2e-9, q = 2.0 * pi / 100e-9;
    topography::HeightMap map{Array2D::Zero(200, 60), {1e-6, 0.3e-6}, true, {}};
    for (Index i = 0; i < 200; ++i) map.heights.row(i) = amplitude * std::cos(q * 5e-9 * static_cast<double>(i));
    const auto result = analyse_measurement({.measurement = map}, {}, {1});
    ASSERT_TRUE(result.waves_energy_per_modulus);
    EXPECT_NEAR(*result.waves_energy_per_modulus / (q * amplitude * amplitude / 8.0), 1.0, 1e-9);
}

/// The message of the one measurement that fails beside two that do not.
std::string failure(const TemporaryFolder& folder, const std::function<void(MeasurementInput&)>& change) {
    auto surface = maps(folder, 1.0);
    change(surface.measurements[1]);
    const auto result = analyse_surface(surface, options(), {2});
    EXPECT_EQ(result.error, "");
    EXPECT_FALSE(result.measurements[0].failed() || result.measurements[2].failed());
    return result.measurements[1].error;
}

TEST(MeasurementInputs, ReportMissingInputOfAProbe) {
    const TemporaryFolder folder;
    const auto says = [](const std::string& error, const std::string& words) {
        return error.find(words) != std::string::npos && error.find("map2.txt") != std::string::npos;
    };
    EXPECT_PRED2(says, failure(folder, [](auto& m) { m.tip_shape = "paraboloid"; }), "needs a tip_radius");
    EXPECT_PRED2(says,
                 failure(folder,
                         [](auto& m) {
                             m.tip_shape = "cone";
                             m.tip_radius = Estimate{.value = 10e-9};
                         }),
                 "needs a tip_half_angle");
    EXPECT_PRED2(says, failure(folder, [](auto& m) { m.numerical_aperture = 0.5; }),
                 "expected numerical_aperture and light_wavelength together");
    EXPECT_PRED2(says,
                 failure(folder,
                         [](auto& m) {
                             m.numerical_aperture = 0.0;
                             m.light_wavelength = 500e-9;
                         }),
                 "expected both > 0");
    EXPECT_NE(failure(folder, [&](auto& m) { m.tip_file = folder.path("none.txt"); }).find("none.txt"),
              std::string::npos);
}

// Foils of 120 nm hide valleys: the same contours give larger heights if the study states the thickness of the foils.
TEST(MeasurementInputs, ThicknessOfAFoilIncreasesTheSpectrumOfContours) {
    const TemporaryFolder folder;
    SurfaceInput surface;
    surface.name = "A";
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        const Array2D h = heights(seed);
        for (Index line = 0; line < 4; ++line) {
            const auto file = folder.path(fmt::format("contour{}_{}.csv", seed, line));
            const Array1D silhouette = h.block(0, line * fine / 4, points, 6).rowwise().maxCoeff();
            tables::write_csv(
                file,
                {{{"x", "m", Array1D::LinSpaced(points, 0.0, (points - 1) * pixel)}, {"z", "m", silhouette}}, {}});
            MeasurementInput input;
            input.file = file;
            input.instrument = "tem";
            surface.measurements.push_back(input);
        }
    }
    const auto height = [&] { return analyse_surface(surface, options(), {2}).used().parameters.rms_height; };
    const double as_lines = height();
    for (auto& m : surface.measurements) m.foil_thickness = Estimate{.value = 120e-9};
    const double as_silhouettes = height();
    EXPECT_GT(as_silhouettes, 1.03 * as_lines);
    EXPECT_LT(as_silhouettes, 1.3 * as_lines);
}

}  // namespace
}  // namespace setae::study::directions_and_probes_test
