// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/beyond_data.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::roughness::beyond_data_test {
namespace {

using spectra::Spectrum;

/// A self-affine surface to 4 Å, known only to a longer wavelength.
spectra::Spectrum curve(double shortest) {
    const spectra::SelfAffine model{.plateau = 5e-27,
                                    .rolloff_wavevector = 2.0 * pi / 0.3e-6,
                                    .hurst_exponent = 0.8,
                                    .short_wavevector = 2.0 * pi / 4e-10};
    spectra::Spectrum found;
    found.kind = spectra::Density::C_iso;
    found.wavevector = Array1D::LinSpaced(400, std::log(1e5), std::log(2.0 * pi / shortest)).exp();
    found.wavevector[399] = 2.0 * pi / shortest * (1.0 - 1e-12);
    found.density = found.wavevector.unaryExpr(spectra::density(model));
    found.band = {1e5, found.wavevector[399]};
    return found;
}

TEST(BeyondData, RecoversTheExcludedPartOfAPowerLaw) {
    const auto whole = spectral_parameters(curve(4e-10));
    for (const double shortest : {8e-10, 5e-9}) {
        const auto found = beyond_data(curve(shortest), 2.0 * pi / 4e-10);
        EXPECT_NEAR(found.exponent.value, -3.6, 1e-6);
        EXPECT_NEAR(found.rms_slope.value / whole.rms_slope, 1.0, 1e-5);
        EXPECT_NEAR(found.elastic_energy_per_modulus.value / whole.elastic_energy_per_modulus, 1.0,
                    3e-4);  // nodes about the kink of the roll-off differ
        EXPECT_NEAR(found.excess_area.value / (gaussian_area_ratio(whole.rms_slope) - 1.0), 1.0, 1e-5);
        EXPECT_LT(found.rms_slope.interval->lower, found.rms_slope.value);
        EXPECT_GT(found.rms_slope.interval->upper, found.rms_slope.value);
    }
    // the extrapolation is less certain with distance
    const auto near = beyond_data(curve(8e-10), 2.0 * pi / 4e-10), far = beyond_data(curve(5e-9), 2.0 * pi / 4e-10);
    EXPECT_GT(far.rms_slope.standard_error, 3.0 * near.rms_slope.standard_error);
}

// C1D = q⁻³ is that of C_iso = 4 q⁻⁴.
TEST(BeyondData, OfLinesMatchesTheClosedForm) {
    spectra::Spectrum line;
    line.kind = spectra::Density::C1D;
    line.wavevector = Array1D::LinSpaced(100, std::log(1e6), std::log(1e8)).exp();
    line.density = line.wavevector.pow(-3.0);
    line.band = {line.wavevector[0], line.wavevector[99]};
    const auto found = beyond_data(line, 1e9);
    EXPECT_NEAR(found.exponent.value, -4.0, 1e-9);
    EXPECT_NEAR(found.rms_slope.value, std::sqrt(2.0 / pi * std::log(1e3)), 1e-6);
    EXPECT_NEAR(found.elastic_energy_per_modulus.value, (1e-6 - 1e-9) / (2.0 * pi), 1e-12);
    EXPECT_THROW((void)beyond_data(line, 1e7), InvalidArgument);
}

/// A roll-off at 5 µm, beyond a map of 1 µm.
TEST(BeyondData, RecoversExcludedLongWavesOfAPowerLaw) {
    const spectra::SelfAffine model{.plateau = 5e-27,
                                    .rolloff_wavevector = 2.0 * pi / 5e-6,
                                    .hurst_exponent = 0.8,
                                    .short_wavevector = 2.0 * pi / 1e-8};
    const auto between = [&](double longest) {
        Spectrum found;
        found.kind = spectra::Density::C_iso;
        found.wavevector = Array1D::LinSpaced(300, std::log(2.0 * pi / longest), std::log(2.0 * pi / 1e-8)).exp();
        found.density = found.wavevector.unaryExpr(spectra::density(model));
        found.band = {found.wavevector[0], found.wavevector[299]};
        return found;
    };
    const auto whole = spectral_parameters(between(4.99e-6));
    const auto found = beyond_data(between(1e-6), 2.0 * pi / 4.99e-6);
    EXPECT_NEAR(found.rms_height.value / whole.rms_height, 1.0, 1e-4);
    EXPECT_NEAR(found.elastic_energy_per_modulus.value / whole.elastic_energy_per_modulus, 1.0, 1e-4);
    EXPECT_LT(found.rms_height.interval->lower, found.rms_height.value);
    EXPECT_GT(found.rms_height.interval->upper, found.rms_height.value);
    // if the roll-off is visible, longer waves add little
    const auto flat = between(1e-4);
    const auto more = beyond_data(flat, 2.0 * pi / 1e-3);
    EXPECT_LT(more.rms_height.value / spectral_parameters(flat).rms_height, 1.001);
    EXPECT_THROW((void)beyond_data(flat, 2.0 * pi / 1e-5), InvalidArgument);
}

/// Lines by the Abel integral; modes are averaged before.
TEST(BeyondData, LongWavesOfLinesFollowTheAbelIntegral) {
    const double q0 = 1e6, q1 = 1e9;
    Spectrum lines;
    lines.kind = spectra::Density::C1D;
    lines.wavevector = Array1D::LinSpaced(300, std::log(q0), std::log(q1)).exp();
    lines.density = lines.wavevector.pow(-3.0);
    lines.band = {lines.wavevector[0], lines.wavevector[299]};
    const auto found = beyond_data(lines, 0.1 * q0);
    EXPECT_NEAR(found.exponent.value, -4.0, 1e-9);
    // C_iso = 4 q⁻⁴: h² = (1/π) (1/a² − 1/b²)
    EXPECT_NEAR(found.rms_height.value, std::sqrt(1.0 / pi / (0.01 * q0 * q0)), 1e-3 * found.rms_height.value);
    // if C1D does not decrease there are almost no longer waves
    auto flat = lines;
    flat.density = Array1D::Constant(300, 1e-24);
    EXPECT_EQ(beyond_data(flat, 0.1 * q0).rms_height.value, spectral_parameters(flat).rms_height);
    auto modes = lines;
    modes.nodes = spectra::Nodes::modes;
    modes.wavevector = Array1D::LinSpaced(1000, q0, q1);
    modes.density = modes.wavevector.pow(-3.0);
    const auto of_modes = beyond_data(modes, 1e10);
    EXPECT_NEAR(of_modes.exponent.value, -4.0, 0.02);
}

}  // namespace
}  // namespace setae::roughness::beyond_data_test
