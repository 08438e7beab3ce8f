// SPDX-License-Identifier: GPL-3.0-or-later
#include "surfaces/line_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::simulation::line_spectrum_test {
namespace {

constexpr spectra::SelfAffine model{
    .plateau = 1e-29, .rolloff_wavevector = 6e6, .hurst_exponent = 0.8, .short_wavevector = 1.5e10};

KnownSurface stretched(double stretch, double angle) {
    return {.C_iso = spectra::density(model),
            .rolloff_wavelength = 2.0 * pi / model.rolloff_wavevector,
            .short_wavelength = 2.0 * pi / model.short_wavevector,
            .anisotropy = {stretch, angle}};
}

TEST(LineSpectrum, IsTheAbelIntegralUpToItsUpperEnd) {
    const LineSpectrum C1D(stretched(1.0, 0.0));
    Array1D q(9);
    q << 1e3, 1e6, 5e6, 7e6, 1e8, 1e10, 1.4e10, 1.49e10, 1.4999e10;
    const Array1D exact = spectra::profile_power_spectrum(model, q);
    for (Index i = 0; i < q.size(); ++i) EXPECT_NEAR(C1D(q[i]) / exact[i], 1.0, 4e-4) << q[i];
    EXPECT_EQ(C1D(1.5e10), 0.0);
}

TEST(LineSpectrum, OfAnAnisotropicSurfaceIsTheIntegralOfItsSpectrumAcrossX) {
    constexpr double stretch = 1.7, angle = 0.6;
    const LineSpectrum C1D(stretched(stretch, angle));
    const auto C_iso = spectra::density(model);
    for (const double qx : {1e6, 1e8, 5e9}) {
        // ∫ C2D(qx, qy) dqy/2π over both sides, midpoints in ln |qy|
        double sum = 0.0;
        constexpr double step = 1e-3;
        for (const double side : {-1.0, 1.0})
            for (double t = std::log(1e-5 * qx); t < std::log(2e10); t += step) {
                const double qy = side * std::exp(t + 0.5 * step), along = qx * std::cos(angle) + qy * std::sin(angle);
                const double across = qy * std::cos(angle) - qx * std::sin(angle);
                sum += stretch * C_iso(std::hypot(stretch * along, across)) * std::abs(qy) * step;
            }
        EXPECT_NEAR(C1D(qx) / (sum / (2.0 * pi)), 1.0, 2e-3) << qx;
    }
}

TEST(TrueSurfaceValues, OfAnAnisotropicSurfaceMatchTheSumOverItsModes) {
    constexpr spectra::SelfAffine small{
        .plateau = 1e-27, .rolloff_wavevector = 2e8, .hurst_exponent = 0.8, .short_wavevector = 3e9};
    const KnownSurface surface{.C_iso = spectra::density(small),
                               .rolloff_wavelength = 2.0 * pi / small.rolloff_wavevector,
                               .short_wavelength = 2.0 * pi / small.short_wavevector,
                               .anisotropy = {2.0, 0.4}};
    const auto truth = true_surface_values(surface).parameters;
    const auto modes =
        synthesis::expected_roughness(surface.C_iso, {1024, 1024, 1e-6, 1e-6}, {.anisotropy = surface.anisotropy});
    EXPECT_NEAR(truth.rms_height / modes.rms_height, 1.0, 2e-3);  // a mode's cell is 1/30 of the roll-off's wavevector
    EXPECT_NEAR(truth.rms_slope / modes.rms_slope, 1.0, 2e-3);
    // shallow slopes: A/A0 = 1 + h'²/2 whatever their directions, next order h'⁴
    KnownSurface shallow = surface;
    shallow.C_iso = [inner = surface.C_iso](double q) { return 1e-4 * inner(q); };
    const auto flat = true_surface_values(shallow);
    EXPECT_NEAR((flat.area_ratio - 1.0) / (0.5 * std::pow(flat.parameters.rms_slope, 2)), 1.0,
                2.0 * std::pow(flat.parameters.rms_slope, 2));
}

TEST(TrueSurfaceValues, IntegrateOnlyTheWavesOfABand) {
    const KnownSurface surface = stretched(1.0, 0.0);
    const auto whole = true_surface_values(surface).parameters,
               band = true_surface_values(surface, {3e6, 1.5e10}).parameters;
    // below the roll-off C_iso is flat: h² loses C0 q²/4π
    EXPECT_NEAR(std::pow(whole.rms_height, 2) - std::pow(band.rms_height, 2), model.plateau * 9e12 / (4.0 * pi),
                1e-5 * std::pow(whole.rms_height, 2));
    EXPECT_LT(band.elastic_energy_per_modulus, whole.elastic_energy_per_modulus);
    const auto upper = true_surface_values(surface, {3e6, 1e9}), lower = true_surface_values(surface, {1e9, 1.5e10});
    EXPECT_NEAR(std::hypot(upper.parameters.rms_slope, lower.parameters.rms_slope) / band.rms_slope, 1.0, 1e-6);
    EXPECT_THROW((void)true_surface_values(surface, {2e9, 1e9}), InvalidArgument);
    KnownSurface skewed = surface;
    skewed.skewness = 0.5;
    EXPECT_THROW((void)true_surface_values(skewed, {1e8, 1.5e10}), InvalidArgument);
    EXPECT_LT(true_surface_values(skewed, {3e6, 1.5e10}).parameters.rms_height,
              true_surface_values(skewed).parameters.rms_height);
}

}  // namespace
}  // namespace setae::simulation::line_spectrum_test
