// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/spectral_moments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/spectra/self_affine.hpp"

namespace setae::roughness::spectral_moments_test {
namespace {

const spectra::SelfAffine model{5.000e-27, 2.0 * pi / 2e-6, 0.8, 2.0 * pi / 72.2e-9};

Array1D log_spaced(double lower, double upper, Index n) {
    return Array1D::LinSpaced(n, std::log(lower), std::log(upper)).exp();
}

/// C_iso of the model is a power law on either side of its roll-off, so two nodes per side represent it exactly.
spectra::Spectrum isotropic_curve() {
    Array1D q(3);
    q << 2.0 * pi, model.rolloff_wavevector, model.short_wavevector;
    return {q, spectra::isotropic_power_spectrum(model, q), {q[0], q[2]}, spectra::Density::C_iso};
}

/// C1D falls to zero at q_s like a square root: nodes crowd there.
spectra::Spectrum profile_curve() {
    const double q_s = model.short_wavevector;
    const Array1D coarse = log_spaced(2.0 * pi / 1e-2, 0.9 * q_s, 4000);
    const Array1D fine = q_s * (1.0 - log_spaced(1e-9, 0.0999, 4000).reverse());
    Array1D q(8000);
    q << coarse, fine;
    return {q, spectra::profile_power_spectrum(model, q), {q[0], q_s}, spectra::Density::C1D};
}

TEST(SpectralParameters, OfTheLaterNcdModelMatchPublishedValues) {
    // THEORY §11, self-affine NCD model of later work by the authors of [D19]
    const auto p = spectral_parameters(isotropic_curve());
    EXPECT_NEAR(p.rms_height, 93.9e-9, 0.05e-9);
    EXPECT_NEAR(p.rms_slope, 0.7465, 5e-5);
    EXPECT_NEAR(p.rms_curvature, 15.19e6, 0.005e6);
    EXPECT_NEAR(4.0 * p.elastic_energy_per_modulus, 4.374e-8, 5e-12);
}

TEST(SpectralParameters, FromLineScansEqualThoseOfTheSurface) {
    const auto from_lines = spectral_parameters(profile_curve()), from_surface = spectral_parameters(isotropic_curve());
    EXPECT_NEAR(from_lines.rms_height / from_surface.rms_height, 1.0, 2e-4);  // lines start at 1 cm
    EXPECT_NEAR(from_lines.elastic_energy_per_modulus / from_surface.elastic_energy_per_modulus, 1.0, 2e-5);
    EXPECT_NEAR(from_lines.rms_slope / from_surface.rms_slope, 1.0, 2e-5);
    EXPECT_NEAR(from_lines.rms_curvature / from_surface.rms_curvature, 1.0, 2e-5);
}

TEST(SpectralParameters, IntegrateAPowerLawInClosedForm) {
    Array1D q(2);
    q << 1e6, 1e9;
    const spectra::Spectrum curve{q, 1e-20 * (q / 1e6).pow(-2.0), {1e6, 1e9}};
    const auto p = spectral_parameters(curve);
    // C1D ∝ q^−α: C_iso = (2/√π) Γ((α + 1)/2)/Γ(α/2) π C1D/q, the factor 1 for α = 2
    EXPECT_NEAR(p.rms_height / std::sqrt(1e-20 * 1e6 * (1.0 - 1e-3) / 2.0), 1.0, 1e-8);
    EXPECT_NEAR(p.elastic_energy_per_modulus / (1e-20 * 1e12 * std::log(1e3) / 8.0), 1.0, 1e-8);
}

// For lines with waves to 72 nm, the waves of the surface between two others: result of C_iso. The identities, valid
// only over 0 … ∞, give 3 to 27 % more at the short end and less at the long one.
TEST(SpectralParameters, OfBandLimitedLinesEqualThoseOfTheBandLimitedSurface) {
    for (const Band& band : {Band{1e4, 2e7}, Band{2e6, 8e7}, Band{3e6, 5e7}}) {
        auto lines = profile_curve(), surface = isotropic_curve();
        lines.band = surface.band = band;
        const auto a = spectral_parameters(lines), b = spectral_parameters(surface);
        EXPECT_NEAR(a.rms_height / b.rms_height, 1.0, 5e-4);
        EXPECT_NEAR(a.rms_slope / b.rms_slope, 1.0, 5e-4);
        EXPECT_NEAR(a.rms_curvature / b.rms_curvature, 1.0, 5e-4);
        EXPECT_NEAR(a.elastic_energy_per_modulus / b.elastic_energy_per_modulus, 1.0, 5e-4);
    }
    // known only to 2e7 1/m: the last power law continues
    auto lines = profile_curve(), surface = isotropic_curve();
    const auto known =
        std::upper_bound(lines.wavevector.begin(), lines.wavevector.end(), 2e7) - lines.wavevector.begin();
    const double end = lines.wavevector[known - 1];
    lines.wavevector = Array1D(lines.wavevector.head(known));
    lines.density = Array1D(lines.density.head(known));
    lines.band.upper = surface.band.upper = end;
    const auto a = spectral_parameters(lines), b = spectral_parameters(surface);
    EXPECT_NEAR(a.rms_slope / b.rms_slope, 1.0, 5e-3);
    EXPECT_NEAR(a.rms_curvature / b.rms_curvature, 1.0, 2e-2);
    // as a sum over modes, by the identities only
    lines.nodes = spectra::Nodes::modes;
    EXPECT_GT(spectral_parameters(lines).rms_curvature / b.rms_curvature, 1.1);
}

TEST(SpectralParameters, ContinueTheOuterPowerLawsToTheBand) {
    const Array1D inner = log_spaced(1e6, 1e9, 5), outer = log_spaced(1e5, 1e10, 9);
    const auto law = [](const Array1D& q) -> Array1D { return 1e-20 * (q / 1e6).pow(-2.6); };
    const auto a = spectral_parameters({inner, law(inner), {1e5, 1e10}}),
               b = spectral_parameters({outer, law(outer), {1e5, 1e10}});
    EXPECT_NEAR(a.rms_height / b.rms_height, 1.0, 1e-10);
    EXPECT_NEAR(a.rms_curvature / b.rms_curvature, 1.0, 1e-10);
}

TEST(SpectralParameters, InterpolateOverGaps) {
    Array1D q = log_spaced(1e6, 1e9, 7), c = 1e-20 * (q / 1e6).pow(-2.6);
    const auto whole = spectral_parameters({q, c, {1e6, 1e9}});
    c[2] = undefined;
    c[3] = 0.0;
    EXPECT_NEAR(spectral_parameters({q, c, {1e6, 1e9}}).rms_slope / whole.rms_slope, 1.0, 1e-12);
    c.setConstant(undefined);
    EXPECT_THROW((void)spectral_parameters({q, c, {1e6, 1e9}}), UndefinedDataError);
}

TEST(SpectralParameters, OfModesObeyParseval) {
    // modes q_k = k Δq with the last at the Nyquist wavevector, which counts half: (1/π) Σ g_k C_k Δq
    const Array1D q = Array1D::LinSpaced(8, 1e6, 8e6);
    Array1D c = Array1D::Zero(8);
    c[2] = 3e-21;
    c[7] = 1e-21;
    const spectra::Spectrum curve{q, c, {0.5e6, 8e6}, spectra::Density::C1D, spectra::Nodes::modes};
    const auto p = spectral_parameters(curve);
    EXPECT_NEAR(p.rms_height / std::sqrt((3e-21 + 0.5e-21) * 1e6 / pi), 1.0, 1e-14);
    EXPECT_NEAR(p.rms_slope / std::sqrt(2.0 * (3e-21 * 9e12 + 0.5e-21 * 64e12) * 1e6 / pi), 1.0, 1e-14);
}

// C = c q^−3 between 10^5.5 and 10^8: the mean of ln C over 10^6 … 10^7 is ln C(10^6.5).
TEST(DecadeMeans, AreGeometricMeansOfWholeDecades) {
    Array1D q(3);
    q << std::pow(10.0, 5.5), 3e6, 1e8;
    const spectra::Spectrum curve{q, 1e-3 * q.pow(-3.0), {q[0], q[2]}};
    const auto means = decade_means(curve);
    EXPECT_TRUE(std::isnan(means[1]));
    EXPECT_NEAR(means[2] / (1e-3 * std::pow(10.0, -19.5)), 1.0, 1e-12);
    EXPECT_NEAR(means[3] / (1e-3 * std::pow(10.0, -22.5)), 1.0, 1e-12);
    EXPECT_TRUE(std::isnan(means[4]));
    EXPECT_EQ(spectral_parameters(curve).decade_C1D[2], means[2]);
}

TEST(LimitedSpectrum, CutsBothEndsAndRefusesAnEmptyBand) {
    const auto curve = isotropic_curve();
    const auto cut = limited(curve, {.longest = 100e-6});
    const double energy = spectral_parameters(curve).elastic_energy_per_modulus;
    const double lost = 1.0 - spectral_parameters(cut).elastic_energy_per_modulus / energy;
    // plateau below q_c = 2π/100 µm: C q_c³/(3 · 8π)
    EXPECT_NEAR(lost, 5e-27 * std::pow(2.0 * pi / 1e-4, 3) / (24.0 * pi) / energy, 1e-9);
    EXPECT_THROW((void)limited(curve, {.longest = 1e-9, .shortest = 1e-6}), InvalidArgument);
}

TEST(CumulativeParameters, IncreaseToTheTotal) {
    const auto curve = profile_curve();
    const auto cumulative = cumulative_parameters(curve);
    const auto whole = spectral_parameters(curve);
    const auto last = cumulative.wavevector.size() - 1;
    EXPECT_EQ(cumulative.rms_slope[0], 0.0);
    EXPECT_EQ(cumulative.rms_slope[last], whole.rms_slope);
    EXPECT_EQ(cumulative.elastic_energy_per_modulus[last], whole.elastic_energy_per_modulus);
    EXPECT_TRUE((cumulative.rms_height.tail(last) >= cumulative.rms_height.head(last)).all());
}

}  // namespace
}  // namespace setae::roughness::spectral_moments_test
