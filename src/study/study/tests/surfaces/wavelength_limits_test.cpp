// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of all integrals that are known to a ±: one input of every surface.
#include <gtest/gtest.h>

#include <cmath>

#include "sample_files.hpp"
#include "setae/core/constants.hpp"
#include "setae/study/study.hpp"
#include "setae/study/study_result.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::study::wavelength_limits_test {
namespace {

using roughness::SpectralParameters;
using Function = roughness::ParameterSpread::Function;

constexpr double hurst = 0.8, first = 1e6, end = 1e9;  // of C_iso = q^(−2 − 2H) [1/m]

/// A spectrum of one power law as its own curve.
spectra::Spectrum power_law() {
    const Array1D q = Array1D::LinSpaced(301, std::log(first), std::log(end)).exp();
    return {q, q.pow(-2.0 - 2.0 * hurst), {first, end}, spectra::Density::C_iso};
}

SurfaceAnalysisOptions cut_at(double wavelength, double standard_error, const std::string& name = {}) {
    SurfaceAnalysisOptions options;
    options.shortest_wavelength = Estimate{.value = wavelength, .standard_error = standard_error, .input = name};
    return options;
}

const Function slope_square = [](const SpectralParameters& p) { return p.rms_slope * p.rms_slope; };
const Function energy = [](const SpectralParameters& p) { return p.elastic_energy_per_modulus; };

// ∂ ln ∫ q^n C_iso dq/∂ ln λ_s = −q_s^(n+1) C_iso(q_s)/∫ q^n C_iso dq = −(n − 1 − 2H)/(1 − (q_0/q_s)^(n − 1 − 2H))
TEST(ShortestWavelength, DerivativesMatchTheIntegralLimit) {
    constexpr double relative = 1e-3, cut = 2.0 * pi / 3e8;
    const auto result = spectrum_result(power_law(), cut_at(cut, relative * cut));
    const auto expected = [&](double order) {
        const double power = order - 1.0 - 2.0 * hurst;
        return -power / (1.0 - std::pow(first / 3e8, power));
    };
    const auto found = [&](const Function& f) {
        const auto& source = result.spread.sources.at(0);
        return 0.5 * (f(source.plus) - f(source.minus)) / (relative * f(result.parameters));
    };
    ASSERT_EQ(result.spread.sources.size(), 1u);
    EXPECT_EQ(result.spread.sources[0].name, "shortest wavelength");
    EXPECT_NEAR(found(slope_square), expected(3.0), 1e-4);
    EXPECT_NEAR(found(energy), expected(2.0), 1e-4);
    const Function slope = [](const SpectralParameters& p) { return p.rms_slope; };
    EXPECT_NEAR(result.estimate(slope).standard_error / result.parameters.rms_slope,
                0.5 * relative * std::abs(expected(3.0)), 1e-6);
}

TEST(ShortestWavelength, BeyondTheDataHasNoEffect) {
    const double cut = 2.0 * pi / (3.0 * end);
    EXPECT_TRUE(spectrum_result(power_law(), cut_at(cut, 0.1 * cut)).spread.sources.empty());
}

TEST(ShortestWavelength, WithoutErrorIsNotASourceOfError) {
    EXPECT_TRUE(spectrum_result(power_law(), cut_at(2.0 * pi / 3e8, 0.0)).spread.sources.empty());
}

constexpr const char* two_surfaces = R"(title = "a cut known to a tenth"
[analysis]
shortest_wavelength = "cut"
[inputs]
cut = "2 ± 0.2 nm"
[rough_solid]
youngs_modulus = "600 GPa"
poisson_ratio = 0.2
[surfaces.A]
moments = { rms_height = "4.6 nm", rms_slope = 0.39, rms_curvature = "1.13 1/nm", short_wavevector = "1.6e10 1/m" }
[surfaces.B]
moments = { rms_height = "122 nm", rms_slope = 1.15, rms_curvature = "3.19 1/nm", short_wavevector = "1.6e10 1/m" }
)";

// Both surfaces lose the same waves: their slopes are wrong together.
TEST(ShortestWavelength, IsACommonInputOfAllSurfaces) {
    const setae::tests::TemporaryFolder folder;
    const auto result = run_study(read_study(folder.write("mine.toml", two_surfaces)));
    for (const auto& surface : result.surfaces) {
        ASSERT_EQ(surface.error, "");
        ASSERT_EQ(surface.average.spread.sources.size(), 1u);
        EXPECT_EQ(surface.average.spread.sources[0].name, "cut");
        EXPECT_LT(slope_square(surface.average.spread.sources[0].plus),
                  slope_square(surface.average.spread.sources[0].minus));
    }
}

// A reconstruction keeps its moments where its own end moves: what lies between them moves.
TEST(ShortWavevectorOfMoments, IsAnInputOfReconstructedQuantities) {
    const setae::tests::TemporaryFolder folder;
    std::string text = two_surfaces;
    text.erase(text.find("shortest_wavelength"), std::string("shortest_wavelength = \"cut\"\n").size());
    text.replace(text.find("1.6e10"), 6, "1.6e10 ± 1e9");
    text.erase(text.find("[inputs]"), std::string("[inputs]\ncut = \"2 ± 0.2 nm\"\n").size());
    const auto result = run_study(read_study(folder.write("mine.toml", text)));
    const auto& spread = result.surfaces[0].average.spread;
    ASSERT_EQ(spread.sources.size(), 1u);
    EXPECT_EQ(spread.sources[0].name, "surfaces.A.moments.short_wavevector");
    EXPECT_NEAR(slope_square(spread.sources[0].plus) / slope_square(spread.sources[0].minus), 1.0, 1e-3);
    EXPECT_GT(std::abs(energy(spread.sources[0].plus) / energy(spread.sources[0].minus) - 1.0), 0.01);
    EXPECT_TRUE(result.surfaces[1].average.spread.sources.empty());
}

}  // namespace
}  // namespace setae::study::wavelength_limits_test
