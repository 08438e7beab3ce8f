// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/unmeasured_waves.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "setae/spectra/self_affine.hpp"
#include "setae/spectra/spectral_density.hpp"

namespace setae::adhesion::unmeasured_waves_test {
namespace {

constexpr double W_int = 0.037;

/// A self-affine surface of waves from 5 µm to 5 nm, seen between two wavelengths.
spectra::Spectrum seen(double longest, double shortest) {
    const spectra::SelfAffine model{.plateau = 1e-25,
                                    .rolloff_wavevector = 2.0 * pi / 5e-6,
                                    .hurst_exponent = 0.8,
                                    .short_wavevector = 2.0 * pi / 4e-9};
    spectra::Spectrum found;
    found.kind = spectra::Density::C_iso;
    found.wavevector = Array1D::LinSpaced(300, std::log(2.0 * pi / longest), std::log(2.0 * pi / shortest)).exp();
    found.density = found.wavevector.unaryExpr(spectra::density(model));
    found.band = {found.wavevector[0], found.wavevector[299]};
    return found;
}

SoftSide soft() { return {"soft", 1e6, 0.025}; }

double work_of(const roughness::SpectralParameters& parameters) {
    return modified_balance(W_int, 0.025, {parameters.area_ratio(), 1e6 * parameters.elastic_energy_per_modulus}).raw;
}

TEST(UnmeasuredWaves, RecoverTheWorkOfTheWholePowerLaw) {
    const double longest = 4.99e-6, shortest = 5e-9;
    const auto part = seen(1e-6, 1e-7), whole = seen(longest, shortest);
    const auto within = roughness::spectral_parameters(part);
    const std::optional shorter = roughness::beyond_data(part, 2.0 * pi / shortest),
                        longer = roughness::beyond_data(part, 2.0 * pi / longest);
    const roughness::ParameterSpread spread;
    const RoughSide rough{"A", within, spread};
    const auto found = work_with_unmeasured_waves(rough, soft(), W_int, {within, shorter, longer});
    ASSERT_TRUE(found);
    const double truth = work_of(roughness::spectral_parameters(whole));
    EXPECT_NEAR(found->value, truth, 1e-4 * truth);
    EXPECT_GT(std::abs(work_of(within) - truth), 0.02 * truth) << "what the band alone gives is another number";
    EXPECT_LT(found->interval->lower, truth);
    EXPECT_GT(found->interval->upper, truth);
}

TEST(UnmeasuredWaves, AreEmptyWithoutKnownLimits) {
    const auto within = roughness::spectral_parameters(seen(1e-6, 1e-7));
    const roughness::ParameterSpread spread;
    EXPECT_FALSE(work_with_unmeasured_waves({"A", within, spread}, soft(), W_int, {within, {}, {}}));
}

}  // namespace
}  // namespace setae::adhesion::unmeasured_waves_test
